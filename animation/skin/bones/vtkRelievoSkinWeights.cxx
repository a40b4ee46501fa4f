// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSkinWeights.h"

#include "vtkRelievoSkinNames.h"

#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace relievo
{
namespace
{
// Converts numbers to integers; -1 for negative numbers and those that int cannot hold.
vtkSmartPointer<vtkIntArray> ToInts(vtkDataArray* array)
{
  vtkSmartPointer<vtkIntArray> ints = vtkIntArray::SafeDownCast(array);
  if (ints)
  {
    return ints;
  }
  ints = vtkSmartPointer<vtkIntArray>::New();
  const int type = array->GetDataType();
  if (type != VTK_FLOAT && array->GetDataTypeSize() < 4)
  {
    ints->DeepCopy(array);
    return ints;
  }
  const int components = array->GetNumberOfComponents();
  ints->SetNumberOfComponents(components);
  ints->SetNumberOfTuples(array->GetNumberOfTuples());
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    for (int k = 0; k < components; ++k)
    {
      const double joint = array->GetComponent(i, k);
      const bool fits = joint >= 0. && joint <= std::numeric_limits<int>::max();
      ints->SetTypedComponent(i, k, fits ? static_cast<int>(joint) : -1);
    }
  }
  return ints;
}

vtkSmartPointer<vtkFloatArray> ToFloats(vtkDataArray* array)
{
  vtkSmartPointer<vtkFloatArray> floats = vtkFloatArray::SafeDownCast(array);
  if (!floats)
  {
    floats = vtkSmartPointer<vtkFloatArray>::New();
    floats->DeepCopy(array);
  }
  return floats;
}
}

//------------------------------------------------------------------------------
std::string SkinWeights::Read(vtkPolyData* mesh)
{
  vtkDataArray* joints = mesh->GetPointData()->GetArray(JointsArray);
  vtkDataArray* weights = mesh->GetPointData()->GetArray(WeightsArray);
  const vtkIdType points = mesh->GetNumberOfPoints();
  if (!joints || !weights || joints->GetNumberOfComponents() != weights->GetNumberOfComponents() ||
    joints->GetNumberOfTuples() < points || weights->GetNumberOfTuples() < points)
  {
    return "the mesh has no point arrays joints and weights with as many components each";
  }
  for (vtkDataArray* follows :
    { mesh->GetPointData()->GetNormals(), mesh->GetPointData()->GetTangents() })
  {
    if (follows && follows->GetNumberOfTuples() < points)
    {
      const char* name = follows->GetName();
      return std::string("the point array ") + (name ? name : "of directions") + " has " +
        std::to_string(follows->GetNumberOfTuples()) + " tuples, for " + std::to_string(points) +
        " points";
    }
  }
  this->Joints = ToInts(joints);
  this->Weights = ToFloats(weights);
  this->First = this->Joints->GetPointer(0);
  this->FirstWeight = this->Weights->GetPointer(0);
  this->Count = joints->GetNumberOfComponents();
  return "";
}
}
