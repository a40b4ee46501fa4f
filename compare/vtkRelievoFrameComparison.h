// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoFrameComparison
 * @brief Explains how two frames differ: which objects, cells and lights, and why.
 *
 * A frame is an image with the picture (`color`) and layers, from vtkRelievoLayerSource or an
 * OpenEXR file; baselines (vtkRelievoBaseline) also have a record of objects, lights and settings.
 * Each pixel that differs is counted once, for the first cause that explains it, in the order of
 * GetCauseWords():
 * - size, camera: if these differ, nothing else is compared.
 * - removed, added, moved, shape, visibility: changes of objects. `moved` has the displacement in
 *   world units and pixels, `shape` the cells.
 * - normal, array, color: changes of surfaces in the same place; array refers to the values of a
 *   named array, color to the surface's own colour.
 * - light: a light's record differs. shadow: the shadow of an unchanged light differs.
 * - lamps, fog, ambient, markers, translucent: layers of stages differ.
 * - overlay: the records of texts, bars and other 2D props over the scene differ.
 * - tone, settings: other entries of the records differ.
 *
 * Pixels that differ within the limits are counted separately, as `rounding`, or as `edge` at
 * borders, if their colours lie between the neighbours' colours. Differences without a cause are
 * `unexplained`. Records are compared exactly, independently of the pixels: if only the records
 * differ, the cause has 0 pixels.
 *
 * Objects are matched by name, otherwise by their cells and points, so that another order or an
 * added actor is no change of the other objects. For images of other programs (PNG), only the
 * pictures are compared.
 *
 * Errors: an image without layers or with several slices, or a baseline of a newer format, gives an
 * error event that names the frame; Compare() then returns false.
 */
#ifndef vtkRelievoFrameComparison_h
#define vtkRelievoFrameComparison_h

#include "vtkObject.h"
#include "vtkRelievoCompareModule.h" // for the export macro

#include <memory> // for private data
#include <string> // for texts

class vtkImageData;

class VTKRELIEVOCOMPARE_EXPORT vtkRelievoFrameComparison : public vtkObject
{
public:
  static vtkRelievoFrameComparison* New();
  vtkTypeMacro(vtkRelievoFrameComparison, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The expected frame. Default: none. */
  void SetBaseline(vtkImageData* image);
  vtkImageData* GetBaseline();
  ///@}

  ///@{
  /** The frame to check. Default: none. */
  void SetFrame(vtkImageData* image);
  vtkImageData* GetFrame();
  ///@}

  ///@{
  /**
   * Reads a frame from a file: OpenEXR, or an image format of vtkRelievoImageFile, for its picture
   * alone. Returns false, with an error event that names the file, if it cannot be read.
   */
  bool ReadBaseline(const char* path);
  bool ReadFrame(const char* path);
  ///@}

  ///@{
  /**
   * Tolerance for colours of the picture and of surfaces, in levels of 255, and for shadows and
   * other shares, in 255ths. Software OpenGL rounds differently with other vector units of the
   * processor, which changes colours by one level. 0 to 255. Default: 2.
   */
  vtkSetClampMacro(ColorLevels, double, 0.0, 255.0);
  vtkGetMacro(ColorLevels, double);
  ///@}

  ///@{
  /**
   * Tolerance for normals, in degrees: neighbouring codes of 16-bit octahedral normals differ by up
   * to 0.012 degrees. 0 to 180. Default: 0.02.
   */
  vtkSetClampMacro(NormalAngle, double, 0.0, 180.0);
  vtkGetMacro(NormalAngle, double);
  ///@}

  ///@{
  /**
   * Tolerance for depths, as the change of a surface's depth over this many pixels: OpenGL places
   * corners on a grid of 1/256 pixel. Depths may also differ by four roundings of a float. 0 to 1.
   * Default: 1/256.
   */
  vtkSetClampMacro(DepthPixels, double, 0.0, 1.0);
  vtkGetMacro(DepthPixels, double);
  ///@}

  /** Compares the frames. Returns false, with an error event, if they cannot be compared. */
  bool Compare();

  /** The error of the last Compare(), ReadBaseline() or ReadFrame(); empty if it succeeded. */
  std::string GetFailureText() { return this->FailureText; }

  /** Whether the frames are alike within the limits; false before Compare(). */
  bool GetAlike();

  ///@{
  /** Numbers of pixels beyond the limits, and of those among them without a cause. 0 before
   * Compare(). */
  vtkIdType GetNumberOfDifferentPixels();
  vtkIdType GetNumberOfUnexplainedPixels();
  ///@}

  /** The result as a short table, causes with the most pixels first. */
  std::string GetText();

  /**
   * The full result as JSON: `alike`, `pixels` (beyond the limits), `size`, `causes` (a list of
   * `cause`, `kind`, `name`, `id`, `label`, `pixels`, `words` and further values of some causes),
   * `within_limits` (`edge`, `rounding`), `unexplained`, `cannot_be_detected` (causes for which
   * these files lack data), `limits`, `versions`.
   */
  std::string GetJSON();

  /**
   * The index of each pixel's cause in the JSON's list, as the int array `cause`; -1: alike,
   * -2: rounding, -3: edge, -4: unexplained. Null before Compare(), and for frames of different
   * sizes or cameras.
   */
  vtkImageData* GetCauses();

  /** The newest supported format of baselines, which is also the one written. */
  static int GetRecordVersion();

  /** All words of causes, separated by commas, in the order of precedence. */
  static std::string GetCauseWords();

  /**
   * The colour of a cause in reports, as "#rrggbb"; also of `edge`, `rounding` and `unexplained`.
   * Empty for other words.
   */
  static std::string GetCauseColor(const char* word);

protected:
  vtkRelievoFrameComparison();
  ~vtkRelievoFrameComparison() override;

private:
  vtkRelievoFrameComparison(const vtkRelievoFrameComparison&) = delete;
  void operator=(const vtkRelievoFrameComparison&) = delete;

  bool Fail(const std::string& text);

  double ColorLevels, NormalAngle, DepthPixels;
  std::string FailureText;

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
