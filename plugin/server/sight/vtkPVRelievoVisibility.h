// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPVRelievoVisibility
 * @brief vtkRelievoVisibility for a single camera, described by ParaView's properties.
 *
 * Errors: those of vtkRelievoCalibration about the lens; `orthographic` without its pixels; a
 * position, focal point and up direction that define no view.
 */
#ifndef vtkPVRelievoVisibility_h
#define vtkPVRelievoVisibility_h

#include "vtkRelievoParametersMacro.h"    // for the parameters by name
#include "vtkRelievoPluginServerModule.h" // for the export macro
#include "vtkRelievoText.h"               // for their names and words
#include "vtkRelievoVisibility.h"

#include <string> // for the lens

class VTKRELIEVOPLUGINSERVER_EXPORT vtkPVRelievoVisibility : public vtkRelievoVisibility
{
public:
  static vtkPVRelievoVisibility* New();
  vtkTypeMacro(vtkPVRelievoVisibility, vtkRelievoVisibility);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Like vtkCamera. Default 0, 0, 1; 0, 0, 0; 0, 1, 0; 30 degrees. */
  vtkSetVector3Macro(Position, double);
  vtkGetVector3Macro(Position, double);
  vtkSetVector3Macro(FocalPoint, double);
  vtkGetVector3Macro(FocalPoint, double);
  vtkSetVector3Macro(ViewUp, double);
  vtkGetVector3Macro(ViewUp, double);
  vtkSetMacro(ViewAngle, double);
  vtkGetMacro(ViewAngle, double);
  ///@}

  ///@{
  /**
   * Columns and rows of the camera's picture. Default 0, 0: from the lens file, or 1024, 768.
   */
  vtkSetVector2Macro(Size, int);
  vtkGetVector2Macro(Size, int);
  ///@}

  ///@{
  /** A lens in the words of vtkRelievoCalibration. Default "pinhole". */
  void SetLens(const char* words);
  const char* GetLens() { return this->Lens.c_str(); }
  ///@}

  ///@{
  /** Cloud, whose property would have the name of an output. */
  void SetMakeCloud(bool on) { this->SetCloud(on); }
  bool GetMakeCloud() { return this->GetCloud(); }
  ///@}

  /** All of these by their names, as `focal_point`; the XML of their properties is generated. */
  vtkRelievoParametersMacro();

protected:
  vtkPVRelievoVisibility();
  ~vtkPVRelievoVisibility() override;

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkPVRelievoVisibility(const vtkPVRelievoVisibility&) = delete;
  void operator=(const vtkPVRelievoVisibility&) = delete;

  vtkRelievoParameterList Parameters;
  double Position[3] = { 0.0, 0.0, 1.0 };
  double FocalPoint[3] = { 0.0, 0.0, 0.0 };
  double ViewUp[3] = { 0.0, 1.0, 0.0 };
  double ViewAngle = 30.0;
  int Size[2] = { 0, 0 };
  std::string Lens = "pinhole";
};

#endif
