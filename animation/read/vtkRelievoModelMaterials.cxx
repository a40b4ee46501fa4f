// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Materials for programs that draw: colours as in the file, sRGB; textures by name, and images
// inside the file.
#include "vtkRelievoModelParts.h"

#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

#include <assimp/GltfMaterial.h>
#include <assimp/material.h>
#include <assimp/texture.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <initializer_list>

namespace relievo
{
namespace
{
// Larger images, from damaged files, exceed every graphics card.
constexpr unsigned int WidestImage = 65536;

void AddNumbers(const char* name, std::initializer_list<float> numbers, vtkPolyData* output)
{
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(numbers.size()));
  array->InsertNextTuple(numbers.begin());
  output->GetFieldData()->AddArray(array);
}

void AddText(const char* name, const std::string& text, vtkPolyData* output)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  array->InsertNextValue(text);
  output->GetFieldData()->AddArray(array);
}

void ReadImage(const aiTexture* texture, const std::string& name, Model& model)
{
  if (!texture || !texture->pcData || texture->mWidth == 0 || model.Images.count(name))
  {
    return;
  }
  ModelImage image;
  if (texture->mHeight == 0)
  {
    const auto* bytes = reinterpret_cast<const unsigned char*>(texture->pcData);
    image.Bytes.assign(bytes, bytes + texture->mWidth);
    const char* hint = texture->achFormatHint;
    image.Format.assign(hint, strnlen(hint, HINTMAXTEXTURELEN));
  }
  else if (std::max(texture->mWidth, texture->mHeight) <= WidestImage)
  {
    image.Width = static_cast<int>(texture->mWidth);
    image.Height = static_cast<int>(texture->mHeight);
    const std::size_t count = static_cast<std::size_t>(texture->mWidth) * texture->mHeight;
    image.Bytes.reserve(4 * count);
    for (std::size_t i = 0; i < count; ++i)
    {
      const aiTexel& texel = texture->pcData[i];
      image.Bytes.insert(image.Bytes.end(), { texel.r, texel.g, texel.b, texel.a });
    }
  }
  model.Images.emplace(name, image);
}

// Reads the material's first texture of these kinds. Returns its kind, or NONE.
aiTextureType ReadTexture(const aiScene* scene, const aiMaterial* material,
  std::initializer_list<aiTextureType> kinds, const char* array, vtkPolyData* output, Model& model)
{
  for (const aiTextureType kind : kinds)
  {
    aiString path;
    if (material->GetTexture(kind, 0, &path) == aiReturn_SUCCESS && path.length > 0)
    {
      AddText(array, path.C_Str(), output);
      ReadImage(scene->GetEmbeddedTexture(path.C_Str()), path.C_Str(), model);
      return kind;
    }
  }
  return aiTextureType_NONE;
}

// The colour of a physical or PBR material of 3ds Max in FBX, whose DiffuseColor is a substitute.
// Assimp passes it on by its name alone. A map replaces the colour, and is weighted, too.
bool ReadMaxColor(const aiMaterial* material, aiColor4D& color)
{
  const bool isPhysical =
    material->Get("$raw.3dsMax|Parameters|base_color", 0, 0, color) == aiReturn_SUCCESS;
  if (!isPhysical && material->Get("$raw.3dsMax|main|basecolor", 0, 0, color) != aiReturn_SUCCESS)
  {
    return false;
  }
  if (material->GetTextureCount(aiTextureType_BASE_COLOR) > 0)
  {
    color = aiColor4D(1.f, 1.f, 1.f, 1.f);
  }
  float weight = 1.f;
  if (isPhysical)
  {
    material->Get("$raw.3dsMax|Parameters|base_weight", 0, 0, weight);
  }
  const auto weigh = [weight](float share) {
    return (std::isfinite(weight) ? weight : 1.f) * (std::isfinite(share) ? share : 1.f);
  };
  color = aiColor4D(weigh(color.r), weigh(color.g), weigh(color.b), 1.f);
  return true;
}
}

//------------------------------------------------------------------------------
void ReadMaterial(
  const aiScene* scene, const aiMaterial* material, vtkPolyData* output, Model& model)
{
  aiColor4D color(1.f, 1.f, 1.f, 1.f);
  if (ReadMaxColor(material, color) ||
    material->Get(AI_MATKEY_BASE_COLOR, color) == aiReturn_SUCCESS ||
    material->Get(AI_MATKEY_COLOR_DIFFUSE, color) == aiReturn_SUCCESS)
  {
    AddNumbers("base_color", { color.r, color.g, color.b, color.a }, output);
  }
  ReadTexture(scene, material, { aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE },
    "base_color_texture", output, model);
  const aiTextureType kind = ReadTexture(scene, material,
    { aiTextureType_NORMALS, aiTextureType_NORMAL_CAMERA }, "normal_texture", output, model);
  float strength = 1.f;
  if (kind != aiTextureType_NONE &&
    material->Get(AI_MATKEY_GLTF_TEXTURE_SCALE(kind, 0), strength) == aiReturn_SUCCESS &&
    std::isfinite(strength))
  {
    AddNumbers("normal_strength", { strength }, output);
  }
}
}
