// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoFogSpheres
 * @brief Spheres of fog from data: each point is a sphere (vtkRelievoFogStage::AddPoints).
 *
 * The input's point arrays `radius`, `density` and `color` (SetArray takes others) give each sphere
 * its own values; the values set here are for spheres without. The fog of a sphere is even.
 *
 * A sphere whose radius or density is 0 or less has no effect, and is counted (GetNumberLeftOut).
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
   * Default 1. In the stage's mode BEER, per world unit: over a length of 1 / density, 63 % of the
   * light is held back. In the mode CHORD, 0 to 1: what is held back through the sphere's centre.
   */
  void SetDensity(double density);
  double GetDensity() const { return this->GetForAll(1)[0]; }
  ///@}

  ///@{
  /** Linear RGB, default white. Arrays of bytes are 0 to 255. */
  void SetColor(double red, double green, double blue);
  void SetColor(const double color[3]) { this->SetColor(color[0], color[1], color[2]); }
  void GetColor(double color[3]) const;
  ///@}

#ifndef __VTK_WRAP__
  // Places in a row of GetRows, behind those of x, y and z: the values in the constructor's order.
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
