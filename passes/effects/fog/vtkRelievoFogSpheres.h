// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoFogSpheres
 * @brief Spheres of fog from data: each point is a sphere (vtkRelievoFogStage::AddPoints).
 *
 * The input's point arrays `radius`, `density` and `color` (SetArray selects others) give each
 * sphere its own values; the values set here apply to spheres without arrays. Fog is homogeneous
 * within a sphere.
 *
 * Spheres whose radius or density is 0 or less have no effect and are counted (GetNumberLeftOut).
 */
#ifndef vtkRelievoFogSpheres_h
#define vtkRelievoFogSpheres_h

#include "vtkRelievoEffectsModule.h" // for the export macro
#include "vtkRelievoPointValues.h"

class VTKRELIEVOEFFECTS_EXPORT vtkRelievoFogSpheres : public vtkRelievoPointValues
{
public:
  static vtkRelievoFogSpheres* New();
  vtkTypeMacro(vtkRelievoFogSpheres, vtkRelievoPointValues);

  ///@{
  /** World units, default 1. */
  void SetRadius(double radius);
  double GetRadius() const { return this->GetForAll(0)[0]; }
  ///@}

  ///@{
  /**
   * Default 1. In the stage's mode BEER: absorption per world unit, 63 % of the light over a length
   * of 1 / density. In the mode CHORD: the share of light absorbed through the sphere's centre, 0
   * to 1.
   */
  void SetDensity(double density);
  double GetDensity() const { return this->GetForAll(1)[0]; }
  ///@}

  ///@{
  /** Linear RGB, default white. Arrays of bytes range from 0 to 255. */
  void SetColor(double red, double green, double blue);
  void SetColor(const double color[3]) { this->SetColor(color[0], color[1], color[2]); }
  void GetColor(double color[3]) const;
  ///@}

#ifndef __VTK_WRAP__
  // Columns of a row of GetRows, after x, y and z: the values in the constructor's order.
  enum Columns
  {
    RADIUS = 3,
    DENSITY,
    RED,
    GREEN,
    BLUE
  };
#endif

protected:
  vtkRelievoFogSpheres();
  ~vtkRelievoFogSpheres() override;

  bool HasEffect(const double* row) const override;

private:
  vtkRelievoFogSpheres(const vtkRelievoFogSpheres&) = delete;
  void operator=(const vtkRelievoFogSpheres&) = delete;
};

#endif
