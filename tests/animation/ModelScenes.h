// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ModelScenes.h
 * @brief Models made in memory, written by Assimp in its own binary format, and read back.
 */
#ifndef ModelScenes_h
#define ModelScenes_h

#include <vtkSmartPointer.h>

#include <assimp/scene.h>

#include <memory>
#include <string>
#include <vector>

class vtkPolyData;
class vtkRelievoModelReader;

namespace relievoTest
{
struct Key
{
  double Time;
  aiQuaternion Turn;
};

/** A turn about z; `sign` chooses which of its two quaternions. */
aiQuaternion AboutZ(double degrees, float sign = 1.f);

/** A channel of rotations, without a move or a scale. */
aiNodeAnim* MakeChannel(const std::string& node, const std::vector<Key>& keys);

/**
 * A triangle with its first corner at (1, 0, 0), on a bone "arm" that these keys turn about z. 10
 * ticks a second.
 */
std::unique_ptr<aiScene> MakeScene(const std::vector<Key>& keys);

/** Two animations named "turn": by 90 degrees in a second, and one that holds -30. */
std::unique_ptr<aiScene> MakeTwo();

/** The scene through a file of that name. */
vtkSmartPointer<vtkRelievoModelReader> Read(const aiScene& scene, const std::string& name);

vtkPolyData* MeshOf(vtkRelievoModelReader* reader);

/** Degrees that the triangle's first corner is turned at a time; also checks its distance. */
double AngleAt(vtkRelievoModelReader* reader, double seconds);
}

#endif
