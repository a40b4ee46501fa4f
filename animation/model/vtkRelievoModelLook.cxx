// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoModelLook.h"

#include "vtkRelievoFormulas.h"
#include "vtkRelievoVTKVersions.h"
#include "vtkRelievoWrapTexture.h"

#include "vtkBoundingBox.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace relievo
{
namespace
{
constexpr double Degrees = 57.29577951308232;

vtkSmartPointer<vtkImageData> MakeImage(int width, int height, int components)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, components);
  return image;
}

// Bytes of red, green, blue and, if it counts, alpha; grey fills all three.
vtkSmartPointer<vtkImageData> ToBytes(vtkImageData* image, bool alpha)
{
  vtkDataArray* from = image->GetPointData()->GetScalars();
  const int own = from->GetNumberOfComponents();
  const bool hasAlpha = alpha && own % 2 == 0;
  const int components = hasAlpha ? 4 : 3;
  const double factor = from->GetDataType() == VTK_UNSIGNED_CHAR ? 1.
    : from->GetDataType() == VTK_UNSIGNED_SHORT                  ? 255. / 65535.
                                                                 : 255.;
  if (factor == 1. && own == components)
  {
    return image;
  }
  int size[3];
  image->GetDimensions(size);
  vtkSmartPointer<vtkImageData> bytes = MakeImage(size[0], size[1], components);
  auto* to = static_cast<unsigned char*>(bytes->GetScalarPointer());
  for (vtkIdType i = 0; i < from->GetNumberOfTuples(); ++i)
  {
    for (int j = 0; j < components; ++j)
    {
      const int source = j == 3 ? own - 1 : own < 3 ? 0 : j;
      const double level = factor * from->GetComponent(i, source);
      *to++ = static_cast<unsigned char>(std::lround(std::clamp(level, 0., 255.)));
    }
  }
  return bytes;
}

// Green and blue of one image with red of another, at the larger size; null: 255.
vtkSmartPointer<vtkImageData> MergeOcclusion(vtkImageData* metal, vtkImageData* occlusion)
{
  int sizes[2][3] = { { 1, 1, 1 }, { 1, 1, 1 } };
  vtkSmartPointer<vtkImageData> sources[2];
  for (int i = 0; i < 2; ++i)
  {
    if (vtkImageData* image = i == 0 ? metal : occlusion)
    {
      sources[i] = ToBytes(image, false);
      sources[i]->GetDimensions(sizes[i]);
    }
  }
  const int width = std::max(sizes[0][0], sizes[1][0]);
  const int height = std::max(sizes[0][1], sizes[1][1]);
  vtkSmartPointer<vtkImageData> merged = MakeImage(width, height, 3);
  auto* to = static_cast<unsigned char*>(merged->GetScalarPointer());
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      for (int j = 0; j < 3; ++j)
      {
        const int i = j == 0 ? 1 : 0;
        // 64 bits: the product of two sides may exceed 32.
        const auto scale = [](int at, int own, int all) {
          return static_cast<int>(static_cast<std::int64_t>(at) * own / all);
        };
        *to++ = sources[i] ? static_cast<unsigned char*>(sources[i]->GetScalarPointer(
                               scale(x, sizes[i][0], width), scale(y, sizes[i][1], height), 0))[j]
                           : static_cast<unsigned char>(255);
      }
    }
  }
  return merged;
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkTexture> ModelLook::GetTexture(
  const ModelTexture& texture, const std::string& other, Use use, const FindImage& images)
{
  const Key key = { { texture.Image, other },
    { texture.Wrap[0], texture.Wrap[1], texture.Smooth, texture.Mipmaps, use } };
  const auto [found, isNew] = this->Textures.emplace(key, nullptr);
  if (!isNew)
  {
    return found->second;
  }
  vtkSmartPointer<vtkImageData> image = texture.Image.empty() ? nullptr : images(texture.Image);
  if (use == Occluded)
  {
    vtkSmartPointer<vtkImageData> occlusion = other.empty() ? nullptr : images(other);
    image = image || occlusion ? MergeOcclusion(image, occlusion) : nullptr;
  }
  else if (use == White)
  {
    image = MakeImage(1, 1, 3);
    std::fill_n(
      static_cast<unsigned char*>(image->GetScalarPointer()), 3, static_cast<unsigned char>(255));
  }
  else if (image)
  {
    image = ToBytes(image, use == Color || use == Plain);
  }
  if (!image)
  {
    return nullptr;
  }
  vtkNew<vtkRelievoWrapTexture> made;
  made->SetInputData(image);
  made->SetWrap(texture.Wrap[0]); // for code that knows only vtkTexture
  made->SetWrapU(texture.Wrap[0]);
  made->SetWrapV(texture.Wrap[1]);
  made->SetInterpolate(texture.Smooth);
  made->SetMipmap(texture.Smooth && texture.Mipmaps);
  made->SetUseSRGBColorSpace(use == Color || use == OpaqueColor || use == White);
  found->second = made.Get();
  return found->second;
}

//------------------------------------------------------------------------------
// VTK expects occlusion, roughness and metal in one texture.
vtkSmartPointer<vtkTexture> ModelLook::GetMetalTexture(
  const ModelMaterial& material, const FindImage& images)
{
  const ModelTexture& metal = material.MetalTexture;
  const ModelTexture& occlusion = material.OcclusionTexture;
  if (occlusion.Image.empty() || occlusion.Image == metal.Image)
  {
    return metal.Image.empty() ? nullptr : this->GetTexture(metal, "", OpaquePlain, images);
  }
  ModelTexture both = metal.Image.empty() ? occlusion : metal;
  both.Image = metal.Image;
  return this->GetTexture(both, occlusion.Image, Occluded, images);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkProperty> ModelLook::MakeProperty(
  const ModelMaterial& material, bool placed, const FindImage& images)
{
  auto property = vtkSmartPointer<vtkProperty>::New();
  property->SetBackfaceCulling(!material.IsDoubleSided);
  const bool textured = placed && !material.BaseColorTexture.Image.empty();
  const double alpha = material.BaseColor.a;
  property->SetOpacity(material.Alpha == AlphaMode::Opaque ? 1.
      : material.Alpha == AlphaMode::Blend || textured     ? alpha
      : alpha < material.AlphaCutoff                       ? 0.
                                                           : 1.);
  glm::dvec3 color(material.BaseColor);
  if (material.IsUnlit)
  {
    // Unlit colours are never decoded or encoded. A texture's texels are encoded, so the factor is
    // encoded, too: exact as far as the curve is a power.
    for (int i = 0; i < 3; ++i)
    {
      color[i] = textured ? std::pow(color[i], 1. / 2.2) : f64::relievoSrgbFromLinear(color[i]);
    }
    property->SetColor(&color[0]);
    property->SetInterpolationToPhong();
    property->LightingOff();
    return property;
  }
  property->SetInterpolationToPBR();
  property->SetColor(&color[0]);
  property->SetMetallic(material.Metallic);
  property->SetRoughness(material.Roughness);
  property->SetNormalScale(material.NormalScale);
  property->SetOcclusionStrength(
    material.OcclusionTexture.Image.empty() ? 0. : material.OcclusionStrength);
  property->SetEmissiveFactor(material.Emission.x, material.Emission.y, material.Emission.z);
  if (!placed)
  {
    return property;
  }
  const Use coloring = material.Alpha == AlphaMode::Opaque ? OpaqueColor : Color;
  const vtkSmartPointer<vtkTexture> base =
    textured ? this->GetTexture(material.BaseColorTexture, "", coloring, images) : nullptr;
  const vtkSmartPointer<vtkTexture> metal = this->GetMetalTexture(material, images);
  const vtkSmartPointer<vtkTexture> normal = material.NormalTexture.Image.empty()
    ? nullptr
    : this->GetTexture(material.NormalTexture, "", OpaquePlain, images);
  vtkSmartPointer<vtkTexture> emission;
  if (material.Emission != glm::dvec3(0.))
  {
    const Use use = material.EmissionTexture.Image.empty() ? White : OpaqueColor;
    emission = this->GetTexture(material.EmissionTexture, "", use, images);
  }
  if (base)
  {
    property->SetBaseColorTexture(base);
  }
  if (metal)
  {
    property->SetORMTexture(metal);
  }
  if (normal)
  {
    property->SetNormalTexture(normal);
  }
  if (emission)
  {
    property->SetEmissiveTexture(emission);
  }
  return property;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkTexture> ModelLook::GetActorTexture(
  const ModelMaterial& material, bool placed, const FindImage& images)
{
  if (!placed || !material.IsUnlit || material.BaseColorTexture.Image.empty())
  {
    return nullptr;
  }
  return this->GetTexture(material.BaseColorTexture, "",
    material.Alpha == AlphaMode::Opaque ? OpaquePlain : Plain, images);
}

//------------------------------------------------------------------------------
double FitSpotExponent(double inner, double outer)
{
  constexpr int steps = 200;
  const double low = std::cos(outer);
  const double span = std::cos(inner) - low;
  const auto miss = [&](double exponent) {
    double sum = 0.;
    for (int i = 0; i < steps; ++i)
    {
      // Equal steps of the cosine have equal solid angles.
      const double cosine = low + (1. - low) * (i + 0.5) / steps;
      const double share = std::clamp((cosine - low) / span, 0., 1.);
      const double off = std::pow(std::max(cosine, 0.), exponent) - share * share;
      sum += off * off;
    }
    return sum;
  };
  // A search by thirds: the error falls to its minimum and rises, so each step drops a third.
  double a = -3.;
  double b = 14.;
  for (int i = 0; i < 60; ++i)
  {
    const double third = (b - a) / 3.;
    if (miss(std::exp(a + third)) < miss(std::exp(b - third)))
    {
      b -= third;
    }
    else
    {
      a += third;
    }
  }
  const double found = std::exp((a + b) / 2.);
  return miss(0.) <= miss(found) ? 0. : found;
}

//------------------------------------------------------------------------------
double GetSunDistance(const Model& model)
{
#ifdef RELIEVO_VTK_PBR_SUNS_AT_PLACES
  const auto isSun = [](const ModelLight& light) { return light.Is == ModelLight::Kind::Sun; };
  if (std::any_of(model.Lights.begin(), model.Lights.end(), isSun) &&
    !std::all_of(model.Lights.begin(), model.Lights.end(), isSun))
  {
    vtkBoundingBox box;
    box.AddPoint(0., 0., 0.);
    for (const ModelMesh& mesh : model.Meshes)
    {
      box.AddBounds(mesh.Data->GetBounds());
    }
    constexpr double sizes = 1e5; // then its rays differ by less than 0.001 degrees
    return sizes * std::max(box.GetDiagonalLength(), 1.);
  }
#else
  (void)model;
#endif
  return 0.;
}

//------------------------------------------------------------------------------
void PlaceLight(const ModelLight& light, const glm::dmat4& world, double back, vtkLight* output)
{
  const glm::dvec3 z(world[2]);
  const double length = glm::length(z);
  const glm::dvec3 along = length > 0. ? z / -length : glm::dvec3(0., 0., -1.);
  const glm::dvec3 at = glm::dvec3(world[3]) - back * along;
  output->SetLightTypeToSceneLight();
  output->SetPosition(at.x, at.y, at.z);
  output->SetFocalPoint(at.x + along.x, at.y + along.y, at.z + along.z);
  output->SetColor(light.Color.x, light.Color.y, light.Color.z);
  output->SetIntensity(light.Intensity);
  output->SetPositional(light.Is != ModelLight::Kind::Sun);
  output->SetConeAngle(light.Is == ModelLight::Kind::Spot ? Degrees * light.OuterCone : 90.);
  output->SetExponent(
    light.Is == ModelLight::Kind::Spot ? FitSpotExponent(light.InnerCone, light.OuterCone) : 0.);
  const bool falls = light.Is != ModelLight::Kind::Sun;
  output->SetAttenuationValues(falls ? 0. : 1., 0., falls ? 1. : 0.);
}

//------------------------------------------------------------------------------
void PlaceCamera(const ModelCamera& camera, const glm::dmat4& world, vtkCamera* output)
{
  const glm::dvec3 at(world[3]);
  const glm::dvec3 to = at - glm::dvec3(world[2]);
  output->SetPosition(at.x, at.y, at.z);
  output->SetFocalPoint(to.x, to.y, to.z);
  output->SetViewUp(world[1].x, world[1].y, world[1].z);
  output->SetParallelProjection(!camera.IsPerspective);
  if (camera.IsPerspective)
  {
    output->SetViewAngle(Degrees * camera.Height);
  }
  else
  {
    output->SetParallelScale(camera.Height);
  }
  if (camera.Far > camera.Near)
  {
    output->SetClippingRange(camera.Near, camera.Far);
  }
}
}
