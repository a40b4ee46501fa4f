// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoLamps
 * @brief Lamps from data: each point is a lamp (vtkRelievoLampsStage::AddPoints).
 *
 * The input's point arrays `radius`, `intensity`, `color` and `casts` (SetArray selects others)
 * give each lamp its own values; the values set here apply to lamps without arrays. A lamp shines
 * in all directions, up to its radius, and through walls unless it casts shadows.
 *
 * Light at distance d of a lamp of radius r, before colour, intensity and the angle to the surface:
 * - LINEAR: max(0, 1 - d / r), the default.
 * - INVERSE_SQUARE: 1 / d^2, brought to 0 at r by the window (1 - (d / r)^4)^2 (B. Karis, Real
 *   Shading in Unreal Engine 4, 2013); d is at least r / 100.
 * - VTK: 1 / (a + b d + c d^2), with the attenuation values of vtkLight; nothing beyond r.
 *
 * A lamp of radius 0 or less, or of intensity 0, has no effect; a negative intensity removes light.
 */
#ifndef vtkRelievoLamps_h
#define vtkRelievoLamps_h

#include "vtkRelievoDeferredModule.h" // for the export macro
#include "vtkRelievoPointValues.h"

class VTKRELIEVODEFERRED_EXPORT vtkRelievoLamps : public vtkRelievoPointValues
{
public:
  static vtkRelievoLamps* New();
  vtkTypeMacro(vtkRelievoLamps, vtkRelievoPointValues);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** How light falls off with distance; see the class. */
  enum Falloffs
  {
    LINEAR = 0,
    INVERSE_SQUARE = 1,
    VTK = 2
  };

  ///@{
  /** World units, default 1. */
  void SetRadius(double radius);
  double GetRadius() const { return this->GetForAll(0)[0]; }
  ///@}

  ///@{
  /** Default 1. */
  void SetIntensity(double intensity);
  double GetIntensity() const { return this->GetForAll(1)[0]; }
  ///@}

  ///@{
  /** Linear RGB, default white. Arrays of bytes range from 0 to 255. */
  void SetColor(double red, double green, double blue);
  void SetColor(const double color[3]) { this->SetColor(color[0], color[1], color[2]); }
  void GetColor(double color[3]) const;
  ///@}

  enum Casting
  {
    CASTS_IF_LARGE = -1,
    CASTS_NEVER = 0,
    CASTS_ALWAYS = 1
  };

  ///@{
  /**
   * Whether lamps cast shadows: CASTS_IF_LARGE (default) if the stage selects them
   * (vtkRelievoLampsStage::SetCasting), CASTS_NEVER, or CASTS_ALWAYS. At most eight lamps cast in a
   * picture. In arrays: negative numbers, 0, and positive numbers.
   */
  void SetCasts(int casts);
  int GetCasts() const;
  ///@}

  ///@{
  /** LINEAR (default), INVERSE_SQUARE or VTK. */
  vtkSetClampMacro(Falloff, int, LINEAR, VTK);
  vtkGetMacro(Falloff, int);
  void SetFalloffToLinear() { this->SetFalloff(LINEAR); }
  void SetFalloffToInverseSquare() { this->SetFalloff(INVERSE_SQUARE); }
  void SetFalloffToVTK() { this->SetFalloff(VTK); }
  ///@}

  ///@{
  /** Constant, linear and quadratic coefficients of VTK, as in vtkLight; default 1, 0, 0. */
  vtkSetVector3Macro(AttenuationValues, double);
  vtkGetVector3Macro(AttenuationValues, double);
  ///@}

#ifndef __VTK_WRAP__
  // Whether some lamp of this process always casts. Up to date after GetNumberOfPoints.
  bool GetSomeCastAlways();

  // The value `casts` in a row of GetRows.
  static double GetCastsOf(const double* row)
  {
    return row[8];
  }
#endif

protected:
  vtkRelievoLamps();
  ~vtkRelievoLamps() override;

  bool HasEffect(const double* row) const override;

  vtkMTimeType LookedAt = 0; // when SomeCast was determined
  bool SomeCastAlways = false;
  int Falloff = LINEAR;
  double AttenuationValues[3] = { 1.0, 0.0, 0.0 };

private:
  vtkRelievoLamps(const vtkRelievoLamps&) = delete;
  void operator=(const vtkRelievoLamps&) = delete;
};

#endif
