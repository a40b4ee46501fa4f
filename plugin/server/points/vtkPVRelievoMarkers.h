// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPVRelievoMarkers
 * @brief Points as markers on what their view shows (vtkRelievoMarkers).
 */
#ifndef vtkPVRelievoMarkers_h
#define vtkPVRelievoMarkers_h

#include "vtkNew.h" // for the markers
#include "vtkPVRelievoPoints.h"
#include "vtkRelievoMarkers.h" // for the markers

class vtkMultiProcessController;
class vtkPVRelievoSelection;
class vtkRelievoMarkersStage;

class VTKRELIEVOPLUGINSERVER_EXPORT vtkPVRelievoMarkers : public vtkPVRelievoPoints
{
public:
  static vtkPVRelievoMarkers* New();
  vtkTypeMacro(vtkPVRelievoMarkers, vtkPVRelievoPoints);

  ///@{
  /** The settings of vtkRelievoMarkers. */
  void SetShape(int shape);
  void SetRadius(double radius) override;
  void SetWidth(double width);
  void SetReach(double reach);
  void SetOpacity(double opacity);
  void SetColor(double red, double green, double blue) override;
  void SetUp(double x, double y, double z);
  void SetWidthArray(const char* name) { this->SetArray("width", name); }
  void SetReachArray(const char* name) { this->SetArray("reach", name); }
  void SetOpacityArray(const char* name) { this->SetArray("opacity", name); }
  ///@}

  vtkRelievoPointValues* GetValues() override;

  /** Before each picture: gives the stage the markers in the view, and those of its selection. */
  static void Prepare(vtkPVView* view, vtkPVRelievoSelection& selection,
    vtkRelievoMarkersStage* stage, vtkMultiProcessController* controller);

protected:
  vtkPVRelievoMarkers();
  ~vtkPVRelievoMarkers() override = default;

private:
  vtkPVRelievoMarkers(const vtkPVRelievoMarkers&) = delete;
  void operator=(const vtkPVRelievoMarkers&) = delete;

  vtkNew<vtkRelievoMarkers> Markers;
};

#endif
