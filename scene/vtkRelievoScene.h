// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoScene
 * @brief Makes a renderer of files and options, as `relievo render` does.
 *
 * SetWords() takes files and options in the words of `relievo render`. Update() reads the files and
 * fills GetRenderer(): readers, materials, lights, camera, lamps, fog and the frame around them. Of
 * later words it sets only what they say differently; a file is read again if what it is read by
 * has changed. Write() writes the outputs that the words ask for.
 *
 * Files: what `relievo --help` lists. Progress: progress events of 0 to 1, with GetProgressText();
 * SetAbort() ends the work with an error.
 *
 * Errors: a function that fails returns false and invokes one error event, which names the option
 * or the file; GetFailureText() is its text, GetFailure() tells its kind. The renderer then shows
 * what it did, or part of what it was to show, and another Update() mends it.
 */
#ifndef vtkRelievoScene_h
#define vtkRelievoScene_h

#include "vtkObject.h"
#include "vtkRelievoSceneModule.h" // for the export macro

#include <functional> // for work that may fail
#include <memory>     // for what is private
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
   * Files and options, as the words behind `relievo render`; those of outputs may be lacking. Words
   * that are wrong change nothing. Default: none.
   */
  bool SetWords(vtkStringArray* words);
  vtkStringArray* GetWords();
  ///@}

  /** The files that the words name to be read: those shown, and those of options. */
  vtkStringArray* GetInputFiles();

  /**
   * The window that the renderer is in, which keeps its size; set it before Update(). Default:
   * one of the scene's own, off screen, of the size that the words say.
   */
  void SetRenderWindow(vtkRenderWindow* window);
  vtkRenderWindow* GetRenderWindow();

  /** Shows the scene as the words say; the camera is where they put it. */
  bool Update();

  /** Shows the scene as the words say, and writes the outputs they ask for: all or none. */
  bool Write();

  /**
   * Shows the scene as the words say, and draws what `--baseline` writes into an image:
   * vtkRelievoBaseline, with the files' names for objects.
   */
  bool CaptureBaseline(vtkImageData* image);

  /** What shows the scene; it is another one when other files are read. Null before Update(). */
  vtkRenderer* GetRenderer();

  /** The frame around what VTK draws; null where the words ask for nothing that needs one. */
  vtkRelievoPass* GetPass();

  /** The axis that points up, 0, 1, 2 for x, y, z; as found by an Update(). */
  int GetUpAxis();

  /** The file that an actor is of, by its number in vtkRenderer::GetActors(); empty: of none. */
  std::string GetFileOf(int actor);

  ///@{
  /** What the user should know of the last Update() or Write(): a line each. */
  vtkStringArray* GetNotes();
  vtkStringArray* GetWarnings();
  ///@}

  /** What the last Write() with `--certify` found; empty without one. */
  std::string GetCertificate();

  enum Failures
  {
    NO_FAILURE = 0,
    USAGE_FAILURE = 1, ///< words are wrong, for themselves or for what the files hold
    FILE_FAILURE = 2,  ///< a file cannot be read or written
    DRAW_FAILURE = 3   ///< the scene cannot be drawn
  };
  ///@{
  /** Why the last function that may fail did; NO_FAILURE and empty if it did not. */
  int GetFailure() { return this->Failure; }
  std::string GetFailureText() { return this->FailureText; }
  ///@}

  /** What is being done, such as "reading bunny.off". */
  std::string GetProgressText();

  /** Ends the work that goes on, from an observer of its progress. */
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

  // Whether the work ends without an exception; one becomes the error event and the failure.
  bool Try(const std::function<void()>& work);

  int Failure = NO_FAILURE;
  std::string FailureText;
  bool Abort = false;

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
