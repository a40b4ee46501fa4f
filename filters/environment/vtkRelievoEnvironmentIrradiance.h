// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoEnvironmentIrradiance
 * @brief Nine coefficients per colour by which an environment lights diffuse surfaces.
 *
 * Input: an environment image as for vtkRelievoEnvironmentConvert, of any projection.
 *
 * Output: a vtkTable of nine rows with one column "radiance" of three components (red, green, blue,
 * double): the coefficients of the light in the real orthonormal spherical harmonics up to order 2,
 * row l * l + l + m. GetCoefficient returns one, GetIrradiance evaluates them; shaders do the same
 * with shaders/formulas/light/irradiance.glsl.
 *
 * Each texel is treated as uniform light over its exact solid angle: harmonics are integrated over
 * it with 2 x 2 Gauss points, on texels divided until a cube's face has 32 across, and the solid
 * angles add up to 4 pi.
 *
 * Irradiance is exact for light of orders up to 3. For other light it lacks the even orders from 4
 * on, usually 1 % of it (R. Ramamoorthi, P. Hanrahan: An Efficient Representation for Irradiance
 * Environment Maps, SIGGRAPH 2001), and for a single point of light up to 9 %.
 *
 * Errors, once, with an empty output and vtkErrorCode::UserError: no such array; an image that does
 * not have the shape of the input projection. An image without points gives a table without rows.
 */
#ifndef vtkRelievoEnvironmentIrradiance_h
#define vtkRelievoEnvironmentIrradiance_h

#include "vtkRelievoFiltersModule.h"   // for the export macro
#include "vtkRelievoParametersMacro.h" // for the parameters by name
#include "vtkRelievoText.h"            // for their names and words
#include "vtkTableAlgorithm.h"

class VTKRELIEVOFILTERS_EXPORT vtkRelievoEnvironmentIrradiance : public vtkTableAlgorithm
{
public:
  static vtkRelievoEnvironmentIrradiance* New();
  vtkTypeMacro(vtkRelievoEnvironmentIrradiance, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

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

  /** Coefficient `index` (0 to 8) of the last run: red, green, blue; 0 for any other index. */
  void GetCoefficient(int index, double color[3]);

  /**
   * Irradiance on a surface with this normal (of any length but 0) in the environment of the last
   * run: the integral of light times max(cosine, 0), red, green, blue. Constant light L gives pi L.
   */
  void GetIrradiance(const double normal[3], double color[3]);

  ///@{
  /** Parameters by name, with values in words, like vtkRelievoStage's. */
  vtkRelievoParametersMacro();
  ///@}

protected:
  vtkRelievoEnvironmentIrradiance();
  ~vtkRelievoEnvironmentIrradiance() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  int InputProjection = 0;
  bool InputSRGB = false;
  bool InputMirrored = false;
  double Coefficients[9][3] = {};
  vtkRelievoParameterList Parameters;

  vtkRelievoEnvironmentIrradiance(const vtkRelievoEnvironmentIrradiance&) = delete;
  void operator=(const vtkRelievoEnvironmentIrradiance&) = delete;
};

#endif
