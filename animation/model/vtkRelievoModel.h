// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A model with bones as it comes out of a file: nodes, meshes, animations. All in double.
 */
#ifndef vtkRelievoModel_h
#define vtkRelievoModel_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <map>
#include <string>
#include <vector>

namespace relievo
{
/// A node of the tree. Parents stand before their children; the root's parent is -1.
struct ModelNode
{
  std::string Name;
  int Parent = -1;
  glm::dmat4 Rest = glm::dmat4(1.); ///< to the parent
  bool IsBone = false;              ///< of a mesh
};

/// What lies between keys.
enum class KeyMode
{
  Linear, ///< rotations: slerp or nlerp
  Step,   ///< the key before
  Cubic   ///< Hermite splines
};

/// A value at times in seconds, which ascend; two keys at one time are a jump.
template <typename Value>
struct ModelTrack
{
  std::vector<double> Times;
  std::vector<Value> Values;
  KeyMode Mode = KeyMode::Linear;
  std::vector<Value> Before; ///< Cubic only: slope a second on the way to the key
  std::vector<Value> After;  ///< and from it on
};

/// What moves one node. A track without keys leaves what the node has at rest.
struct ModelChannel
{
  int Node = 0;
  ModelTrack<glm::dvec3> Position;
  ModelTrack<glm::dvec4> Rotation; ///< unit quaternions x, y, z, w
  ModelTrack<glm::dvec3> Scale;
};

struct ModelAnimation
{
  std::string Name; ///< no two alike in a model
  int Number = 0;   ///< among those of the file
  double Start = 0.;
  double End = 0.;
  std::vector<ModelChannel> Channels;
  std::vector<double> KeyTimes; ///< of all channels, each once
};

/// A mesh in the model's rest space, with all that the filter wants.
struct ModelMesh
{
  std::string Name;
  vtkSmartPointer<vtkPolyData> Data;
};

/// An image in the model's file: of an image's file the bytes, or texels.
struct ModelImage
{
  std::vector<unsigned char> Bytes;
  std::string Format; ///< of a file, as the model has it: "png", "tga", or nothing
  int Width = 0; ///< 0: a file; otherwise each texel has red, green, blue, alpha, the top row first
  int Height = 0;
};

struct Model
{
  std::vector<ModelNode> Nodes;
  std::vector<ModelMesh> Meshes;
  std::vector<ModelAnimation> Animations;
  std::map<std::string, ModelImage> Images; ///< by the names that meshes have for them
  std::vector<std::string> Notes;           ///< what was left out or mended, a sentence each
};

/// Node to world, for every node, from node to parent.
std::vector<glm::dmat4> GetWorldMatrices(
  const std::vector<ModelNode>& nodes, const std::vector<glm::dmat4>& locals);
}

#endif
