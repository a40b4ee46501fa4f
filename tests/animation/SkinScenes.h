// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkinScenes.h
 * @brief Meshes with bones, made in memory as vtkRelievoSkin wants them.
 */
#ifndef SkinScenes_h
#define SkinScenes_h

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <string>
#include <vector>

namespace relievoTest
{
/** A rotation by an angle in radians about an axis through the origin, by Rodrigues's formula. */
glm::dmat4 TurnAbout(const glm::dvec3& axis, double angle);

/** A move. */
glm::dmat4 MoveBy(const glm::dvec3& by);

/** A tuple of 16 components for each matrix, by rows. */
vtkSmartPointer<vtkDataArray> MatrixArray(
  const char* name, const std::vector<glm::dmat4>& matrices);

/** A skeleton of these matrices, as the present pose and as whole keys before and after. */
vtkSmartPointer<vtkPolyData> MakeSkeleton(const std::vector<glm::dmat4>& pose);
vtkSmartPointer<vtkPolyData> MakeSkeleton(
  const std::vector<glm::dmat4>& before, const std::vector<glm::dmat4>& after, double share);

/** A tube of radius 1 around x from 0 to 4, `rings` rings of `sides` points, with normals. */
vtkSmartPointer<vtkPolyData> MakeTube(int rings, int sides, bool wide);

/**
 * Gives the mesh bones with these offsets (bone i is node i), and each point's joints and weights,
 * `components` of each.
 */
void SetBones(vtkPolyData* mesh, const std::vector<glm::dmat4>& offsets, int components,
  const std::vector<int>& joints, const std::vector<float>& weights);

/** Bone 0 holds the tube's end at x = 0, bone 1 that at x = 4; linear weights between. */
vtkSmartPointer<vtkPolyData> MakeTwoBoneTube(int rings, int sides, bool wide = false);

/** The mesh moved with vtkRelievoSkin. */
vtkSmartPointer<vtkPolyData> Skin(vtkPolyData* mesh, vtkPolyData* skeleton, int method);

glm::dvec3 PointOf(vtkPolyData* mesh, vtkIdType i);
}

#endif
