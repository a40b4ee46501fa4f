// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPVRelievoVisibility
 * @brief vtkRelievoVisibility of one camera, which ParaView's properties describe.
 *
 * Errors: what vtkRelievoCalibration says of the lens; `orthographic` without its pixels.
 */
#ifndef vtkPVRelievoVisibility_h
#define vtkPVRelievoVisibility_h

#include "vtkNew.h"                       // for the view
#include "vtkRelievoPluginServerModule.h" // for the export macro
#include "vtkRelievoVisibility.h"

#include <string> // for the lens

class vtkCamera;

class VTKRELIEVOPLUGINSERVER_EXPORT vtkPVRelievoVisibility : public vtkRelievoVisibility
{
public:
  static vtkPVRelievoVisibility* New();
  vtkTypeMacro(vtkPVRelievoVisibility, vtkRelievoVisibility);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** As vtkCamera has them. Default 0, 0, 1; 0, 0, 0; 0, 1, 0; 30 degrees. */
  void SetPosition(double x, double y, double z);
  void SetFocalPoint(double x, double y, double z);
  void SetViewUp(double x, double y, double z);
  void SetViewAngle(double angle);
  ///@}

  ///@{
  /**
   * Columns and rows of its picture. Default 0, 0: as the file of the lens says, or 1024, 768.
   */
  vtkSetVector2Macro(Size, int);
  vtkGetVector2Macro(Size, int);
  ///@}

  /** The words of vtkRelievoCalibration. Default "pinhole". */
  void SetLens(const char* words);

protected:
  vtkPVRelievoVisibility();
  ~vtkPVRelievoVisibility() override;

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkPVRelievoVisibility(const vtkPVRelievoVisibility&) = delete;
  void operator=(const vtkPVRelievoVisibility&) = delete;

  vtkNew<vtkCamera> View;
  int Size[2] = { 0, 0 };
  std::string Lens = "pinhole";
};

#endif
