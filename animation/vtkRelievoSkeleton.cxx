// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSkeleton.h"

#include "vtkRelievoSkinNames.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

namespace relievo
{
namespace
{
void AddMatrices(const char* name, const std::vector<glm::dmat4>& matrices, vtkPolyData* output)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(16);
  array->SetNumberOfTuples(static_cast<vtkIdType>(matrices.size()));
  for (std::size_t i = 0; i < matrices.size(); ++i)
  {
    for (int j = 0; j < 16; ++j)
    {
      array->SetTypedComponent(static_cast<vtkIdType>(i), j, matrices[i][j % 4][j / 4]);
    }
  }
  output->GetPointData()->AddArray(array);
}
}

//------------------------------------------------------------------------------
void MakeSkeleton(const Model& model, const SkeletonPose& pose, vtkPolyData* output)
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
  vtkNew<vtkPoints> points;
  points->SetDataType(VTK_DOUBLE);
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkIntArray> parents;
  parents->SetName("parent");
  vtkNew<vtkUnsignedCharArray> bones;
  bones->SetName("is_bone");
  vtkNew<vtkStringArray> names;
  names->SetName("name");
  for (std::size_t i = 0; i < model.Nodes.size(); ++i)
  {
    const ModelNode& node = model.Nodes[i];
    const glm::dvec4& at = pose.Now[i][3];
    points->InsertNextPoint(at.x, at.y, at.z);
    parents->InsertNextValue(node.Parent);
    bones->InsertNextValue(node.IsBone ? 1 : 0);
    names->InsertNextValue(node.Name);
    if (node.Parent >= 0 && joints[i] && joints[static_cast<std::size_t>(node.Parent)])
    {
      const vtkIdType ends[2] = { node.Parent, static_cast<vtkIdType>(i) };
      lines->InsertNextCell(2, ends);
    }
  }
  output->SetPoints(points);
  output->SetLines(lines);
  output->GetPointData()->AddArray(parents);
  output->GetPointData()->AddArray(bones);
  output->GetPointData()->AddArray(names);
  AddMatrices(PoseArray, pose.Now, output);
  AddMatrices(PoseBeforeArray, pose.Before, output);
  AddMatrices(PoseAfterArray, pose.After, output);
  vtkNew<vtkDoubleArray> share;
  share->SetName(KeyShareArray);
  share->InsertNextValue(pose.Share);
  output->GetFieldData()->AddArray(share);
}
}
