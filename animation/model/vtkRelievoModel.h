// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/** A model with bones as read from a file: nodes, meshes, animations. All in double. */
#ifndef vtkRelievoModel_h
#define vtkRelievoModel_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <map>
#include <optional>
#include <string>
#include <valarray>
#include <vector>

namespace relievo
{
/// A node's transform in three parts; anything else (shear) is lost.
struct NodeParts
{
  glm::dvec3 Position = glm::dvec3(0.);
  glm::dvec4 Rotation = glm::dvec4(0., 0., 0., 1.); ///< a unit quaternion x, y, z, w
  glm::dvec3 Scale = glm::dvec3(1.);
};

/// A node of the tree. Parents come before their children; the root's parent is -1.
struct ModelNode
{
  std::string Name;
  int Parent = -1;
  glm::dmat4 Rest = glm::dmat4(1.); ///< matrix to the parent
  std::optional<NodeParts> Parts;   ///< of Rest, if the file has them
  bool IsBone = false;              ///< a bone of a mesh
};

/// The interpolation between keys.
enum class KeyMode
{
  Linear, ///< rotations: slerp or nlerp
  Step,   ///< the previous key
  Cubic   ///< Hermite splines
};

/// Values at ascending times in seconds; two keys at one time are a jump.
template <typename Value>
struct ModelTrack
{
  std::vector<double> Times;
  std::vector<Value> Values;
  KeyMode Mode = KeyMode::Linear;
  std::vector<Value> Before; ///< Cubic only: slope per second arriving at the key
  std::vector<Value> After;  ///< and leaving it
};

/// The movement of one node. A track without keys keeps the node's value at rest.
struct ModelChannel
{
  int Node = 0;
  ModelTrack<glm::dvec3> Position;
  ModelTrack<glm::dvec4> Rotation; ///< unit quaternions x, y, z, w
  ModelTrack<glm::dvec3> Scale;
};

/// The weights of the morph targets of one node's meshes.
using ModelWeights = std::valarray<double>;

struct ModelMorphChannel
{
  int Node = 0;
  ModelTrack<ModelWeights> Weights;
};

struct ModelAnimation
{
  std::string Name; ///< unique in a model
  double Start = 0.;
  double End = 0.;
  std::vector<ModelChannel> Channels;
  std::vector<ModelMorphChannel> Morphs;
  std::vector<double> KeyTimes; ///< of all channels, without duplicates
};

/// The offsets that a morph target of full weight adds to the points, normals and tangents of a
/// mesh at rest, three numbers per point; empty: none.
struct ModelMorph
{
  std::vector<float> Points;
  std::vector<float> Normals;
  std::vector<float> Tangents;
};

/// A mesh in the model's rest space, with everything that the filter needs.
struct ModelMesh
{
  std::string Name;
  vtkSmartPointer<vtkPolyData> Data;
  int Node = 0;      ///< its node
  int Material = -1; ///< index in the model; -1: see the mesh's field data
  std::vector<ModelMorph> Morphs;
  bool IsPlaced = false;  ///< transformed by its node at rest
  bool IsSkinned = false; ///< moved by bones instead of its node
  bool IsFaceted = false; ///< without normals in the file: a face's points have its normal
};

/// A texture of a material.
struct ModelTexture
{
  std::string Image;      ///< the name among the model's images; empty: no texture
  int Wrap[2] = { 1, 1 }; ///< along u and v, as vtkTexture has them
  bool Smooth = true;     ///< interpolated between texels
  bool Mipmaps = true;
  int Coordinates = 0;                   ///< the mesh's set of coordinates
  glm::dmat3 Transform = glm::dmat3(1.); ///< for coordinates with v downwards
};

enum class AlphaMode
{
  Opaque, ///< alpha is ignored
  Mask,   ///< not drawn where alpha is below the cutoff
  Blend
};

/// A material as in glTF; colours are linear.
struct ModelMaterial
{
  std::string Name;
  glm::dvec4 BaseColor = glm::dvec4(1.);
  double Metallic = 1.;
  double Roughness = 1.;
  double NormalScale = 1.;
  double OcclusionStrength = 1.;
  glm::dvec3 Emission = glm::dvec3(0.);
  AlphaMode Alpha = AlphaMode::Opaque;
  double AlphaCutoff = 0.5;
  bool IsDoubleSided = false;
  bool IsUnlit = false;
  ModelTexture BaseColorTexture;
  ModelTexture MetalTexture; ///< green is roughness, blue is metal
  ModelTexture NormalTexture;
  ModelTexture OcclusionTexture; ///< in its red channel
  ModelTexture EmissionTexture;
};

/// A light at a node, shining along its -z.
struct ModelLight
{
  enum class Kind
  {
    Sun,
    Point,
    Spot
  };
  std::string Name;
  Kind Is = Kind::Point;
  int Node = 0;
  glm::dvec3 Color = glm::dvec3(1.); ///< linear
  double Intensity = 1.;             ///< candela; lux for suns
  double Range = 0.;                 ///< beyond which it does not shine; 0: unlimited
  double InnerCone = 0.;             ///< half of the opening angle, in radians
  double OuterCone = 0.;
};

/// A camera at a node, looking along its -z.
struct ModelCamera
{
  std::string Name;
  int Node = 0;
  bool IsPerspective = true;
  double Height = 1.; ///< vertical opening in radians, or half of the height
  double Near = 0.;
  double Far = 0.; ///< 0: unlimited
};

/// An image in the model's file: the bytes of an image file, or texels.
struct ModelImage
{
  std::vector<unsigned char> Bytes;
  std::string Format; ///< of a file, as the model has it: "png", "image/tga", a name, or nothing
  int Width =
    0; ///< 0: a file; otherwise each texel has red, green, blue, alpha, with the top row first
  int Height = 0;
};

struct Model
{
  std::vector<ModelNode> Nodes;
  std::vector<ModelMesh> Meshes;
  std::vector<ModelWeights> Weights; ///< of morph targets at rest, by nodes; may be empty
  std::vector<ModelAnimation> Animations;
  std::vector<ModelMaterial> Materials;
  std::vector<ModelLight> Lights;
  std::vector<ModelCamera> Cameras;
  std::map<std::string, ModelImage> Images; ///< by the meshes' names for them
  std::vector<std::string> Notes;           ///< parts left out or repaired, a sentence each
};

/// Node to world for every node, computed from node to parent.
std::vector<glm::dmat4> GetWorldMatrices(
  const std::vector<ModelNode>& nodes, const std::vector<glm::dmat4>& locals);
}

#endif
