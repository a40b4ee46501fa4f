// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVRelievoLamps.h"

#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVLODActor.h"
#include "vtkPVRelievoAccess.h"
#include "vtkPVRelievoWithin.h"
#include "vtkPVView.h"
#include "vtkRelievoLamps.h"
#include "vtkRelievoLampsStage.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <vector>

vtkStandardNewMacro(vtkPVRelievoLamps);

namespace
{
constexpr double Huge = 1e30;

std::vector<vtkPVRelievoLamps*>& GetAll()
{
  // Never destroyed: ParaView may delete its proxies' objects after this library's statics.
  static auto* all = new std::vector<vtkPVRelievoLamps*>;
  return *all;
}
}

class vtkPVRelievoLamps::Internals
{
public:
  vtkWeakPointer<vtkGeometryRepresentation> Representation;
  vtkNew<vtkRelievoLamps> Lamps;
};

//------------------------------------------------------------------------------
vtkPVRelievoLamps::vtkPVRelievoLamps()
  : Internal(new Internals)
{
  GetAll().push_back(this);
}

//------------------------------------------------------------------------------
vtkPVRelievoLamps::~vtkPVRelievoLamps()
{
  GetAll().erase(std::remove(GetAll().begin(), GetAll().end(), this), GetAll().end());
}

//------------------------------------------------------------------------------
void vtkPVRelievoLamps::SetRepresentation(vtkPVDataRepresentation* representation)
{
  auto* surface = vtkGeometryRepresentation::SafeDownCast(representation);
  if (!surface || this->Internal->Representation)
  {
    vtkErrorMacro("SetRepresentation was given " << (surface ? "a second one" : "no surface")
                                                 << "; give it one vtkGeometryRepresentation, "
                                                    "once.");
    return;
  }
  this->Internal->Representation = surface;
}

//------------------------------------------------------------------------------
bool vtkPVRelievoLamps::IsIn(vtkPVView* view)
{
  vtkGeometryRepresentation* surface = this->Internal->Representation;
  return this->Enabled && surface && surface->GetView() == view && surface->GetVisibility();
}

//------------------------------------------------------------------------------
bool vtkPVRelievoLamps::IsAny(vtkPVView* view)
{
  return std::any_of(
    GetAll().begin(), GetAll().end(), [view](vtkPVRelievoLamps* each) { return each->IsIn(view); });
}

//------------------------------------------------------------------------------
void vtkPVRelievoLamps::TakeInput()
{
  Internals& in = *this->Internal;
  vtkActor* actor = in.Representation->GetActor();
  vtkMapper* mapper = actor->GetMapper();
  if (mapper && mapper->GetNumberOfInputConnections(0) > 0)
  {
    in.Lamps->SetInputConnection(mapper->GetInputConnection(0, 0));
  }
  else
  {
    in.Lamps->SetInputData(nullptr);
  }
  in.Lamps->SetUserMatrix(actor->GetMatrix());
}

//------------------------------------------------------------------------------
void vtkPVRelievoLamps::Prepare(
  vtkPVView* view, vtkRelievoLampsStage* stage, vtkMultiProcessController* controller)
{
  std::vector<vtkRelievoLamps*> wanted;
  for (vtkPVRelievoLamps* each : GetAll())
  {
    if (each->IsIn(view))
    {
      each->TakeInput();
      wanted.push_back(each->Internal->Lamps);
    }
  }
  bool same = stage->GetNumberOfLampSets() == static_cast<int>(wanted.size());
  for (std::size_t i = 0; same && i < wanted.size(); ++i)
  {
    same = stage->GetLamps(static_cast<int>(i)) == wanted[i];
  }
  if (!same)
  {
    stage->RemoveAllLamps();
    for (vtkRelievoLamps* lamps : wanted)
    {
      stage->AddLamps(lamps);
    }
  }
  stage->SetController(controller);
}

//------------------------------------------------------------------------------
void vtkPVRelievoLamps::SetRadius(double radius)
{
  this->Internal->Lamps->SetRadius(vtkPVRelievoWithin(this, "LampRadius", radius, 0.0, Huge));
}

//------------------------------------------------------------------------------
void vtkPVRelievoLamps::SetIntensity(double intensity)
{
  this->Internal->Lamps->SetIntensity(
    vtkPVRelievoWithin(this, "LampIntensity", intensity, -Huge, Huge));
}

//------------------------------------------------------------------------------
void vtkPVRelievoLamps::SetColor(double red, double green, double blue)
{
  this->Internal->Lamps->SetColor(red, green, blue);
}

//------------------------------------------------------------------------------
void vtkPVRelievoLamps::SetFalloff(int falloff)
{
  this->Internal->Lamps->SetFalloff(vtkPVRelievoWithin<int>(
    this, "LampFalloff", falloff, vtkRelievoLamps::LINEAR, vtkRelievoLamps::VTK));
}

//------------------------------------------------------------------------------
void vtkPVRelievoLamps::SetAttenuation(double constant, double linear, double quadratic)
{
  this->Internal->Lamps->SetAttenuationValues(constant, linear, quadratic);
}

//------------------------------------------------------------------------------
void vtkPVRelievoLamps::SetArray(const char* value, const char* name)
{
  this->Internal->Lamps->SetArray(value, name ? name : "");
}

//------------------------------------------------------------------------------
void vtkPVRelievoLamps::SetRadiusArray(const char* name)
{
  this->SetArray("radius", name);
}

//------------------------------------------------------------------------------
void vtkPVRelievoLamps::SetIntensityArray(const char* name)
{
  this->SetArray("intensity", name);
}

//------------------------------------------------------------------------------
void vtkPVRelievoLamps::SetColorArray(const char* name)
{
  this->SetArray("color", name);
}

//------------------------------------------------------------------------------
void vtkPVRelievoLamps::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Representation: " << this->Internal->Representation.GetPointer() << "\n";
  os << indent << "Enabled: " << this->Enabled << "\n";
  os << indent << "Lamps:\n";
  this->Internal->Lamps->PrintSelf(os, indent.GetNextIndent());
}
