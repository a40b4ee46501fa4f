// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The surfaces that an actor draws, as glTF needs them: a mesh with its colours mapped.
 */
#ifndef GltfSurface_h
#define GltfSurface_h

#include "SceneNames.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <memory>
#include <string>
#include <vector>

class vtkActor;
class vtkMatrix4x4;
class vtkRelievoGlyphPlaces;

namespace scene
{
struct GltfSurface
{
  enum class ColorsOf
  {
    Points,
    Cells,
    Places
  };
  vtkActor* Actor = nullptr;
  int Number = 0; ///< among the actor's surfaces
  vtkSmartPointer<vtkPolyData> Mesh;
  glm::dmat4 MeshToWorld = glm::dmat4(1.);
  glm::dvec3 Color = glm::dvec3(1.); ///< where neither Colors nor Map give one
  double Opacity = 1.;
  vtkSmartPointer<vtkUnsignedCharArray> Colors; ///< red, green, blue, alpha; null: none
  ColorsOf Of = ColorsOf::Points;
  vtkSmartPointer<vtkImageData> Map;            ///< a colour map as a texture; null: none
  vtkSmartPointer<vtkDataArray> MapCoordinates; ///< of the points
  /// Glyphs: from the mesh to the actor's coordinates, and the tuple of Colors for each place.
  std::shared_ptr<const std::vector<glm::dmat4>> Places;
  std::shared_ptr<const std::vector<vtkIdType>> Points;
};

/// Appends an actor's surfaces. Returns the reason if the actor, or a part of it, has none.
std::string CollectSurfaces(vtkActor* actor, vtkMatrix4x4* matrix, vtkRelievoGlyphPlaces& glyphs,
  std::vector<GltfSurface>& surfaces);
}

#endif
