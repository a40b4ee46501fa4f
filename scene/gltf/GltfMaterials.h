// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The materials and textures of a glTF file, from the properties of actors.
 */
#ifndef GltfMaterials_h
#define GltfMaterials_h

#include "GltfBuffer.h"
#include "SceneNames.h"

#include "vtkImageData.h" // for the images
#include "vtkSmartPointer.h"

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

class vtkActor;
class vtkTexture;

namespace scene
{
struct GltfSurface;

class GltfMaterials
{
public:
  using Json = GltfBuffer::Json;

  GltfMaterials(GltfBuffer& buffer, std::set<std::string>& notes)
    : Buffer(buffer)
    , Notes(notes)
  {
  }

  /// The index of the surface's material; equal materials are one. Without texture coordinates,
  /// the actor's textures are left out. PBR materials keep their values; of others, glTF knows the
  /// diffuse colour, and a roughness with highlights as wide as those of the specular power.
  std::size_t Find(const GltfSurface& surface, bool hasCoordinates, bool isLit);

  /// The materials of surfaces with linear colours.
  const std::set<std::size_t>& GetLinear() const { return this->WithLinearColors; }

  /// Actors of which a texture is left out.
  const std::set<vtkActor*>& GetPartial() const { return this->Partial; }

private:
  /// A colour map as an image whose colours are sRGB.
  vtkSmartPointer<vtkImageData> Code(vtkImageData* map, bool isLinear);

  /// The reference to a texture; null if its image cannot be stored.
  Json Refer(vtkTexture* texture);
  Json Refer(vtkImageData* image, int wrapU, int wrapV, bool isSmooth, bool hasMipmaps);

  GltfBuffer& Buffer;
  std::set<std::string>& Notes;
  std::map<std::string, std::size_t> Materials, Textures;
  std::map<vtkSmartPointer<vtkImageData>, std::size_t> Images;
  std::map<vtkSmartPointer<vtkImageData>, vtkSmartPointer<vtkImageData>> Coded;
  std::set<vtkActor*> Partial;
  std::set<std::size_t> WithLinearColors;
};

/// Whether the values of an actor's colours are linear light, as they are for PBR.
bool HasLinearColors(const GltfSurface& surface);

/// An actor's colour as linear light.
double ToLinear(double value, bool isLinear);

/// A colour of points or cells, or of a colour map, as linear light.
double ToLinearFromMapped(double value, bool isLinear);
}

#endif
