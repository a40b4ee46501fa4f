// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVRelievoVisibility.h"

#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRelievoCalibration.h"
#include "vtkRelievoCameraModel.h"
#include "vtkRelievoParameter.h"

vtkStandardNewMacro(vtkPVRelievoVisibility);

//------------------------------------------------------------------------------
vtkPVRelievoVisibility::vtkPVRelievoVisibility()
{
  vtkRelievoParameterList& list = this->Parameters;
  list.AddVector("position", vtkRelievoMember(Position),
    "Where the camera stands; at first above the mesh, from where it sees all of it.");
  list.AddVector("focal_point", vtkRelievoMember(FocalPoint),
    "The point that it looks at; at first the centre of the mesh.");
  list.AddVector("view_up", vtkRelievoMember(ViewUp), "The direction that is up in its picture.");
  list.AddNumber(
    "view_angle", vtkRelievoMember(ViewAngle), 0.001, 179.0, "degrees", "Its full vertical angle.");
  list
    .AddSize("size", vtkRelievoMember(Size), 0,
      "Columns and rows of its picture; a ray goes through each pixel's centre. 0 and 0: as the "
      "file of the lens says, or 1024 and 768.")
    .Most = 16384.0;
  list.AddText(
    "lens", [this]() { return this->Lens; },
    [this](const std::string& words) { this->SetLens(words.c_str()); },
    "The lens in words, such as fisheye:angle=180, equirectangular (all around) or "
    "orthographic:100 (pixels for a world unit), or the name of a calibration's file.");
  list.AddFlag(
    "make_cloud", this->Cloud, [this](bool on) { this->SetCloud(on); },
    "Whether the second output has the visible surface points.");
}

//------------------------------------------------------------------------------
vtkPVRelievoVisibility::~vtkPVRelievoVisibility() = default;

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
  if (this->Lens == "orthographic")
  {
    vtkErrorMacro("Lens: got 'orthographic', expected the pixels for a world unit as well, as in "
                  "'orthographic:100'");
    return 1; // after 0 the executive adds an error in terms of code
  }
  const std::string error =
    vtkRelievoCameraModel::CheckView(this->Position, this->FocalPoint, this->ViewUp);
  if (!error.empty())
  {
    vtkErrorMacro("Position, Focal Point and View Up: " << error);
    return 1;
  }
  vtkNew<vtkCamera> view;
  view->SetViewAngle(this->ViewAngle);
  vtkNew<vtkRelievoCalibration> lens;
  vtkRelievoCameraModel* camera = nullptr;
  if (lens->SetWords(this->Lens.c_str()) && lens->Read())
  {
    const int standard[2] = { 1024, 768 };
    const int* unsaid = lens->GetFileSize()[0] > 0 ? lens->GetFileSize() : standard;
    const int* size = this->Size[0] > 0 && this->Size[1] > 0 ? this->Size : unsaid;
    camera = lens->MakeCamera(view, size[0], size[1]);
  }
  if (!camera)
  {
    return 1; // the error has been reported
  }
  // vtkCamera would replace an invalid up direction by y.
  camera->LookAt(this->Position, this->FocalPoint, this->ViewUp);
  this->AddCamera(camera);
  return this->Superclass::RequestData(request, inputs, outputs);
}

//------------------------------------------------------------------------------
void vtkPVRelievoVisibility::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print = [&](const char* name, const double* place) {
    os << indent << name << ": " << place[0] << ", " << place[1] << ", " << place[2] << "\n";
  };
  print("Position", this->Position);
  print("FocalPoint", this->FocalPoint);
  print("ViewUp", this->ViewUp);
  os << indent << "ViewAngle: " << this->ViewAngle << "\n";
  os << indent << "Size: " << this->Size[0] << " x " << this->Size[1] << "\n";
  os << indent << "Lens: " << this->Lens << "\n";
}
