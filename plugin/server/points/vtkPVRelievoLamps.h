// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPVRelievoLamps
 * @brief Points as lamps that light what their view shows (vtkRelievoLamps).
 */
#ifndef vtkPVRelievoLamps_h
#define vtkPVRelievoLamps_h

#include "vtkNew.h" // for the lamps
#include "vtkPVRelievoPoints.h"
#include "vtkRelievoLamps.h" // for the lamps

class vtkMultiProcessController;
class vtkRelievoLampsStage;

class VTKRELIEVOPLUGINSERVER_EXPORT vtkPVRelievoLamps : public vtkPVRelievoPoints
{
public:
  static vtkPVRelievoLamps* New();
  vtkTypeMacro(vtkPVRelievoLamps, vtkPVRelievoPoints);

  ///@{
  /** The settings of vtkRelievoLamps. */
  void SetRadius(double radius) override;
  void SetColor(double red, double green, double blue) override;
  void SetIntensity(double intensity);
  void SetIntensityArray(const char* name) { this->SetArray("intensity", name); }
  void SetFalloff(int falloff);
  void SetCasts(int choice); // place in CASTS_IF_LARGE, CASTS_NEVER, CASTS_ALWAYS
  void SetCastsArray(const char* name) { this->SetArray("casts", name); }
  void SetAttenuation(double constant, double linear, double quadratic);
  ///@}

  vtkRelievoPointValues* GetValues() override;

  /** Before each picture: gives the stage the lamps in the view. */
  static void Prepare(
    vtkPVView* view, vtkRelievoLampsStage* stage, vtkMultiProcessController* controller);

protected:
  vtkPVRelievoLamps() = default;
  ~vtkPVRelievoLamps() override = default;

private:
  vtkPVRelievoLamps(const vtkPVRelievoLamps&) = delete;
  void operator=(const vtkPVRelievoLamps&) = delete;

  vtkNew<vtkRelievoLamps> Lamps;
};

#endif
