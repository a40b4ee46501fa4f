// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/** The transform of each bone of a mesh: as a matrix, or as a stretch and a rigid motion. */
#ifndef vtkRelievoSkinBones_h
#define vtkRelievoSkinBones_h

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include <string>
#include <vector>

class vtkPolyData;

namespace relievo
{
/// The bone's matrix, of any kind, as a stretch followed by a rotation and a translation.
template <typename Real>
struct BoneMotion
{
  glm::mat<3, 3, Real> Stretch;
  glm::vec<4, Real> Rotation;
  glm::vec<4, Real> Dual;
};

/// Rest to world for each bone of the mesh; with `keys`, blended from the whole keys around the
/// time. Returns "", or what is missing.
std::string GetBoneMatrices(
  vtkPolyData* mesh, vtkPolyData* skeleton, bool keys, std::vector<glm::dmat4>& matrices);

/// The rotation closest to the matrix, reversed if the matrix mirrors.
glm::dmat3 GetClosestRotation(const glm::dmat3& m);

template <typename Real>
BoneMotion<Real> GetMotion(const glm::dmat4& matrix);
extern template BoneMotion<float> GetMotion(const glm::dmat4& matrix);
extern template BoneMotion<double> GetMotion(const glm::dmat4& matrix);
}

#endif
