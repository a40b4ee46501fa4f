// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoEnvironmentPrefilter
 * @brief Blurs an environment for mirrors of every roughness: the levels of a cube map.
 *
 * Input: an environment image as vtkRelievoEnvironmentConvert takes it, of any projection.
 *
 * Output: a vtkMultiBlockDataSet of Levels blocks "level 0", "level 1" ...: cubes as that filter
 * makes them (n x n x 6, float scalars "radiance"), each half as wide as the one before, so that
 * they are the levels of one OpenGL cube map. Level k is for roughness k / (Levels - 1), which its
 * field array "roughness" holds; level 0 is the environment itself, at Size texels a face. A shader
 * looks up relievoPrefilterLevel(roughness, Levels) of shaders/formulas/prefilter.glsl.
 *
 * A texel of direction r is the mean of the light about r, weighted as a mirror of that roughness
 * would if it were seen straight from above (GGX, alpha = roughness^2; normal = view = r: the first
 * half of B. Karis's split sum, SIGGRAPH 2013; its stretch at grazing angles is lost).
 *
 * The mean is not sampled at random, as it mostly is: it is a sum over squares of the cube, each by
 * the mean of its light. A square is parted in four while its part in the sum may err by more than
 * Tolerance of the result: where the weight bends, and where unequal light meets unequal weight. So
 * a sun of 1e5 is met as itself where it counts, nothing is left to chance, and there are no
 * fireflies and no NaN; constant light stays as it is. With the defaults 100 to 500 squares make a
 * mean, off the sum over all texels by 0.1 to 0.3 % on average and 1 % at worst, beside a sun as
 * well. It runs on all threads of vtkSMPTools.
 *
 * Errors, once, with an empty output and vtkErrorCode::UserError: those of
 * vtkRelievoEnvironmentConvert. An image without points gives no blocks.
 */
#ifndef vtkRelievoEnvironmentPrefilter_h
#define vtkRelievoEnvironmentPrefilter_h

#include "vtkMultiBlockDataSetAlgorithm.h"
#include "vtkRelievoFiltersModule.h" // for the export macro

class VTKRELIEVOFILTERS_EXPORT vtkRelievoEnvironmentPrefilter : public vtkMultiBlockDataSetAlgorithm
{
public:
  static vtkRelievoEnvironmentPrefilter* New();
  vtkTypeMacro(vtkRelievoEnvironmentPrefilter, vtkMultiBlockDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Texels across a face of level 0; rounded up to a power of two. 0 takes as much as the input's
   * detail, at most 256. Default is 0; at most 2048.
   */
  vtkSetClampMacro(Size, int, 0, 2048);
  vtkGetMacro(Size, int);
  ///@}

  ///@{
  /**
   * Number of levels. Fewer are made where a level would have less than one texel across. Default
   * is 6: roughness 0, 0.2, 0.4 ... 1; 2 to 12.
   */
  vtkSetClampMacro(Levels, int, 2, 12);
  vtkGetMacro(Levels, int);
  ///@}

  ///@{
  /**
   * How much of a texel's light one square of the sum may err by; a smaller one takes more squares.
   * Default is 5e-4; from 1e-7 to 1.
   */
  vtkSetClampMacro(Tolerance, double, 1e-7, 1.);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * As of vtkRelievoEnvironmentConvert: the projection (0, AUTOMATIC, by size, is the default);
   * whether numbers are sRGB (default off); whether the image is mirrored (default off).
   */
  vtkSetClampMacro(InputProjection, int, 0, 3);
  vtkGetMacro(InputProjection, int);
  vtkSetMacro(InputSRGB, bool);
  vtkGetMacro(InputSRGB, bool);
  vtkBooleanMacro(InputSRGB, bool);
  vtkSetMacro(InputMirrored, bool);
  vtkGetMacro(InputMirrored, bool);
  vtkBooleanMacro(InputMirrored, bool);
  ///@}

protected:
  vtkRelievoEnvironmentPrefilter();
  ~vtkRelievoEnvironmentPrefilter() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  int Size = 0;
  int Levels = 6;
  double Tolerance = 5e-4;
  int InputProjection = 0;
  bool InputSRGB = false;
  bool InputMirrored = false;

  vtkRelievoEnvironmentPrefilter(const vtkRelievoEnvironmentPrefilter&) = delete;
  void operator=(const vtkRelievoEnvironmentPrefilter&) = delete;
};

#endif
