// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoFrameComparison
 * @brief Explains how two frames differ: which objects, cells and lights, and why.
 *
 * A frame is an image with the picture (`color`) and layers, as vtkRelievoLayerSource makes and
 * OpenEXR files hold it; baselines also hold a record of objects, lights and settings
 * (vtkRelievoBaseline). Each pixel that differs is counted once, for the first cause that explains
 * it, in the order of GetCauseWords():
 * - size, camera: reported; nothing else is compared then.
 * - removed, added, moved, shape, visibility: of objects. `moved` has the displacement in world
 *   units and pixels, `shape` the cells.
 * - normal, array, color: of surfaces that are where they were; array is a named array's values,
 *   color the surface's own colour.
 * - light: a light's record differs. shadow: of a light that is the same.
 * - lamps, fog, ambient, markers, translucent: layers of stages.
 * - overlay: texts, bars and other things drawn over the scene, by the record.
 * - tone, settings: what else the records say differently.
 *
 * Pixels that differ within the limits are counted apart, as `rounding` or as `edge`: at borders,
 * between the colours around them. What no cause explains is `unexplained`. Records are compared
 * exactly, whatever the pixels show: a difference of them alone is a cause of 0 pixels.
 *
 * Objects are matched by name, otherwise by their cells and points: another order, or an added
 * actor, renumbers nothing. Of images of other programs (PNG) the picture alone is compared.
 *
 * Errors: an image without layers, of several slices, or a baseline of a newer format, in an error
 * event that names the frame; Compare() then returns false.
 */
#ifndef vtkRelievoFrameComparison_h
#define vtkRelievoFrameComparison_h

#include "vtkObject.h"
#include "vtkRelievoCompareModule.h" // for the export macro

#include <memory> // for what is private
#include <string> // for texts

class vtkImageData;

class VTKRELIEVOCOMPARE_EXPORT vtkRelievoFrameComparison : public vtkObject
{
public:
  static vtkRelievoFrameComparison* New();
  vtkTypeMacro(vtkRelievoFrameComparison, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The frame that is expected. Default: none. */
  void SetBaseline(vtkImageData* image);
  vtkImageData* GetBaseline();
  ///@}

  ///@{
  /** The frame that is judged. Default: none. */
  void SetFrame(vtkImageData* image);
  vtkImageData* GetFrame();
  ///@}

  ///@{
  /**
   * Reads a frame from a file: OpenEXR, or any image of vtkRelievoImageFile, whose picture is
   * compared. False, with an error event that names the file, if it cannot be read.
   */
  bool ReadBaseline(const char* path);
  bool ReadFrame(const char* path);
  ///@}

  ///@{
  /**
   * By how many levels of 255 colours may differ: of the picture, of surfaces, and of shadows and
   * other shares in 255ths. Software OpenGL rounds by the processor's vector units, which changes
   * a level. 0 to 255. Default: 2.
   */
  vtkSetClampMacro(ColorLevels, double, 0.0, 255.0);
  vtkGetMacro(ColorLevels, double);
  ///@}

  ///@{
  /**
   * By how many degrees normals may differ: neighbours of 16 bit octahedral words differ by up to
   * 0.012. 0 to 180. Default: 0.02.
   */
  vtkSetClampMacro(NormalAngle, double, 0.0, 180.0);
  vtkGetMacro(NormalAngle, double);
  ///@}

  ///@{
  /**
   * How far apart in the picture, in pixels, the points of a surface may be whose depths are
   * compared: OpenGL places corners on a grid of 1/256 pixel. Depths may also differ by four
   * roundings of a float. 0 to 1. Default: 1/256.
   */
  vtkSetClampMacro(DepthPixels, double, 0.0, 1.0);
  vtkGetMacro(DepthPixels, double);
  ///@}

  /** Compares the frames. False, with an error event, if they cannot be. */
  bool Compare();

  /** Why the last Compare(), ReadBaseline() or ReadFrame() failed; empty if it did not. */
  std::string GetFailureText() { return this->FailureText; }

  /** Whether the frames were alike within the limits; false before Compare(). */
  bool GetAlike();

  ///@{
  /** Numbers of pixels: beyond the limits, and of these without a cause. 0 before Compare(). */
  vtkIdType GetNumberOfDifferentPixels();
  vtkIdType GetNumberOfUnexplainedPixels();
  ///@}

  /** What differs, in lines that fit on a screen, causes of many pixels first. */
  std::string GetText();

  /**
   * The same, complete, as JSON: `alike`, `pixels` (that differ), `size`, `causes` (a list of
   * `cause`, `kind`, `name`, `id`, `pixels`, `words` and values of the cause's own),
   * `within_limits` (`edge`, `rounding`), `unexplained`, `cannot_be_detected` (causes that these
   * files do not tell), `limits`, `versions`.
   */
  std::string GetJSON();

  /**
   * For each pixel the place of its cause in the JSON's list, as the int array `cause`; -1: alike,
   * -2: rounding, -3: edge, -4: unexplained. Null before Compare(), and for frames of two sizes or
   * cameras.
   */
  vtkImageData* GetCauses();

  /** The newest format of baselines that is known here, and the one that is written. */
  static int GetRecordVersion();

  /** All words of causes, separated by commas, in the order in which they are asked. */
  static std::string GetCauseWords();

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
