// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVRelievoPoints.h"

#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkPVLODActor.h"
#include "vtkPVRelievoAccess.h"
#include "vtkPVView.h"
#include "vtkRelievoPointValues.h"
#include "vtkWeakPointer.h"

#include <algorithm>

namespace
{
std::vector<vtkPVRelievoPoints*>& GetAll()
{
  // Never destroyed: ParaView may delete its proxies' objects after this library's statics.
  static auto* all = new std::vector<vtkPVRelievoPoints*>;
  return *all;
}
}

class vtkPVRelievoPoints::Internals
{
public:
  vtkWeakPointer<vtkGeometryRepresentation> Representation;
};

//------------------------------------------------------------------------------
vtkPVRelievoPoints::vtkPVRelievoPoints()
  : Internal(new Internals)
{
  GetAll().push_back(this);
}

//------------------------------------------------------------------------------
vtkPVRelievoPoints::~vtkPVRelievoPoints()
{
  GetAll().erase(std::remove(GetAll().begin(), GetAll().end(), this), GetAll().end());
}

//------------------------------------------------------------------------------
void vtkPVRelievoPoints::SetRepresentation(vtkPVDataRepresentation* representation)
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
bool vtkPVRelievoPoints::IsIn(vtkPVView* view)
{
  vtkGeometryRepresentation* surface = this->Internal->Representation;
  return this->Enabled && surface && surface->GetView() == view && surface->GetVisibility();
}

//------------------------------------------------------------------------------
bool vtkPVRelievoPoints::IsAny(vtkPVView* view)
{
  return std::any_of(GetAll().begin(), GetAll().end(),
    [view](vtkPVRelievoPoints* each) { return each->IsIn(view); });
}

//------------------------------------------------------------------------------
std::vector<vtkPVRelievoPoints*> vtkPVRelievoPoints::FindIn(vtkPVView* view)
{
  std::vector<vtkPVRelievoPoints*> found;
  for (vtkPVRelievoPoints* each : GetAll())
  {
    if (each->IsIn(view))
    {
      TakeInput(each->Internal->Representation, each->GetValues());
      found.push_back(each);
    }
  }
  return found;
}

//------------------------------------------------------------------------------
void vtkPVRelievoPoints::TakeInput(
  vtkGeometryRepresentation* representation, vtkRelievoPointValues* values)
{
  vtkActor* actor = representation ? representation->GetActor() : nullptr;
  vtkMapper* mapper = actor ? actor->GetMapper() : nullptr;
  if (mapper && mapper->GetNumberOfInputConnections(0) > 0)
  {
    values->SetInputConnection(mapper->GetInputConnection(0, 0));
  }
  else
  {
    values->SetInputData(nullptr);
  }
  values->SetUserMatrix(actor ? actor->GetMatrix() : nullptr);
}

//------------------------------------------------------------------------------
void vtkPVRelievoPoints::SetArray(const std::string& value, const char* name)
{
  this->GetValues()->SetArray(value, name ? name : "");
}

//------------------------------------------------------------------------------
void vtkPVRelievoPoints::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Representation: " << this->Internal->Representation.GetPointer() << "\n";
  os << indent << "Enabled: " << this->Enabled << "\n";
  os << indent << "Values:\n";
  this->GetValues()->PrintSelf(os, indent.GetNextIndent());
}
