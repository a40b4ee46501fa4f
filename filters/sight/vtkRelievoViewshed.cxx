// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoViewshed.h"

#include "vtkRelievoAbort.h"
#include "vtkRelievoParameter.h"
#include "vtkRelievoRayScene.h"
#include "vtkRelievoRayTree.h"
#include "vtkRelievoThreads.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkRelievoViewshed);

namespace
{
constexpr double Raised = 1e-9;         // of the mesh's size
constexpr double EarthRadius = 6371e3;  // metres
constexpr vtkIdType Batch = 1 << 16;    // targets between two reports of progress
constexpr vtkIdType LinesAtOnce = 1024; // in a thread

// The highest place of the mesh, which is prop 0, at x and y; false if it is not there.
bool FindGround(vtkRelievoRayScene* scene, const double bounds[6], double x, double y, double& z)
{
  const vtkRelievoRayTree& tree = scene->GetTree();
  const glm::dvec3 down(0.0, 0.0, -1.0);
  const double above = bounds[5] + 1.0 + 0.1 * (bounds[5] - bounds[4]);
  const glm::dvec3 from = glm::dvec3(x, y, above) - tree.GetCenter();
  std::vector<vtkRelievoRayTree::Hit> hits;
  tree.FindAll(from, down, 0.0, vtkMath::Inf(), hits);
  for (const vtkRelievoRayTree::Hit& hit : hits)
  {
    if (scene->GetMeshProp(tree.GetMesh(hit.Place)) == 0)
    {
      z = tree.GetDetails(hit, from, down).Position.z;
      return true;
    }
  }
  return false;
}

// The mesh around an observer on a round Earth.
void Bend(vtkPoints* flat, double x, double y, double curvature, vtkPoints* bent)
{
  for (vtkIdType i = 0; i < flat->GetNumberOfPoints(); ++i)
  {
    double point[3];
    flat->GetPoint(i, point);
    const double distance2 = (point[0] - x) * (point[0] - x) + (point[1] - y) * (point[1] - y);
    point[2] -= curvature * distance2 / (2.0 * EarthRadius);
    bent->SetPoint(i, point);
  }
  bent->Modified();
}
}

//------------------------------------------------------------------------------
vtkRelievoViewshed::vtkRelievoViewshed()
{
  const double infinity = vtkMath::Inf();
  vtkRelievoParameterList& list = this->Parameters;
  list.AddNumber("target_height", vtkRelievoMember(TargetHeight), 0.0, infinity, "",
    "Height of the targets above the ground, in world units.");
  list.AddNumber("farthest_distance", vtkRelievoMember(FarthestDistance), 0.0, infinity, "",
    "The largest horizontal distance that observers see, in world units; 0: any.");
  list.AddNumber("curvature", vtkRelievoMember(Curvature), 0.0, 1.0, "",
    "Share of the Earth's curvature that counts: 1 without refraction, 0.857 with the usual "
    "refraction of light in air. World units are then metres.");
}

//------------------------------------------------------------------------------
void vtkRelievoViewshed::AddViewpoint(double x, double y, double height)
{
  if (!(height >= 0.0) || !std::isfinite(x) || !std::isfinite(y) || !std::isfinite(height))
  {
    vtkErrorMacro("AddViewpoint: got " << x << ", " << y << ", " << height
                                       << ", expected finite numbers and a height of at least 0.");
    return;
  }
  this->Observers.push_back({ x, y, height });
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkRelievoViewshed::RemoveAllViewpoints()
{
  this->Observers.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkRelievoViewshed::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  relievo::Begin(outputs);
  vtkPolyData* mesh = vtkPolyData::GetData(inputs[0]);
  if (this->Observers.empty())
  {
    vtkErrorMacro("There are no observers; add at least one.");
    return 1; // status 0 would make the executive print an internal error
  }
  if (mesh->GetNumberOfPoints() == 0)
  {
    vtkErrorMacro("The mesh has no points, expected a terrain.");
    return 1;
  }
  const bool isBent = this->Curvature > 0.0;
  if (isBent && inputs[1]->GetNumberOfInformationObjects() > 0)
  {
    vtkErrorMacro(
      "Curvature: got " << this->Curvature << ", expected 0 beside other data that hide the mesh.");
    return 1;
  }
  vtkSmartPointer<vtkRelievoRayScene> scene;
  vtkNew<vtkPolyData> bent;
  if (isBent)
  {
    bent->CopyStructure(mesh);
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(mesh->GetNumberOfPoints());
    bent->SetPoints(points);
    scene = vtkSmartPointer<vtkRelievoRayScene>::New();
    scene->AddData(bent);
  }
  else
  {
    scene = this->MakeScene(inputs);
  }
  if (!scene)
  {
    return 1;
  }

  const auto share = this->GetShare(static_cast<std::size_t>(mesh->GetNumberOfPoints()));
  const auto begin = static_cast<vtkIdType>(share[0]);
  const auto end = static_cast<vtkIdType>(share[1]);
  vtkNew<vtkIntArray> seen;
  seen->SetName("seen");
  seen->SetNumberOfTuples(mesh->GetNumberOfPoints());
  seen->FillValue(0);
  int* counts = seen->GetPointer(0);
  const double raised = Raised * mesh->GetLength();
  const double farthest = this->FarthestDistance > 0.0 ? this->FarthestDistance : vtkMath::Inf();
  double done = 0.0;
  const double all = static_cast<double>(end - begin) * this->GetNumberOfViewpoints();
  for (const auto& [x, y, height] : this->Observers)
  {
    vtkPoints* points = mesh->GetPoints();
    if (isBent)
    {
      points = bent->GetPoints();
      Bend(mesh->GetPoints(), x, y, this->Curvature, points);
      bent->Modified();
      scene->Update();
      const std::string fault = scene->GetFault();
      if (!fault.empty())
      {
        vtkErrorMacro(<< fault);
        return 1;
      }
    }
    double bounds[6];
    points->GetBounds(bounds);
    double ground = 0.0;
    if (!FindGround(scene, bounds, x, y, ground))
    {
      vtkErrorMacro("The observer at " << x << ", " << y
                                       << " is not above the mesh, expected one within its "
                                          "outline and not in a hole.");
      return 1;
    }
    const vtkRelievoRayTree& tree = scene->GetTree();
    const glm::dvec3 eye(x, y, ground + height + raised);
    const auto look = [&](vtkIdType first, vtkIdType last) {
      std::vector<vtkRelievoRayTree::Line> lines;
      std::vector<vtkRelievoRayTree::Hit> hits;
      std::vector<vtkIdType> targets;
      for (vtkIdType from = first; from < last; from += LinesAtOnce)
      {
        lines.clear();
        targets.clear();
        for (vtkIdType i = from; i < std::min(last, from + LinesAtOnce); ++i)
        {
          glm::dvec3 target;
          points->GetPoint(i, &target.x);
          target.z += this->TargetHeight + raised;
          if (target == eye)
          {
            ++counts[i]; // not a line
          }
          else if (std::hypot(target.x - x, target.y - y) <= farthest)
          {
            lines.push_back({ eye - tree.GetCenter(), target - eye });
            targets.push_back(i);
          }
        }
        hits.assign(lines.size(), {});
        tree.FindAny(lines.data(), static_cast<int>(lines.size()), 0.0, 1.0, hits.data());
        for (std::size_t i = 0; i < targets.size(); ++i)
        {
          counts[targets[i]] += hits[i].Place < 0 ? 1 : 0;
        }
      }
    };
    for (vtkIdType from = begin; from < end; from += Batch)
    {
      const vtkIdType to = std::min(end, from + Batch);
      vtkRelievoForRanges(from, to, LinesAtOnce, look);
      done += static_cast<double>(to - from);
      this->UpdateProgress(done / all);
      if (relievo::IsStopped(this))
      {
        relievo::Discard(outputs);
        return 1;
      }
    }
  }
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  output->ShallowCopy(mesh);
  output->GetPointData()->AddArray(seen);
  output->GetPointData()->SetActiveScalars("seen");
  return 1;
}

//------------------------------------------------------------------------------
void vtkRelievoViewshed::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (const auto& [x, y, height] : this->Observers)
  {
    os << indent << "Observer: " << x << " " << y << " " << height << "\n";
  }
  this->Parameters.Print(os, indent);
}
