// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/** Converts a model's materials, lights and cameras to VTK's. */
#ifndef vtkRelievoModelLook_h
#define vtkRelievoModelLook_h

#include "vtkRelievoModel.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkProperty.h"
#include "vtkTexture.h"

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace relievo
{
class ModelLook
{
public:
  /// A decoded image by name; null if it is missing or damaged.
  using FindImage = std::function<vtkImageData*(const std::string&)>;

  /// A new property; textures of equal image and sampler are shared.
  vtkSmartPointer<vtkProperty> MakeProperty(
    const ModelMaterial& material, bool placed, const FindImage& images);

  /// The texture of an unlit material, for the actor, where VTK's shaders multiply with it;
  /// otherwise null.
  vtkSmartPointer<vtkTexture> GetActorTexture(
    const ModelMaterial& material, bool placed, const FindImage& images);

private:
  // The use of an image's texels.
  enum Use
  {
    Color,       // decoded from sRGB by the graphics card
    OpaqueColor, // decoded from sRGB, without alpha
    Plain,       // unchanged
    OpaquePlain,
    Occluded, // red from another image's occlusion, or red alone
    White     // no image: one white texel
  };
  using Key = std::pair<std::pair<std::string, std::string>, std::vector<int>>;

  vtkSmartPointer<vtkTexture> GetTexture(
    const ModelTexture& texture, const std::string& other, Use use, const FindImage& images);
  vtkSmartPointer<vtkTexture> GetMetalTexture(
    const ModelMaterial& material, const FindImage& images);

  std::map<Key, vtkSmartPointer<vtkTexture>> Textures;
};

/// Puts a light at its node, or farther back by `back`: color linear, intensity in candela or
/// lux.
void PlaceLight(const ModelLight& light, const glm::dmat4& world, double back, vtkLight* output);

/// Distance that suns need so that VTK lights by them: 0, unless VTK treats them as lamps.
double GetSunDistance(const Model& model);

void PlaceCamera(const ModelCamera& camera, const glm::dmat4& world, vtkCamera* output);

/// The exponent of the cosine that best approximates, over all directions within the outer cone,
/// the fall-off of KHR_lights_punctual between an inner and an outer cone; angles in radians.
double FitSpotExponent(double inner, double outer);
}

#endif
