// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSkinPoints.h"

#include "vtkRelievoFormulas.h"
#include "vtkRelievoSkinBones.h"
#include "vtkRelievoSkinNames.h"
#include "vtkRelievoThreads.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cmath>
#include <vector>

namespace relievo
{
namespace
{
// Of either number type.
using f32::relievoDualTranslation;
using f32::relievoNormalMatrix;
using f32::relievoQuaternionMatrix;
using f64::relievoDualTranslation;
using f64::relievoNormalMatrix;
using f64::relievoQuaternionMatrix;

// What is done to the surroundings of one point.
template <typename Real>
struct Change
{
  glm::mat<3, 3, Real> Linear;
  glm::vec<3, Real> Move;
};

// The joints and weights of the points, as whole numbers and floats.
struct Influences
{
  const int* Joints;
  const float* Weights;
  int Count; // of each point
};

template <typename Real>
class MatrixBlend
{
public:
  explicit MatrixBlend(const std::vector<glm::dmat4>& matrices)
  {
    for (const glm::dmat4& m : matrices)
    {
      this->Bones.push_back(
        { glm::mat<3, 3, Real>(glm::dmat3(m)), glm::vec<3, Real>(glm::dvec3(m[3])) });
    }
  }

  // Whether the point has any bone.
  bool Get(const int* joints, const float* weights, int count, Change<Real>& change) const
  {
    change = { glm::mat<3, 3, Real>(Real(0)), glm::vec<3, Real>(Real(0)) };
    Real whole = 0;
    for (int i = 0; i < count; ++i)
    {
      const auto bone = static_cast<std::size_t>(joints[i]);
      const auto weight = static_cast<Real>(weights[i]);
      if (weight > Real(0) && bone < this->Bones.size())
      {
        change.Linear += this->Bones[bone].Linear * weight;
        change.Move += this->Bones[bone].Move * weight;
        whole += weight;
      }
    }
    if (whole != Real(1) && whole > Real(0))
    {
      change.Linear /= whole;
      change.Move /= whole;
    }
    return whole > Real(0);
  }

private:
  std::vector<Change<Real>> Bones;
};

template <typename Real>
class DualBlend
{
public:
  explicit DualBlend(const std::vector<glm::dmat4>& matrices)
  {
    for (const glm::dmat4& m : matrices)
    {
      this->Bones.push_back(GetMotion<Real>(m));
    }
  }

  bool Get(const int* joints, const float* weights, int count, Change<Real>& change) const
  {
    const BoneMotion<Real>* strongest = nullptr;
    Real most = 0;
    for (int i = 0; i < count; ++i)
    {
      const auto bone = static_cast<std::size_t>(joints[i]);
      if (static_cast<Real>(weights[i]) > most && bone < this->Bones.size())
      {
        most = static_cast<Real>(weights[i]);
        strongest = &this->Bones[bone];
      }
    }
    if (!strongest)
    {
      return false;
    }
    BoneMotion<Real> sum = { glm::mat<3, 3, Real>(Real(0)), glm::vec<4, Real>(Real(0)),
      glm::vec<4, Real>(Real(0)) };
    Real whole = 0;
    for (int i = 0; i < count; ++i)
    {
      const auto bone = static_cast<std::size_t>(joints[i]);
      const auto weight = static_cast<Real>(weights[i]);
      if (weight > Real(0) && bone < this->Bones.size())
      {
        const BoneMotion<Real>& motion = this->Bones[bone];
        // A quaternion and its negative are one rotation: those of the strongest bone's half.
        const Real side =
          glm::dot(motion.Rotation, strongest->Rotation) < Real(0) ? -weight : weight;
        sum.Rotation += motion.Rotation * side;
        sum.Dual += motion.Dual * side;
        sum.Stretch += motion.Stretch * weight;
        whole += weight;
      }
    }
    if (glm::dot(sum.Rotation, sum.Rotation) < Real(1e-12) * whole * whole)
    {
      sum.Rotation = strongest->Rotation; // turns that cancel have no mean
      sum.Dual = strongest->Dual;
    }
    change.Linear = relievoQuaternionMatrix(glm::normalize(sum.Rotation)) * (sum.Stretch / whole);
    change.Move = relievoDualTranslation(sum.Rotation, sum.Dual);
    return true;
  }

private:
  std::vector<BoneMotion<Real>> Bones;
};

// Arrays of three or four components that follow the points; null where there are none.
template <typename Real>
struct Arrays
{
  const Real* Points;
  Real* PointsOut;
  float* Normals;
  float* Tangents;
  int TangentComponents;
};

template <typename Real>
void Turn(const glm::mat<3, 3, Real>& m, float* v)
{
  const glm::vec<3, Real> turned = m * glm::vec<3, Real>(v[0], v[1], v[2]);
  const Real square = glm::dot(turned, turned);
  // What a flattening takes away keeps its direction.
  if (square > Real(0) && std::isfinite(square))
  {
    const Real length = std::sqrt(square);
    v[0] = static_cast<float>(turned.x / length);
    v[1] = static_cast<float>(turned.y / length);
    v[2] = static_cast<float>(turned.z / length);
  }
}

template <typename Real, typename Blend>
void Move(const Blend& blend, const Influences& influences, const Arrays<Real>& arrays,
  vtkIdType begin, vtkIdType end)
{
  for (vtkIdType i = begin; i < end; ++i)
  {
    Change<Real> change;
    const glm::vec<3, Real> p(
      arrays.Points[3 * i], arrays.Points[3 * i + 1], arrays.Points[3 * i + 2]);
    const vtkIdType first = i * influences.Count;
    const bool moved =
      blend.Get(influences.Joints + first, influences.Weights + first, influences.Count, change);
    const glm::vec<3, Real> at = moved ? change.Linear * p + change.Move : p;
    for (int j = 0; j < 3; ++j)
    {
      arrays.PointsOut[3 * i + j] = at[j];
    }
    if (moved && arrays.Normals)
    {
      Turn(relievoNormalMatrix(change.Linear), arrays.Normals + 3 * i);
    }
    if (moved && arrays.Tangents)
    {
      Turn(change.Linear, arrays.Tangents + arrays.TangentComponents * i);
    }
  }
}

template <typename Real>
void MoveAll(SkinMethod method, const std::vector<glm::dmat4>& matrices,
  const Influences& influences, const Arrays<Real>& arrays, vtkIdType count)
{
  const auto run = [&](const auto& blend) {
    vtkRelievoWithThreads([&]() {
      vtkSMPTools::For(0, count, 4096,
        [&](vtkIdType begin, vtkIdType end) { Move(blend, influences, arrays, begin, end); });
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

// A copy to be turned in place; the array that was there is shared with the input.
float* CopyDirections(vtkDataArray* array, vtkPointData* data, int attribute)
{
  vtkNew<vtkFloatArray> copy;
  copy->DeepCopy(array);
  copy->SetName(array->GetName());
  data->SetAttribute(copy, attribute);
  return copy->GetPointer(0);
}
}

//------------------------------------------------------------------------------
std::string SkinMesh(
  vtkPolyData* input, vtkPolyData* skeleton, SkinMethod method, vtkPolyData* output)
{
  output->Initialize();
  const vtkIdType count = input->GetNumberOfPoints();
  if (count == 0)
  {
    output->ShallowCopy(input);
    return "";
  }
  std::vector<glm::dmat4> matrices;
  const std::string wrong =
    GetBoneMatrices(input, skeleton, method == SkinMethod::KeyMatrix, matrices);
  if (!wrong.empty())
  {
    return wrong;
  }
  vtkDataArray* joints = input->GetPointData()->GetArray(JointsArray);
  vtkDataArray* weights = input->GetPointData()->GetArray(WeightsArray);
  if (!joints || !weights || joints->GetNumberOfComponents() != weights->GetNumberOfComponents())
  {
    return "the mesh has no point arrays joints and weights with as many components each";
  }
  output->ShallowCopy(input);
  // Skinned once: without these it is refused a second time.
  vtkNew<vtkFieldData> field;
  field->ShallowCopy(input->GetFieldData());
  field->RemoveArray(BoneNodeArray);
  field->RemoveArray(BoneOffsetArray);
  output->SetFieldData(field);
  if (vtkDataArray* normals = output->GetCellData()->GetNormals())
  {
    output->GetCellData()->RemoveArray(normals->GetName());
  }

  const auto wholes = As<vtkIntArray>(joints);
  const auto shares = As<vtkFloatArray>(weights);
  const Influences influences = { wholes->GetPointer(0), shares->GetPointer(0),
    joints->GetNumberOfComponents() };
  vtkPointData* data = output->GetPointData();
  vtkDataArray* normals = data->GetNormals();
  float* normalsOut = normals && normals->GetNumberOfComponents() == 3
    ? CopyDirections(normals, data, vtkDataSetAttributes::NORMALS)
    : nullptr;
  vtkDataArray* tangents = data->GetTangents();
  const int components = tangents ? tangents->GetNumberOfComponents() : 0;
  float* tangentsOut = components == 3 || components == 4
    ? CopyDirections(tangents, data, vtkDataSetAttributes::TANGENTS)
    : nullptr;

  vtkNew<vtkPoints> points;
  if (auto* wide = vtkDoubleArray::SafeDownCast(input->GetPoints()->GetData()))
  {
    points->SetDataType(VTK_DOUBLE);
    points->SetNumberOfPoints(count);
    double* to = vtkDoubleArray::SafeDownCast(points->GetData())->GetPointer(0);
    MoveAll<double>(method, matrices, influences,
      { wide->GetPointer(0), to, normalsOut, tangentsOut, components }, count);
  }
  else
  {
    const auto from = As<vtkFloatArray>(input->GetPoints()->GetData());
    points->SetDataType(VTK_FLOAT);
    points->SetNumberOfPoints(count);
    float* to = vtkFloatArray::SafeDownCast(points->GetData())->GetPointer(0);
    MoveAll<float>(method, matrices, influences,
      { from->GetPointer(0), to, normalsOut, tangentsOut, components }, count);
  }
  output->SetPoints(points);
  return "";
}
}
