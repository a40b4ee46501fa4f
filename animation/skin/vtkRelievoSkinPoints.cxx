// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSkinPoints.h"

#include "vtkRelievoFormulas.h"
#include "vtkRelievoSkinBlend.h"
#include "vtkRelievoSkinBones.h"
#include "vtkRelievoSkinNames.h"
#include "vtkRelievoSkinOrigin.h"
#include "vtkRelievoSkinWeights.h"
#include "vtkRelievoThreads.h"

#include "vtkAlgorithm.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <vector>

namespace relievo
{
namespace
{
// Directions that move with the points, of three or four components; null if there are none.
struct Directions
{
  const float* From = nullptr;
  float* To = nullptr;
  int Components = 3;
};

template <typename Real>
struct Arrays
{
  const Real* From;
  Real* To;
  glm::vec<3, Real> Middle; // of the points at rest; the matrices are relative to it
  Directions Normals;
  Directions Tangents;
};

// Points without a bone keep their directions.
template <typename Real>
void Turn(const glm::mat<3, 3, Real>& m, const Directions& directions, vtkIdType i, bool normals,
  bool moved)
{
  // For both number types.
  using f32::relievoTurnDirection;
  using f32::relievoTurnNormal;
  using f64::relievoTurnDirection;
  using f64::relievoTurnNormal;
  const float* from = directions.From + directions.Components * i;
  float* to = directions.To + directions.Components * i;
  const glm::vec<3, Real> own(from[0], from[1], from[2]);
  const glm::vec<3, Real> turned =
    normals ? relievoTurnNormal(m, own) : relievoTurnDirection(m, own);
  for (int j = 0; j < 3; ++j)
  {
    to[j] = static_cast<float>(moved ? turned[j] : own[j]);
  }
  if (directions.Components == 4)
  {
    to[3] = from[3];
  }
}

// Everything called is inlined: calls for each point would double the time.
template <typename Real, typename Blend>
[[gnu::flatten]] void Move(const Blend& blend, const SkinWeights& weights,
  const Arrays<Real>& arrays, vtkIdType begin, vtkIdType end)
{
  for (vtkIdType i = begin; i < end; ++i)
  {
    SkinChange<Real> change;
    const Real* p = arrays.From + 3 * i;
    const bool moved =
      blend.Get(weights.GetJoints(i), weights.GetWeights(i), weights.GetCount(), change);
    Four<Real> at = change.Columns[3];
    for (std::size_t j = 0; j < 3; ++j)
    {
      at.Add(change.Columns[j], p[j] - arrays.Middle[static_cast<int>(j)]);
    }
    for (int j = 0; j < 3; ++j)
    {
      arrays.To[3 * i + j] = moved ? at.V[j] : p[j];
    }
    if (arrays.Normals.To)
    {
      Turn(change.GetLinear(), arrays.Normals, i, true, moved);
    }
    if (arrays.Tangents.To)
    {
      Turn(change.GetLinear(), arrays.Tangents, i, false, moved);
    }
  }
}

template <typename Real>
void MoveAll(SkinMethod method, const std::vector<glm::dmat4>& matrices, const SkinWeights& weights,
  const Arrays<Real>& arrays, vtkIdType count)
{
  const auto run = [&](const auto& blend) {
    vtkRelievoWithThreads([&]() {
      vtkSMPTools::For(0, count, 4096,
        [&](vtkIdType begin, vtkIdType end) { Move(blend, weights, arrays, begin, end); });
    });
  };
  if (method == SkinMethod::DualQuaternion)
  {
    run(DualBlend<Real>(matrices));
  }
  else
  {
    run(MatrixBlend<Real>(matrices));
  }
}

template <typename Array>
vtkSmartPointer<Array> As(vtkDataArray* array)
{
  vtkSmartPointer<Array> typed = Array::SafeDownCast(array);
  if (!typed)
  {
    typed = vtkSmartPointer<Array>::New();
    typed->DeepCopy(array);
  }
  return typed;
}

// Directions of the input, and the output's new array that replaces them. `owned` has the input.
Directions MakeDirections(vtkDataArray* array, int attribute, vtkIdType count, vtkPointData* data,
  std::vector<vtkSmartPointer<vtkFloatArray>>& owned)
{
  Directions directions;
  if (!array || (array->GetNumberOfComponents() != 3 && array->GetNumberOfComponents() != 4) ||
    (attribute == vtkDataSetAttributes::NORMALS && array->GetNumberOfComponents() != 3))
  {
    return directions;
  }
  owned.push_back(As<vtkFloatArray>(array));
  vtkNew<vtkFloatArray> moved;
  moved->SetName(array->GetName());
  moved->SetNumberOfComponents(array->GetNumberOfComponents());
  moved->SetNumberOfTuples(count);
  directions.From = owned.back()->GetPointer(0);
  directions.To = moved->GetPointer(0);
  directions.Components = array->GetNumberOfComponents();
  data->SetAttribute(moved, attribute);
  return directions;
}
}

//------------------------------------------------------------------------------
void TakeBones(vtkPolyData* mesh)
{
  vtkNew<vtkFieldData> field;
  field->ShallowCopy(mesh->GetFieldData());
  field->RemoveArray(BoneNodeArray);
  field->RemoveArray(BoneOffsetArray);
  mesh->SetFieldData(field);
}

//------------------------------------------------------------------------------
std::string SkinMesh(
  vtkPolyData* input, vtkPolyData* skeleton, SkinMethod method, int precision, vtkPolyData* output)
{
  output->Initialize();
  const vtkIdType count = input->GetNumberOfPoints();
  if (count == 0)
  {
    output->ShallowCopy(input);
    return "";
  }
  std::vector<glm::dmat4> matrices;
  const std::string error =
    GetBoneMatrices(input, skeleton, method == SkinMethod::KeyMatrix, matrices);
  if (!error.empty())
  {
    return error;
  }
  SkinWeights weights;
  const std::string missing = weights.Read(input);
  if (!missing.empty())
  {
    return missing;
  }
  output->ShallowCopy(input);
  TakeBones(output); // without bones, a second skinning is refused
  if (vtkDataArray* normals = output->GetCellData()->GetNormals())
  {
    output->GetCellData()->RemoveArray(normals->GetName());
  }

  vtkPointData* data = output->GetPointData();
  std::vector<vtkSmartPointer<vtkFloatArray>> owned;
  const Directions normals = MakeDirections(
    input->GetPointData()->GetNormals(), vtkDataSetAttributes::NORMALS, count, data, owned);
  const Directions tangents = MakeDirections(
    input->GetPointData()->GetTangents(), vtkDataSetAttributes::TANGENTS, count, data, owned);

  // Relative to the mesh's middle, matrices that cancel far from the origin lose no digits.
  const glm::dvec3 middle = GetFarOrigin(GetBox(input));
  matrices = GetMatricesAbout(matrices, middle, glm::dvec3(0.));
  vtkDataArray* rest = input->GetPoints()->GetData();
  vtkNew<vtkPoints> points;
  if (rest->GetDataType() == VTK_DOUBLE || precision == vtkAlgorithm::DOUBLE_PRECISION)
  {
    const auto from = As<vtkDoubleArray>(rest);
    points->SetDataType(VTK_DOUBLE);
    points->SetNumberOfPoints(count);
    double* to = vtkDoubleArray::SafeDownCast(points->GetData())->GetPointer(0);
    MoveAll<double>(
      method, matrices, weights, { from->GetPointer(0), to, middle, normals, tangents }, count);
  }
  else
  {
    const auto from = As<vtkFloatArray>(rest);
    points->SetDataType(VTK_FLOAT);
    points->SetNumberOfPoints(count);
    float* to = vtkFloatArray::SafeDownCast(points->GetData())->GetPointer(0);
    MoveAll<float>(method, matrices, weights,
      { from->GetPointer(0), to, glm::vec3(middle), normals, tangents }, count);
  }
  if (precision == vtkAlgorithm::SINGLE_PRECISION && points->GetDataType() == VTK_DOUBLE)
  {
    vtkNew<vtkPoints> single;
    single->SetDataType(VTK_FLOAT);
    single->DeepCopy(points);
    output->SetPoints(single);
    return "";
  }
  output->SetPoints(points);
  return "";
}
}
