// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSkeleton.h"

#include "vtkRelievoSkinNames.h"

#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <glm/geometric.hpp>

namespace relievo
{
namespace
{
// For the nodes, and again for those followed by axes.
void AddMatrices(const char* name, const std::vector<glm::dmat4>& matrices,
  const std::vector<std::size_t>& sources, vtkPolyData* output)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(16);
  array->SetNumberOfTuples(static_cast<vtkIdType>(sources.size()));
  for (std::size_t i = 0; i < sources.size(); ++i)
  {
    for (int j = 0; j < 16; ++j)
    {
      array->SetTypedComponent(static_cast<vtkIdType>(i), j, matrices[sources[i]][j % 4][j / 4]);
    }
  }
  output->GetPointData()->AddArray(array);
}

// Bones, and nodes moved by an animation.
std::vector<bool> FindJoints(const Model& model)
{
  std::vector<bool> joints;
  for (const ModelNode& node : model.Nodes)
  {
    joints.push_back(node.IsBone);
  }
  for (const ModelAnimation& animation : model.Animations)
  {
    for (const ModelChannel& channel : animation.Channels)
    {
      joints[static_cast<std::size_t>(channel.Node)] = true;
    }
  }
  return joints;
}

// Lines with their meaning.
struct Lines
{
  vtkNew<vtkCellArray> Cells;
  vtkNew<vtkUnsignedCharArray> Axes;
  vtkNew<vtkUnsignedCharArray> Colors;

  void Add(vtkIdType from, vtkIdType to, int axis)
  {
    const vtkIdType ends[2] = { from, to };
    this->Cells->InsertNextCell(2, ends);
    this->Axes->InsertNextValue(static_cast<unsigned char>(axis));
    const unsigned char colors[4][3] = { { 240, 170, 40 }, { 230, 60, 60 }, { 60, 230, 60 },
      { 60, 60, 230 } };
    this->Colors->InsertNextTypedTuple(colors[axis]);
  }
};
}

//------------------------------------------------------------------------------
void MakeSkeleton(const Model& model, const SkeletonPose& pose, double axes, vtkPolyData* output)
{
  const std::vector<bool> joints = FindJoints(model);
  vtkNew<vtkPoints> points;
  points->SetDataType(VTK_DOUBLE);
  Lines lines;
  lines.Axes->SetName("axis");
  lines.Colors->SetName("axis_color");
  lines.Colors->SetNumberOfComponents(3);
  std::vector<std::size_t> sources; // the node of each point
  for (std::size_t i = 0; i < model.Nodes.size(); ++i)
  {
    const glm::dvec4& at = pose.Now[i][3];
    points->InsertNextPoint(at.x, at.y, at.z);
    sources.push_back(i);
    const int parent = model.Nodes[i].Parent;
    if (parent >= 0 && joints[i] && joints[static_cast<std::size_t>(parent)])
    {
      lines.Add(parent, static_cast<vtkIdType>(i), 0);
    }
  }
  for (std::size_t i = 0; i < model.Nodes.size() && axes > 0.; ++i)
  {
    for (int axis = 0; axis < 3 && joints[i]; ++axis)
    {
      const glm::dvec3 direction(pose.Now[i][axis]);
      const double length = glm::length(direction);
      const glm::dvec3 at =
        glm::dvec3(pose.Now[i][3]) + direction * (length > 0. ? axes / length : 0.);
      lines.Add(static_cast<vtkIdType>(i), points->InsertNextPoint(at.x, at.y, at.z), axis + 1);
      sources.push_back(i);
    }
  }
  vtkNew<vtkIntArray> parents;
  parents->SetName("parent");
  vtkNew<vtkUnsignedCharArray> bones;
  bones->SetName("is_bone");
  vtkNew<vtkStringArray> names;
  names->SetName("name");
  for (const std::size_t i : sources)
  {
    parents->InsertNextValue(model.Nodes[i].Parent);
    bones->InsertNextValue(model.Nodes[i].IsBone ? 1 : 0);
    names->InsertNextValue(model.Nodes[i].Name);
  }
  output->SetPoints(points);
  output->SetLines(lines.Cells);
  output->GetPointData()->AddArray(parents);
  output->GetPointData()->AddArray(bones);
  output->GetPointData()->AddArray(names);
  if (axes > 0.)
  {
    output->GetCellData()->AddArray(lines.Axes);
    output->GetCellData()->SetScalars(lines.Colors);
  }
  AddMatrices(PoseArray, pose.Now, sources, output);
  AddMatrices(PoseBeforeArray, pose.Before, sources, output);
  AddMatrices(PoseAfterArray, pose.After, sources, output);
  vtkNew<vtkDoubleArray> share;
  share->SetName(KeyShareArray);
  share->InsertNextValue(pose.Share);
  output->GetFieldData()->AddArray(share);
}

//------------------------------------------------------------------------------
double GetAxisLength(const Model& model)
{
  constexpr double share = 0.03;
  std::vector<glm::dmat4> locals;
  for (const ModelNode& node : model.Nodes)
  {
    locals.push_back(node.Rest);
  }
  const std::vector<glm::dmat4> worlds = GetWorldMatrices(model.Nodes, locals);
  const std::vector<bool> joints = FindJoints(model);
  vtkBoundingBox box;
  for (std::size_t i = 0; i < worlds.size(); ++i)
  {
    if (joints[i])
    {
      box.AddPoint(worlds[i][3].x, worlds[i][3].y, worlds[i][3].z);
    }
  }
  // Points of skinned meshes may be in another unit, which only their bones convert: they count
  // only if nothing else has an extent.
  for (const bool skinned : { false, true })
  {
    for (const ModelMesh& mesh : model.Meshes)
    {
      if (mesh.IsSkinned == skinned)
      {
        box.AddBounds(mesh.Data->GetBounds());
      }
    }
    if (box.IsValid() && box.GetDiagonalLength() > 0.)
    {
      break;
    }
  }
  return box.IsValid() ? share * box.GetDiagonalLength() : 0.;
}
}
