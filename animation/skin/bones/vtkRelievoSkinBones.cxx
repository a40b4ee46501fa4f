// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSkinBones.h"

#include "vtkRelievoFormulas.h"
#include "vtkRelievoSkinNames.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <glm/matrix.hpp>

#include <cmath>

namespace relievo
{
namespace
{
glm::dmat4 GetMatrix(vtkDataArray* array, vtkIdType tuple)
{
  glm::dmat4 m;
  for (int i = 0; i < 16; ++i)
  {
    m[i % 4][i / 4] = array->GetComponent(tuple, i);
  }
  return m;
}

bool HoldsMatrices(vtkDataArray* array)
{
  return array && array->GetNumberOfComponents() == 16;
}

double GetLargest(const glm::dmat3& m)
{
  double largest = 0.;
  for (int i = 0; i < 9; ++i)
  {
    largest = std::max(largest, std::abs(m[i / 3][i % 3]));
  }
  return largest;
}

// For a flattening matrix: makes its axes perpendicular, and replaces missing ones.
glm::dmat3 GetPerpendicular(const glm::dmat3& m)
{
  const auto direction = [](const glm::dvec3& v, double least) {
    const double length = glm::length(v);
    return length > least ? v / length : glm::dvec3(0.);
  };
  const double least = 1e-9 * GetLargest(m);
  glm::dvec3 x = direction(m[0], least);
  glm::dvec3 y = direction(m[1] - x * glm::dot(x, m[1]), least);
  glm::dvec3 z = direction(m[2] - x * glm::dot(x, m[2]) - y * glm::dot(y, m[2]), least);
  const auto across = [](const glm::dvec3& v) {
    const glm::dvec3 axis = std::abs(v.x) < 0.6 ? glm::dvec3(1., 0., 0.) : glm::dvec3(0., 1., 0.);
    return glm::normalize(glm::cross(v, axis));
  };
  if (x == glm::dvec3(0.))
  {
    x = y != glm::dvec3(0.) && z != glm::dvec3(0.)
      ? glm::cross(y, z)
      : (y != glm::dvec3(0.) ? across(y)
                             : (z != glm::dvec3(0.) ? across(z) : glm::dvec3(1., 0., 0.)));
  }
  if (y == glm::dvec3(0.))
  {
    y = z != glm::dvec3(0.) ? glm::cross(z, x) : across(x);
  }
  return glm::dmat3(x, y, glm::cross(x, y));
}
}

//------------------------------------------------------------------------------
std::string GetBoneMatrices(
  vtkPolyData* mesh, vtkPolyData* skeleton, bool keys, std::vector<glm::dmat4>& matrices)
{
  matrices.clear();
  vtkDataArray* nodes = mesh->GetFieldData()->GetArray(BoneNodeArray);
  vtkDataArray* offsets = mesh->GetFieldData()->GetArray(BoneOffsetArray);
  if (!nodes || !HoldsMatrices(offsets) ||
    nodes->GetNumberOfTuples() != offsets->GetNumberOfTuples())
  {
    return "the mesh has no bones: expected the field data bone_node, and bone_offset of 16 "
           "components for each, as vtkRelievoModelReader gives meshes at rest (Pose REST, Skin "
           "off)";
  }
  vtkDataArray* pose = skeleton->GetPointData()->GetArray(PoseArray);
  vtkDataArray* before = skeleton->GetPointData()->GetArray(PoseBeforeArray);
  vtkDataArray* after = skeleton->GetPointData()->GetArray(PoseAfterArray);
  vtkDataArray* share = skeleton->GetFieldData()->GetArray(KeyShareArray);
  if (!HoldsMatrices(pose))
  {
    return "the skeleton has no point array pose of 16 components";
  }
  if (keys &&
    (!HoldsMatrices(before) || !HoldsMatrices(after) || !share || share->GetNumberOfValues() == 0))
  {
    return "the skeleton has no whole keys: method key-matrix takes the point arrays pose_before "
           "and pose_after of 16 components, and the field data key_share";
  }
  for (vtkIdType i = 0; i < nodes->GetNumberOfTuples(); ++i)
  {
    const auto node = static_cast<vtkIdType>(nodes->GetComponent(i, 0));
    if (node < 0 || node >= pose->GetNumberOfTuples())
    {
      return "bone " + std::to_string(i) + " names point " + std::to_string(node) +
        " of a skeleton of " + std::to_string(pose->GetNumberOfTuples());
    }
    glm::dmat4 now = GetMatrix(pose, node);
    if (keys)
    {
      const double after1 = share->GetComponent(0, 0);
      now = GetMatrix(before, node) * (1. - after1) + GetMatrix(after, node) * after1;
    }
    matrices.push_back(now * GetMatrix(offsets, i));
  }
  return "";
}

//------------------------------------------------------------------------------
glm::dmat3 GetClosestRotation(const glm::dmat3& m)
{
  // Newton's iteration for the polar decomposition, after N. Higham (1986): quadratic convergence.
  // Far from size 1, an iteration only halves the size.
  const double size = GetLargest(m);
  glm::dmat3 q = size > 0. && std::isfinite(size) ? m / size : m;
  for (int i = 0; i < 40; ++i)
  {
    const double det = glm::determinant(q);
    if (!std::isfinite(det) || std::abs(det) < 1e-12 * std::pow(GetLargest(q), 3.) || det == 0.)
    {
      return GetPerpendicular(m);
    }
    const glm::dmat3 next = (q + glm::transpose(glm::inverse(q))) * 0.5;
    const double change = GetLargest(next - q);
    q = next;
    if (change < 1e-15)
    {
      break;
    }
  }
  return glm::determinant(q) < 0. ? -q : q;
}

//------------------------------------------------------------------------------
template <typename Real>
BoneMotion<Real> GetMotion(const glm::dmat4& matrix)
{
  const glm::dmat3 linear(matrix);
  const glm::dmat3 rotation = GetClosestRotation(linear);
  const glm::dvec4 q = f64::relievoQuaternionOf(rotation);
  BoneMotion<Real> motion;
  motion.Stretch = glm::mat<3, 3, Real>(glm::transpose(rotation) * linear);
  motion.Rotation = glm::vec<4, Real>(q);
  motion.Dual = glm::vec<4, Real>(f64::relievoDualOf(q, glm::dvec3(matrix[3])));
  return motion;
}

template BoneMotion<float> GetMotion(const glm::dmat4& matrix);
template BoneMotion<double> GetMotion(const glm::dmat4& matrix);
}
