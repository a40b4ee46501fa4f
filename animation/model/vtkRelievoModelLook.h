// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Materials, lights and cameras of a model as VTK has them.
 */
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
  /// A decoded image by its name; null if there is none, or it is damaged.
  using FindImage = std::function<vtkImageData*(const std::string&)>;

  /// A property of one's own, with textures that all with the same image and sampler share.
  vtkSmartPointer<vtkProperty> MakeProperty(
    const ModelMaterial& material, bool placed, const FindImage& images);

  /// Of an unlit material its texture, for the actor, where VTK's shaders multiply with it; else
  /// null.
  vtkSmartPointer<vtkTexture> GetActorTexture(
    const ModelMaterial& material, bool placed, const FindImage& images);

private:
  // What becomes of an image's texels.
  enum Use
  {
    Color,       // decoded from sRGB by the graphics card
    OpaqueColor, // and alpha is left out
    Plain,       // as they are
    OpaquePlain,
    Occluded, // red is the occlusion of another image, or red alone counts
    White     // no image: one texel
  };
  using Key = std::pair<std::pair<std::string, std::string>, std::vector<int>>;

  vtkSmartPointer<vtkTexture> GetTexture(
    const ModelTexture& texture, const std::string& other, Use use, const FindImage& images);
  vtkSmartPointer<vtkTexture> GetMetalTexture(
    const ModelMaterial& material, const FindImage& images);

  std::map<Key, vtkSmartPointer<vtkTexture>> Textures;
};

/// A light where its node is, or so far back: color linear, intensity in candela or lux.
void PlaceLight(const ModelLight& light, const glm::dmat4& world, double back, vtkLight* output);

/// How far back suns have to stand for VTK to light by them: 0, unless it takes them for lamps.
double GetSunDistance(const Model& model);

void PlaceCamera(const ModelCamera& camera, const glm::dmat4& world, vtkCamera* output);

/// The exponent of the cosine that comes closest, over all directions within the outer cone, to
/// the fall-off of KHR_lights_punctual from an inner cone to an outer; angles in radians.
double FitSpotExponent(double inner, double outer);
}

#endif
