// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVRelievoVisibility.h"

#include "vtkCamera.h"
#include "vtkObjectFactory.h"
#include "vtkRelievoCalibration.h"
#include "vtkRelievoCameraModel.h"

vtkStandardNewMacro(vtkPVRelievoVisibility);

//------------------------------------------------------------------------------
vtkPVRelievoVisibility::vtkPVRelievoVisibility() = default;

//------------------------------------------------------------------------------
vtkPVRelievoVisibility::~vtkPVRelievoVisibility() = default;

//------------------------------------------------------------------------------
void vtkPVRelievoVisibility::SetPosition(double x, double y, double z)
{
  this->View->SetPosition(x, y, z);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPVRelievoVisibility::SetFocalPoint(double x, double y, double z)
{
  this->View->SetFocalPoint(x, y, z);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPVRelievoVisibility::SetViewUp(double x, double y, double z)
{
  this->View->SetViewUp(x, y, z);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPVRelievoVisibility::SetViewAngle(double angle)
{
  this->View->SetViewAngle(angle);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPVRelievoVisibility::SetLens(const char* words)
{
  this->Lens = words ? words : "";
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkPVRelievoVisibility::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  this->RemoveAllCameras();
  vtkNew<vtkRelievoCalibration> lens;
  vtkRelievoCameraModel* camera = lens->SetWords(this->Lens.c_str()) && lens->Read()
    ? lens->MakeCamera(this->View, this->Size[0], this->Size[1])
    : nullptr;
  if (!camera)
  {
    return 0; // it has said why
  }
  this->AddCamera(camera);
  return this->Superclass::RequestData(request, inputs, outputs);
}

//------------------------------------------------------------------------------
void vtkPVRelievoVisibility::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Size: " << this->Size[0] << " x " << this->Size[1] << "\n";
  os << indent << "Lens: " << this->Lens << "\n";
}
