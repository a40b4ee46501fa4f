// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoGltfParts.h"

#include "vtkTexture.h"

#include <glm/matrix.hpp>

#include <cmath>
#include <limits>

namespace relievo
{
namespace
{
constexpr double Unlimited = std::numeric_limits<double>::infinity();

// A sampler's wrap mode, in OpenGL's numbers.
int ReadWrap(const GltfValue& wrap)
{
  switch (wrap.GetCount(10497))
  {
    case 10497:
      return vtkTexture::Repeat;
    case 33071:
      return vtkTexture::ClampToEdge;
    case 33648:
      return vtkTexture::MirroredRepeat;
    default:
      wrap.FailExpecting("10497 (repeat), 33071 (clamp) or 33648 (mirror)");
  }
}

void ReadSampler(const GltfValue& sampler, ModelTexture& texture)
{
  texture.Wrap[0] = ReadWrap(sampler.Get("wrapS"));
  texture.Wrap[1] = ReadWrap(sampler.Get("wrapT"));
  constexpr std::size_t nearest = 9728;
  constexpr std::size_t linear = 9729;
  constexpr std::size_t linearMipmapLinear = 9987;
  const GltfValue larger = sampler.Get("magFilter");
  const GltfValue smaller = sampler.Get("minFilter");
  const std::size_t magnified = larger.GetCount(linear);
  const std::size_t minified = smaller.GetCount(linearMipmapLinear);
  if (magnified != nearest && magnified != linear)
  {
    larger.FailExpecting("9728 (nearest) or 9729 (linear)");
  }
  if (minified != nearest && minified != linear && (minified < 9984 || minified > 9987))
  {
    smaller.FailExpecting("9728, 9729 or 9984 to 9987");
  }
  texture.Smooth = magnified == linear;
  texture.Mipmaps = minified >= 9984;
}

class MaterialMaker
{
public:
  MaterialMaker(GltfDocument& document, Model& result)
    : Document(document)
    , Result(result)
  {
  }

  ModelMaterial Read(const GltfValue& value)
  {
    ModelMaterial material;
    material.Name = value.Get("name").GetText("");
    const GltfValue base = value.Get("pbrMetallicRoughness");
    material.BaseColor = ReadVector<glm::dvec4>(base.Get("baseColorFactor"), 1., 1.);
    material.Metallic = base.Get("metallicFactor").GetNumber(1., 0., 1.);
    material.Roughness = base.Get("roughnessFactor").GetNumber(1., 0., 1.);
    material.Alpha =
      static_cast<AlphaMode>(value.Get("alphaMode").GetWord({ "OPAQUE", "MASK", "BLEND" }));
    material.AlphaCutoff = value.Get("alphaCutoff").GetNumber(0.5, 0., Unlimited);
    material.IsDoubleSided = value.Get("doubleSided").GetFlag(false);
    const GltfValue extensions = value.Get("extensions");
    material.IsUnlit = extensions.Get("KHR_materials_unlit").IsThere();
    const double strength = extensions.Get("KHR_materials_emissive_strength")
                              .Get("emissiveStrength")
                              .GetNumber(1., 0., Unlimited);
    material.Emission = strength * ReadVector<glm::dvec3>(value.Get("emissiveFactor"), 0., 1.);
    material.BaseColorTexture = this->ReadTexture(base.Get("baseColorTexture"));
    material.MetalTexture = this->ReadTexture(base.Get("metallicRoughnessTexture"));
    const GltfValue normal = value.Get("normalTexture");
    material.NormalTexture = this->ReadTexture(normal);
    material.NormalScale = normal.Get("scale").GetNumber(1.);
    const GltfValue occlusion = value.Get("occlusionTexture");
    material.OcclusionTexture = this->ReadTexture(occlusion);
    material.OcclusionStrength = occlusion.Get("strength").GetNumber(1., 0., 1.);
    material.EmissionTexture = this->ReadTexture(value.Get("emissiveTexture"));
    this->KeepOnePlacing(value, material);
    return material;
  }

private:
  template <typename Vector>
  static Vector ReadVector(const GltfValue& value, double otherwise, double most)
  {
    constexpr std::size_t parts = sizeof(Vector) / sizeof(double);
    const std::vector<double> numbers = value.GetNumbers(std::vector<double>(parts, otherwise));
    Vector result;
    for (std::size_t i = 0; i < parts; ++i)
    {
      result[static_cast<int>(i)] =
        value.IsThere() ? value.At(i).GetNumber(0., 0., most) : numbers[i];
    }
    return result;
  }

  //----------------------------------------------------------------------------
  ModelTexture ReadTexture(const GltfValue& info)
  {
    ModelTexture texture;
    if (!info.IsThere())
    {
      return texture;
    }
    const GltfValue textures = this->Document.Get("textures");
    const int index = info.Get("index").GetIndex("textures", textures.GetSize());
    if (index < 0)
    {
      info.Get("index").FailExpecting("the number of a texture");
    }
    const GltfValue value = textures.At(static_cast<std::size_t>(index));
    const GltfValue samplers = this->Document.Get("samplers");
    const int sampler = value.Get("sampler").GetIndex("samplers", samplers.GetSize());
    if (sampler >= 0)
    {
      ReadSampler(samplers.At(static_cast<std::size_t>(sampler)), texture);
    }
    const int image =
      value.Get("source").GetIndex("images", this->Document.Get("images").GetSize());
    if (image < 0)
    {
      this->Result.Notes.push_back(
        value.GetPlace() + " has no image that is read, and surfaces are drawn without it");
      return texture;
    }
    texture.Image = this->ReadImage(static_cast<std::size_t>(image));
    const GltfValue moved = info.Get("extensions").Get("KHR_texture_transform");
    texture.Coordinates = static_cast<int>(std::min<std::size_t>(
      moved.Get("texCoord").GetCount(info.Get("texCoord").GetCount(0)), 1000));
    if (moved.IsThere())
    {
      const std::vector<double> offset = moved.Get("offset").GetNumbers({ 0., 0. });
      const std::vector<double> scale = moved.Get("scale").GetNumbers({ 1., 1. });
      const double turn = moved.Get("rotation").GetNumber(0.);
      const double c = std::cos(turn);
      const double s = std::sin(turn);
      // Columns: the images of u and v, and the offset.
      texture.Transform = glm::dmat3(c * scale[0], -s * scale[0], 0., //
        s * scale[1], c * scale[1], 0.,                               //
        offset[0], offset[1], 1.);
    }
    return texture;
  }

  //----------------------------------------------------------------------------
  // The image's name; "" with a note if it may not be read.
  std::string ReadImage(std::size_t place)
  {
    const auto known = this->Names.find(place);
    if (known != this->Names.end())
    {
      return known->second;
    }
    const std::string obstacle = this->Document.FindObstacle(place);
    if (!obstacle.empty())
    {
      const GltfValue value = this->Document.Get("images").At(place);
      this->Result.Notes.push_back("drawn without " + value.GetPlace() + ", " +
        value.Get("uri").GetText("") + ": " + obstacle);
      this->Names.emplace(place, "");
      return "";
    }
    std::string name;
    const GltfBytes bytes = this->Document.GetImage(place, name);
    // Several images may use the same bytes.
    this->Bytes += bytes.Size;
    if (this->Bytes > gltf::MostImageBytes)
    {
      this->Document.Get("images").At(place).Fail("makes more than " +
        std::to_string(gltf::MostImageBytes) +
        " bytes with the images before it; at most these "
        "are read");
    }
    ModelImage image;
    image.Bytes.assign(bytes.Data, bytes.Data + bytes.Size);
    image.Format = this->GetFormat(this->Document.Get("images").At(place));
    this->Result.Images.emplace(name, std::move(image));
    this->Names.emplace(place, name);
    return name;
  }

  //----------------------------------------------------------------------------
  // TGA has no signature.
  static std::string GetFormat(const GltfValue& image)
  {
    const std::string uri = image.Get("uri").GetText("");
    const std::string data = "data:";
    return image.Get("mimeType").IsThere() ? image.Get("mimeType").GetText("")
      : uri.rfind(data, 0) == 0 ? uri.substr(data.size(), uri.find_first_of(";,") - data.size())
                                : uri;
  }

  //----------------------------------------------------------------------------
  // VTK's shaders have one set of texture coordinates per mesh: textures with other coordinates
  // than the first are left out.
  void KeepOnePlacing(const GltfValue& value, ModelMaterial& material)
  {
    struct
    {
      ModelTexture* Texture;
      const char* Name;
    } const all[] = { { &material.BaseColorTexture, "base colour" },
      { &material.MetalTexture, "metal and roughness" }, { &material.NormalTexture, "normal" },
      { &material.OcclusionTexture, "occlusion" }, { &material.EmissionTexture, "emission" } };
    const ModelTexture* first = nullptr;
    const char* name = "";
    for (const auto& [texture, own] : all)
    {
      if (texture->Image.empty())
      {
        continue;
      }
      if (!first)
      {
        first = texture;
        name = own;
      }
      else if (texture->Coordinates != first->Coordinates || texture->Transform != first->Transform)
      {
        this->Result.Notes.push_back(value.GetPlace() + ": its texture of " + own +
          " has other coordinates than that of " + name + "; it is left out");
        texture->Image.clear();
      }
    }
  }

  GltfDocument& Document;
  Model& Result;
  std::map<std::size_t, std::string> Names;
  std::size_t Bytes = 0; // of images
};
}

//------------------------------------------------------------------------------
void ReadGltfMaterials(GltfDocument& document, Model& model)
{
  const GltfValue materials = document.Get("materials");
  MaterialMaker maker(document, model);
  for (std::size_t i = 0; i < materials.GetSize(); ++i)
  {
    model.Materials.push_back(maker.Read(materials.At(i)));
  }
  model.Materials.push_back(ModelMaterial());
}
}
