// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GltfMaterials.h"

#include "GltfSurface.h"

#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkRelievoFormulas.h"
#include "vtkRelievoVTKVersions.h"
#include "vtkRelievoWrapTexture.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

namespace scene
{
namespace
{
// Numbers of the glTF 2 specification.
enum Sampling
{
  Nearest = 9728,
  Linear = 9729,
  LinearMipmaps = 9987,
  Repeat = 10497,
  ClampToEdge = 33071,
  MirroredRepeat = 33648
};

int GetWrapping(int wrap)
{
  return wrap == vtkTexture::Repeat      ? Repeat
    : wrap == vtkTexture::MirroredRepeat ? MirroredRepeat
                                         : ClampToEdge;
}

// The roughness of GGX whose highlight is as wide as that of a Blinn-Phong power: alpha^2 = 2 / (n
// + 2) (Walter et al. 2007), and alpha is the square of glTF's roughness.
double GetRoughness(double power)
{
  return std::pow(2. / (std::max(power, 0.) + 2.), 0.25);
}
}

//------------------------------------------------------------------------------
bool HasLinearColors(const GltfSurface& surface)
{
  vtkProperty* property = surface.Actor->GetProperty();
  return property->GetInterpolation() == VTK_PBR && property->GetLighting();
}

//------------------------------------------------------------------------------
double ToLinear(double value, bool isLinear)
{
  const double valid = std::clamp(value, 0., 1.);
  return isLinear ? valid : relievo::f64::relievoLinearFromSrgb(valid);
}

//------------------------------------------------------------------------------
double ToLinearFromMapped(double value, bool isLinear)
{
  const double valid = std::clamp(value, 0., 1.);
  return isLinear && RELIEVO_VTK_PBR_SRGB_VERTEX_COLORS ? std::pow(valid, 2.2)
                                                        : ToLinear(valid, isLinear);
}

//------------------------------------------------------------------------------
GltfMaterials::Json GltfMaterials::Refer(
  vtkImageData* image, int wrapU, int wrapV, bool isSmooth, bool hasMipmaps)
{
  const auto [found, isNew] = this->Images.emplace(image, 0);
  if (isNew)
  {
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputData(image);
    writer->WriteToMemoryOn();
    writer->Write();
    vtkUnsignedCharArray* bytes = writer->GetResult();
    if (!bytes)
    {
      this->Images.erase(found);
      this->Notes.insert("a texture is left out: it cannot be written as PNG");
      return nullptr;
    }
    const std::size_t view = this->Buffer.AddBytes(
      bytes->GetPointer(0), static_cast<std::size_t>(bytes->GetNumberOfValues()));
    found->second =
      this->Buffer.Append("images", { { "bufferView", view }, { "mimeType", "image/png" } });
  }
  const Json sampler = { { "magFilter", isSmooth ? Linear : Nearest },
    { "minFilter",
      !isSmooth      ? Nearest
        : hasMipmaps ? LinearMipmaps
                     : Linear },
    { "wrapS", GetWrapping(wrapU) }, { "wrapT", GetWrapping(wrapV) } };
  const auto [texture, isNewTexture] =
    this->Textures.emplace(std::to_string(found->second) + sampler.dump(), 0);
  if (isNewTexture)
  {
    const std::size_t place = this->Buffer.Append("samplers", Json(sampler));
    texture->second =
      this->Buffer.Append("textures", { { "sampler", place }, { "source", found->second } });
  }
  return { { "index", texture->second } };
}

//------------------------------------------------------------------------------
GltfMaterials::Json GltfMaterials::Refer(vtkTexture* texture)
{
  texture->Update();
  vtkImageData* image = texture->GetInput();
  // VTK maps numbers other than bytes to colours, unless it is told not to.
  const bool isDirect = image &&
    (texture->GetColorMode() == VTK_COLOR_MODE_DIRECT_SCALARS
        ? image->GetScalarType() == VTK_UNSIGNED_CHAR ||
          image->GetScalarType() == VTK_UNSIGNED_SHORT
        : image->GetScalarType() == VTK_UNSIGNED_CHAR &&
          texture->GetColorMode() == VTK_COLOR_MODE_DEFAULT);
  if (!isDirect || texture->GetCubeMap() || image->GetDimensions()[2] != 1)
  {
    this->Notes.insert("a texture is left out: glTF has colours of 8 or 16 bits in flat images");
    return nullptr;
  }
  auto* own = vtkRelievoWrapTexture::SafeDownCast(texture);
  return this->Refer(image, own ? own->GetWrapU() : texture->GetWrap(),
    own ? own->GetWrapV() : texture->GetWrap(), texture->GetInterpolate(), texture->GetMipmap());
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> GltfMaterials::Code(vtkImageData* map, bool isLinear)
{
  if (!isLinear)
  {
    return map; // glTF's colours of textures are sRGB, too
  }
  vtkSmartPointer<vtkImageData>& coded = this->Coded[map];
  if (!coded)
  {
    coded = vtkSmartPointer<vtkImageData>::New();
    coded->DeepCopy(map);
    vtkDataArray* colors = coded->GetPointData()->GetScalars();
    for (vtkIdType i = 0; i < colors->GetNumberOfTuples(); ++i)
    {
      for (int j = 0; j < std::min(3, colors->GetNumberOfComponents()); ++j)
      {
        const double light = ToLinearFromMapped(colors->GetComponent(i, j) / 255., true);
        colors->SetComponent(i, j, std::round(255. * relievo::f64::relievoSrgbFromLinear(light)));
      }
    }
  }
  return coded;
}

//------------------------------------------------------------------------------
std::size_t GltfMaterials::Find(const GltfSurface& surface, bool hasCoordinates, bool isLit)
{
  vtkProperty* property = surface.Actor->GetProperty();
  const bool isLinear = HasLinearColors(surface);
  const bool isColored = surface.Colors || surface.Map;
  Json base = Json::array();
  for (int i = 0; i < 3; ++i)
  {
    base.push_back(isColored ? 1. : ToLinear(surface.Color[i], isLinear));
  }
  base.push_back(std::clamp(surface.Opacity, 0., 1.));
  Json metal = { { "baseColorFactor", base } };
  Json material;
  bool isTranslucent = surface.Opacity < 1.;
  if (surface.Colors)
  {
    isTranslucent = isTranslucent || surface.Colors->GetRange(3)[0] < 255.;
  }
  const auto refer = [&](vtkTexture* texture, Json& to, const char* name) {
    const Json texturing = texture && hasCoordinates ? this->Refer(texture) : Json();
    if (!texturing.is_null())
    {
      to[name] = texturing;
    }
    else if (texture && hasCoordinates)
    {
      this->Partial.insert(surface.Actor);
    }
    return !texturing.is_null();
  };
  const auto hasAlpha = [](vtkTexture* texture) {
    vtkImageData* image = texture ? texture->GetInput() : nullptr;
    return image && image->GetNumberOfScalarComponents() % 2 == 0;
  };
  if (surface.Map)
  {
    metal["baseColorTexture"] = this->Refer(this->Code(surface.Map, isLinear),
      vtkTexture::ClampToEdge, vtkTexture::ClampToEdge, false, false);
    isTranslucent =
      isTranslucent || surface.Map->GetPointData()->GetScalars()->GetRange(3)[0] < 255.;
  }
  else
  {
    vtkTexture* texture =
      isLinear ? property->GetTexture("albedoTex") : surface.Actor->GetTexture();
    const bool isTextured = refer(texture, metal, "baseColorTexture");
    // VTK draws PBR textures as opaque, whatever their alpha.
    isTranslucent = isTranslucent || (isTextured && !isLinear && hasAlpha(texture));
  }
  if (isLinear)
  {
    metal["metallicFactor"] = std::clamp(property->GetMetallic(), 0., 1.);
    metal["roughnessFactor"] = std::clamp(property->GetRoughness(), 0., 1.);
    refer(property->GetTexture("materialTex"), metal, "metallicRoughnessTexture");
    if (property->GetOcclusionStrength() > 0. &&
      refer(property->GetTexture("materialTex"), material, "occlusionTexture"))
    {
      material["occlusionTexture"]["strength"] =
        std::clamp(property->GetOcclusionStrength(), 0., 1.);
    }
    if (refer(property->GetTexture("normalTex"), material, "normalTexture"))
    {
      material["normalTexture"]["scale"] = property->GetNormalScale();
    }
    // VTK's factor counts only with a texture.
    if (refer(property->GetTexture("emissiveTex"), material, "emissiveTexture"))
    {
      double factor[3];
      property->GetEmissiveFactor(factor);
      const double largest = *std::max_element(factor, factor + 3);
      const double scale = std::max(largest, 1.);
      material["emissiveFactor"] = { factor[0] / scale, factor[1] / scale, factor[2] / scale };
      if (scale > 1.)
      {
        this->Buffer.Use("KHR_materials_emissive_strength");
        material["extensions"]["KHR_materials_emissive_strength"] = { { "emissiveStrength",
          scale } };
      }
    }
  }
  else
  {
    metal["metallicFactor"] = 0.;
    metal["roughnessFactor"] =
      property->GetSpecular() > 0. ? GetRoughness(property->GetSpecularPower()) : 1.;
  }
  const bool isEven = !isLinear && property->GetDiffuse() <= 0. && property->GetAmbient() > 0.;
  if (!property->GetLighting() || !isLit || isEven)
  {
    this->Buffer.Use("KHR_materials_unlit");
    material["extensions"]["KHR_materials_unlit"] = Json::object();
  }
  material["pbrMetallicRoughness"] = metal;
  if (!surface.Actor->GetForceOpaque() && (isTranslucent || surface.Actor->GetForceTranslucent()))
  {
    material["alphaMode"] = "BLEND";
  }
  if (!property->GetBackfaceCulling())
  {
    material["doubleSided"] = true;
  }
  const auto [found, isNew] =
    this->Materials.emplace(material.dump() + (isLinear ? " linear" : ""), 0);
  if (isNew)
  {
    found->second = this->Buffer.Append("materials", std::move(material));
  }
  if (isLinear && isLit)
  {
    this->WithLinearColors.insert(found->second);
  }
  return found->second;
}
}
