// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVRelievoPoints.h"

#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVLODActor.h"
#include "vtkPVRelievoAccess.h"
#include "vtkPVRelievoClamped.h"
#include "vtkPVView.h"
#include "vtkRelievoPass.h"
#include "vtkRelievoPointStage.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <algorithm>

vtkStandardNewMacro(vtkPVRelievoPoints);

namespace
{
std::vector<vtkPVRelievoPoints*>& GetAllPoints()
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
  std::string Stage;
  vtkSmartPointer<vtkRelievoPointValues> Values;
};

//------------------------------------------------------------------------------
vtkPVRelievoPoints::vtkPVRelievoPoints()
  : Internal(new Internals)
{
  GetAllPoints().push_back(this);
}

//------------------------------------------------------------------------------
vtkPVRelievoPoints::~vtkPVRelievoPoints()
{
  GetAllPoints().erase(
    std::remove(GetAllPoints().begin(), GetAllPoints().end(), this), GetAllPoints().end());
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
  return this->Enabled && this->Internal->Values && surface && surface->GetView() == view &&
    surface->GetVisibility();
}

//------------------------------------------------------------------------------
bool vtkPVRelievoPoints::IsAny(vtkPVView* view)
{
  return std::any_of(GetAllPoints().begin(), GetAllPoints().end(),
    [view](vtkPVRelievoPoints* each) { return each->IsIn(view); });
}

//------------------------------------------------------------------------------
void vtkPVRelievoPoints::Prepare(vtkPVView* view, vtkRelievoPointStage* stage,
  const std::vector<vtkRelievoPointValues*>& more, vtkMultiProcessController* controller)
{
  std::vector<vtkRelievoPointValues*> wanted;
  for (vtkPVRelievoPoints* each : GetAllPoints())
  {
    if (each->IsIn(view) && each->Internal->Stage == stage->GetStageName())
    {
      TakeInput(each->Internal->Representation, each->Internal->Values);
      wanted.push_back(each->Internal->Values);
    }
  }
  wanted.insert(wanted.end(), more.begin(), more.end());
  bool same = stage->GetNumberOfPointSets() == static_cast<int>(wanted.size());
  for (std::size_t i = 0; same && i < wanted.size(); ++i)
  {
    same = stage->GetPoints(static_cast<int>(i)) == wanted[i];
  }
  if (!same)
  {
    stage->RemoveAllPoints();
    for (vtkRelievoPointValues* points : wanted)
    {
      stage->AddPoints(points);
    }
  }
  stage->SetController(controller);
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
// The parameter's name without its stage.
std::string vtkPVRelievoPoints::TakeName(const char* parameter)
{
  const std::string words = parameter ? parameter : "";
  const std::size_t colon = words.find(':');
  if (!this->Internal->Values && colon != std::string::npos)
  {
    vtkNew<vtkRelievoPass> frame;
    this->Internal->Stage = words.substr(0, colon);
    if (auto* stage = vtkRelievoPointStage::SafeDownCast(frame->GetStage(this->Internal->Stage)))
    {
      this->Internal->Values.TakeReference(stage->NewPoints());
    }
  }
  if (!this->Internal->Values)
  {
    vtkErrorMacro("'" << words << "' was given, expected STAGE:PARAMETER of a stage of points.");
    return {};
  }
  return words.substr(colon + 1);
}

//------------------------------------------------------------------------------
void vtkPVRelievoPoints::Set(const char* words, const std::vector<double>& values)
{
  const std::string name = this->TakeName(words);
  if (!name.empty())
  {
    vtkPVRelievoSet(this, this->Internal->Values->GetDescription(), name, values);
  }
}

//------------------------------------------------------------------------------
void vtkPVRelievoPoints::SetValue(const char* parameter, double value)
{
  this->Set(parameter, { value });
}

//------------------------------------------------------------------------------
void vtkPVRelievoPoints::SetValue(const char* parameter, double first, double second, double third)
{
  this->Set(parameter, { first, second, third });
}

//------------------------------------------------------------------------------
void vtkPVRelievoPoints::SetArray(const char* parameter, const char* array)
{
  const std::string name = this->TakeName(parameter);
  if (!name.empty())
  {
    this->Internal->Values->SetArray(name, array ? array : "");
  }
}

//------------------------------------------------------------------------------
void vtkPVRelievoPoints::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Representation: " << this->Internal->Representation.GetPointer() << "\n";
  os << indent << "Enabled: " << this->Enabled << "\n";
  os << indent << "Stage: " << this->Internal->Stage << "\n";
  if (this->Internal->Values)
  {
    this->Internal->Values->PrintSelf(os, indent.GetNextIndent());
  }
}
