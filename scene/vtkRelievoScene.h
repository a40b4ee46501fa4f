// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoScene
 * @brief Makes a renderer of files and options, as `relievo render` does.
 *
 * SetWords() takes files and options in the words of `relievo render`. Update() reads the files and
 * fills GetRenderer(): readers, materials, lights, camera, lamps, fog and the frame around them.
 * After later words it applies only the differences; a file is read again only if options that
 * affect its reading have changed. Write() writes the outputs that the words request.
 *
 * Files: see `relievo --help`. Progress: progress events of 0 to 1, with GetProgressText();
 * SetAbort() ends the work with an error.
 *
 * Errors: a function that fails returns false and invokes one error event, which names the option
 * or the file; GetFailureText() is its text, GetFailure() its kind. The renderer then shows the
 * previous scene or a partly updated one, and another Update() completes it.
 */
#ifndef vtkRelievoScene_h
#define vtkRelievoScene_h

#include "vtkObject.h"
#include "vtkRelievoSceneModule.h" // for the export macro

#include <functional> // for fallible work
#include <memory>     // for private data
#include <string>     // for texts

class vtkImageData;
class vtkRelievoPass;
class vtkRenderer;
class vtkRenderWindow;
class vtkStringArray;

class VTKRELIEVOSCENE_EXPORT vtkRelievoScene : public vtkObject
{
public:
  static vtkRelievoScene* New();
  vtkTypeMacro(vtkRelievoScene, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Files and options, as the words after `relievo render`; outputs may be missing. Invalid words
   * leave the scene unchanged. Default: none.
   */
  bool SetWords(vtkStringArray* words);
  vtkStringArray* GetWords();
  ///@}

  /** All input files named by the words: those shown, and those of options. */
  vtkStringArray* GetInputFiles();

  /**
   * The renderer's window, which keeps its size; set it before Update(). Default: one of the
   * scene's own, off screen, of the size in the words.
   */
  void SetRenderWindow(vtkRenderWindow* window);
  vtkRenderWindow* GetRenderWindow();

  /** Shows the scene as set by the words, and places the camera. */
  bool Update();

  /** Shows the scene as set by the words, and writes the requested outputs: all or none. */
  bool Write();

  ///@{
  /**
   * Rows that Write() draws at a time, with a window of the scene's own: bands of so many rows take
   * less memory than the whole picture. At least 192, in steps of 64. Default: 0, which draws
   * pictures of more than 2^24 pixels in bands, and others whole.
   */
  vtkSetClampMacro(BandRows, int, 0, 16384);
  vtkGetMacro(BandRows, int);
  ///@}

  ///@{
  /**
   * The frames of a sequence that Write() draws, from the first to before the end. After each one's
   * files are in place, FrameEvent is invoked with its number, an int. Write() refuses frames that
   * the sequence does not have, and a part of the frames of `--video`. Default: all.
   */
  vtkSetVector2Macro(Frames, int);
  vtkGetVector2Macro(Frames, int);
  enum Events
  {
    FrameEvent = 1145 // after vtkCommand::UserEvent
  };
  ///@}

  /**
   * Shows the scene as set by the words, and draws the content of `--baseline` into an image:
   * vtkRelievoBaseline, portable or not, with the files' names for objects.
   */
  bool CaptureBaseline(vtkImageData* image, bool portable = false);

  /** The renderer of the scene; reading other files replaces it. Null before Update(). */
  vtkRenderer* GetRenderer();

  /** The frame around VTK's drawing; null if no option needs one. */
  vtkRelievoPass* GetPass();

  /** The up axis, 0, 1, 2 for x, y, z, as found by Update(). */
  int GetUpAxis();

  /** The file of an actor, by its number in vtkRenderer::GetActors(); empty: no file. */
  std::string GetFileOf(int actor);

  ///@{
  /** Notes for the user from the last Update() or Write(): a line each. */
  vtkStringArray* GetNotes();
  vtkStringArray* GetWarnings();
  ///@}

  /** The certificate of the last Write() with `--certify`; empty without one. */
  std::string GetCertificate();

  enum Failures
  {
    NO_FAILURE = 0,
    USAGE_FAILURE = 1, ///< invalid words, in themselves or for the files' contents
    FILE_FAILURE = 2,  ///< a file cannot be read or written
    DRAW_FAILURE = 3   ///< the scene cannot be drawn
  };
  ///@{
  /** Error of the last function that can fail; NO_FAILURE and empty if it succeeded. */
  int GetFailure() { return this->Failure; }
  std::string GetFailureText() { return this->FailureText; }
  ///@}

  /** The current step, such as "reading bunny.off". */
  std::string GetProgressText();

  /** Stops the work in progress; call it from an observer of the progress. */
  void SetAbort() { this->Abort = true; }

  /**
   * Every option of `relievo render`, as JSON: a list of objects with `name`, `value` (its
   * placeholder; empty for a flag), `repeats` and `help`.
   */
  static std::string GetOptions();

protected:
  vtkRelievoScene();
  ~vtkRelievoScene() override;

private:
  vtkRelievoScene(const vtkRelievoScene&) = delete;
  void operator=(const vtkRelievoScene&) = delete;

  // Runs the work and returns whether it succeeded; an exception becomes the error event and the
  // failure.
  bool Try(const std::function<void()>& work);

  int Failure = NO_FAILURE;
  std::string FailureText;
  bool Abort = false;
  int BandRows = 0;
  int Frames[2] = { 0, VTK_INT_MAX };

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
