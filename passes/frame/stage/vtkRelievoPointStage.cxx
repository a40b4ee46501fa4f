// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoPointStage.h"

#include "vtkMultiProcessController.h"

#include <algorithm>

//------------------------------------------------------------------------------
vtkRelievoPointStage::vtkRelievoPointStage() = default;

//------------------------------------------------------------------------------
vtkRelievoPointStage::~vtkRelievoPointStage() = default;

//------------------------------------------------------------------------------
void vtkRelievoPointStage::AddPoints(vtkRelievoPointValues* points)
{
  const std::string expected =
    vtkSmartPointer<vtkRelievoPointValues>::Take(this->NewPoints())->GetClassName();
  const bool fits = points && points->IsA(expected.c_str());
  if (!fits || std::find(this->Sets.begin(), this->Sets.end(), points) != this->Sets.end())
  {
    vtkErrorMacro("AddPoints was given "
      << (!points    ? std::string("no points")
             : !fits ? std::string("a ") + points->GetClassName()
                     : std::string("points that were added before"))
      << "; give it a " << expected << ", each once.");
    return;
  }
  this->Sets.emplace_back(points);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkRelievoPointStage::RemovePoints(vtkRelievoPointValues* points)
{
  const auto found = std::find(this->Sets.begin(), this->Sets.end(), points);
  if (found != this->Sets.end())
  {
    this->Sets.erase(found);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoPointStage::RemoveAllPoints()
{
  if (!this->Sets.empty())
  {
    this->Sets.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkRelievoPointStage::GetNumberOfPointSets()
{
  return static_cast<int>(this->Sets.size());
}

//------------------------------------------------------------------------------
vtkRelievoPointValues* vtkRelievoPointStage::GetPoints(int i)
{
  return i >= 0 && i < this->GetNumberOfPointSets() ? this->Sets[i].GetPointer() : nullptr;
}

//------------------------------------------------------------------------------
void vtkRelievoPointStage::SetController(vtkMultiProcessController* controller)
{
  this->Controller = controller;
}

//------------------------------------------------------------------------------
vtkMultiProcessController* vtkRelievoPointStage::GetController()
{
  return this->Controller;
}

//------------------------------------------------------------------------------
void vtkRelievoPointStage::Synchronize(vtkRelievoFrameContext&)
{
  for (const auto& points : this->Sets)
  {
    points->Share(this->Controller);
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoPointStage::IsTogether() const
{
  return this->Controller && !this->Sets.empty();
}

//------------------------------------------------------------------------------
void vtkRelievoPointStage::ReportFault(const std::string& fault)
{
  if (!fault.empty())
  {
    this->Explain("failed", fault);
    if (this->Fault != fault)
    {
      vtkErrorMacro(<< this->GetFailure() << ": " << fault << ".");
    }
  }
  this->Fault = fault;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkRelievoPointStage::GetDataTime()
{
  vtkMTimeType time = 0;
  for (const auto& points : this->Sets)
  {
    time = std::max(time, points->GetUpdatedTime());
  }
  return time;
}

//------------------------------------------------------------------------------
void vtkRelievoPointStage::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (const auto& points : this->Sets)
  {
    os << indent << "Points: " << points.GetPointer() << "\n";
  }
  os << indent << "Controller: " << this->Controller.GetPointer() << "\n";
  os << indent << "NumberDrawn: " << this->NumberDrawn << "\n";
}
