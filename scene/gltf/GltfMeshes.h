// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The meshes of a glTF file, the nodes that place them, and their animation.
 */
#ifndef GltfMeshes_h
#define GltfMeshes_h

#include "GltfBuffer.h"
#include "GltfMaterials.h"
#include "GltfShape.h"
#include "SceneNames.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

class vtkActor;

namespace scene
{
struct GltfSurface;

/// The scene at a time of its animation.
struct GltfKey
{
  double Seconds = 0.;
  GltfPlace Camera;
  std::map<std::pair<vtkActor*, int>, GltfShape> Shapes; ///< of actors' surfaces, by number
};

class GltfMeshes
{
public:
  /// `times`: those of the keys, in seconds; empty: the scene rests.
  GltfMeshes(GltfBuffer& buffer, GltfMaterials& materials, std::set<std::string>& notes,
    const std::vector<double>& times);

  /// Adds the surface as drawn: triangles, lines and points, each with its material. `keys` has its
  /// shape at each time, null where it is not drawn. Returns the index of its node; none if nothing
  /// of it is drawn.
  std::optional<std::size_t> Add(const GltfSurface& surface, const GltfShape& shape,
    const std::string& name, const std::vector<const GltfShape*>& keys);

  /// Animates a node by its places at the times of the keys. Constant places add nothing.
  void Move(std::size_t node, const std::vector<GltfPlace>& places);

  /// Adds the animation, if something moves.
  void Finish();

private:
  using Json = GltfBuffer::Json;

  std::size_t GetTimes();
  void AddChannel(
    std::size_t node, const char* path, const std::vector<float>& values, std::size_t components);
  void AddMorphs(Json& mesh, const GltfShape& shape, const std::vector<const GltfShape*>& keys);

  GltfBuffer& Buffer;
  GltfMaterials& Materials;
  std::set<std::string>& Notes;
  std::vector<double> Times;
  std::optional<std::size_t> TimesAccessor;
  Json Channels = Json::array();
  Json Samplers = Json::array();
};
}

#endif
