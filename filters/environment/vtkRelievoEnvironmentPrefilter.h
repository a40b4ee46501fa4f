// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoEnvironmentPrefilter
 * @brief Blurs an environment for mirrors of any roughness: the levels of a cube map.
 *
 * Input: an environment image as for vtkRelievoEnvironmentConvert, of any projection.
 *
 * Output: a vtkMultiBlockDataSet of Levels blocks "level 0", "level 1" ..., which are cubes as from
 * that filter (n x n x 6, float scalars "radiance"), each half as wide as the one before, so that
 * they are the levels of one OpenGL cube map. Level k is for roughness k / (Levels - 1), which its
 * field array "roughness" holds; level 0 is the environment itself, with Size texels across a face.
 * A shader reads level relievoPrefilterLevel(roughness, Levels) of
 * shaders/formulas/light/prefilter.glsl.
 *
 * A texel in direction r is the mean of the light around r, weighted as by a mirror of that
 * roughness at normal incidence (GGX, alpha = roughness^2; normal = view = r: the first
 * half of B. Karis's split sum, SIGGRAPH 2013; its stretch at grazing angles is lost).
 *
 * The mean uses no random samples. It is a sum over squares of the cube, each with the mean of its
 * light. A square is divided into four while its contribution may err by more than Tolerance of the
 * result: where the weight is curved, and where uneven light meets uneven weight. A sun of 1e5 is
 * thus resolved where it matters, without fireflies or NaN, and constant light stays constant. With
 * the defaults a mean takes 100 to 500 squares and differs from the sum over all texels by 0.1 to
 * 0.3 % on average and 1 % at worst, also beside a sun. It runs on all threads of vtkSMPTools.
 *
 * Errors, once, with an empty output and vtkErrorCode::UserError: those of
 * vtkRelievoEnvironmentConvert. An image without points gives no blocks.
 */
#ifndef vtkRelievoEnvironmentPrefilter_h
#define vtkRelievoEnvironmentPrefilter_h

#include "vtkMultiBlockDataSetAlgorithm.h"
#include "vtkRelievoFiltersModule.h"   // for the export macro
#include "vtkRelievoParametersMacro.h" // for the parameters by name
#include "vtkRelievoText.h"            // for their names and words

class VTKRELIEVOFILTERS_EXPORT vtkRelievoEnvironmentPrefilter : public vtkMultiBlockDataSetAlgorithm
{
public:
  static vtkRelievoEnvironmentPrefilter* New();
  vtkTypeMacro(vtkRelievoEnvironmentPrefilter, vtkMultiBlockDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Texels across a face of level 0, 0 to 2048, rounded up to a power of two. 0 uses the input's
   * detail, up to 256. Default is 0.
   */
  vtkSetClampMacro(Size, int, 0, 2048);
  vtkGetMacro(Size, int);
  ///@}

  ///@{
  /**
   * Number of levels, 2 to 12. There are fewer if a level would have less than one texel across.
   * Default is 6, for roughness 0, 0.2, 0.4 ... 1.
   */
  vtkSetClampMacro(Levels, int, 2, 12);
  vtkGetMacro(Levels, int);
  ///@}

  ///@{
  /**
   * The error allowed for one square of the sum, as a share of the texel's light, 1e-7 to 1;
   * smaller values divide into more squares. Default is 5e-4.
   */
  vtkSetClampMacro(Tolerance, double, 1e-7, 1.);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * The input's projection, one of vtkRelievoEnvironmentConvert::ProjectionType (default 0,
   * AUTOMATIC, by size); whether its values are sRGB (default off); whether it is mirrored (default
   * off).
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

  ///@{
  /** Parameters by name, with values in words, like vtkRelievoStage's. */
  vtkRelievoParametersMacro();
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
  vtkRelievoParameterList Parameters;

  vtkRelievoEnvironmentPrefilter(const vtkRelievoEnvironmentPrefilter&) = delete;
  void operator=(const vtkRelievoEnvironmentPrefilter&) = delete;
};

#endif
