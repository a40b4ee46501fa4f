// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPVRelievoFog
 * @brief Points as spheres of fog in what their view shows (vtkRelievoFogSpheres).
 */
#ifndef vtkPVRelievoFog_h
#define vtkPVRelievoFog_h

#include "vtkNew.h" // for the fog
#include "vtkPVRelievoPoints.h"
#include "vtkRelievoFogSpheres.h" // for the fog

class vtkMultiProcessController;
class vtkRelievoFogStage;

class VTKRELIEVOPLUGINSERVER_EXPORT vtkPVRelievoFog : public vtkPVRelievoPoints
{
public:
  static vtkPVRelievoFog* New();
  vtkTypeMacro(vtkPVRelievoFog, vtkPVRelievoPoints);

  ///@{
  /** The settings of vtkRelievoFogSpheres. */
  void SetRadius(double radius) override;
  void SetColor(double red, double green, double blue) override;
  void SetDensity(double density);
  void SetDensityArray(const char* name) { this->SetArray("density", name); }
  ///@}

  vtkRelievoPointValues* GetValues() override;

  /** Before each picture: gives the stage the fog in the view. */
  static void Prepare(
    vtkPVView* view, vtkRelievoFogStage* stage, vtkMultiProcessController* controller);

protected:
  vtkPVRelievoFog() = default;
  ~vtkPVRelievoFog() override = default;

private:
  vtkPVRelievoFog(const vtkPVRelievoFog&) = delete;
  void operator=(const vtkPVRelievoFog&) = delete;

  vtkNew<vtkRelievoFogSpheres> Fog;
};

#endif
