// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Surface.h"

#include "Environment.h"
#include "Errors.h"
#include "Images.h"
#include "OptionRows.h"
#include "SurfaceOptions.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkRelievoEnvironment.h"
#include "vtkRelievoImageFile.h"
#include "vtkRelievoMaterial.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace look
{
namespace
{
// Default depth of relief, as a share of the scene's longest side.
constexpr double DefaultDepth = 0.02;

//------------------------------------------------------------------------------
void SetHeights(vtkRelievoMaterial* material, vtkRenderer* renderer, const SurfaceChoice& surface,
  ReadContext& context)
{
  double bounds[6];
  renderer->ComputeVisiblePropBounds(bounds);
  const double longest =
    std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
  material->SetHeightMap(ReadImage(surface.HeightMap, context));
  material->SetHeightScale(surface.HeightScale.value_or(DefaultDepth * longest));
  material->SetParameter("relief_method", surface.ReliefMethod);
  for (const char* name : { "depth_correction", "self_shadow" })
  {
    material->SetParameter(name, GetSurfaceValue(surface, name));
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> ReadNormals(const std::string& path, ReadContext& context)
{
  const vtkSmartPointer<vtkImageData> image = ReadImage(path, context);
  const int components = image->GetPointData()->GetScalars()->GetNumberOfComponents();
  if (components < 3)
  {
    throw WorkError(path +
      ": expected a normal map, which has red, green and blue, but it is grey" +
      (components == 2 ? " with alpha" : ""));
  }
  return image;
}

//------------------------------------------------------------------------------
// `own`: material of a model with a normal map, used unless --normal-map replaces it; or null.
vtkSmartPointer<vtkRelievoMaterial> MakeMaterial(vtkRelievoMaterial* own,
  vtkRelievoEnvironment* environment, vtkRenderer* renderer, const SurfaceChoice& surface,
  bool opaque, ReadContext& context)
{
  auto material = vtkSmartPointer<vtkRelievoMaterial>::New();
  if (!surface.NormalMap.empty())
  {
    material->SetNormalMap(ReadNormals(surface.NormalMap, context));
  }
  else if (own)
  {
    material->SetNormalMap(own->GetNormalMap());
    material->SetNormalStrength(own->GetNormalStrength());
    material->SetRepeat(own->GetRepeat());
  }
  if (own && opaque) // otherwise VTK blends the cut-out
  {
    material->SetAlphaCutoff(own->GetAlphaCutoff());
  }
  if (!surface.HeightMap.empty())
  {
    SetHeights(material, renderer, surface, context);
  }
  if (environment)
  {
    material->SetEnvironment(environment);
    material->SetReflectivity(surface.Reflectivity);
    material->SetRoughness(surface.Roughness);
  }
  for (const auto& [name, words] : surface.Material)
  {
    material->SetParameter(name, words);
  }
  return material;
}
}

//------------------------------------------------------------------------------
void CheckSurface(const SurfaceChoice& surface)
{
  for (const auto& [option, path] :
    { std::pair<const char*, std::string>("--normal-map", surface.NormalMap),
      std::pair<const char*, std::string>("--height-map", surface.HeightMap),
      std::pair<const char*, std::string>("--environment", surface.Environment) })
  {
    if (!path.empty())
    {
      CheckImage(option, path);
    }
  }
}

//------------------------------------------------------------------------------
void SetSurface(vtkRenderer* renderer, const std::vector<vtkActor*>& without,
  const SurfaceChoice& surface, int up, bool opaque, ReadContext& context)
{
  const bool plain = !surface.IsMapped() && surface.Environment.empty() && surface.Material.empty();
  if (plain && opaque)
  {
    return;
  }
  vtkSmartPointer<vtkRelievoEnvironment> environment;
  if (!surface.Environment.empty())
  {
    environment = ReadEnvironment(surface, up, context);
    if (surface.Skybox)
    {
      ShowSky(renderer, environment);
    }
  }
  std::map<vtkRelievoMaterial*, vtkSmartPointer<vtkRelievoMaterial>> materials;
  vtkActorCollection* actors = renderer->GetActors();
  vtkCollectionSimpleIterator it;
  actors->InitTraversal(it);
  while (vtkActor* actor = actors->GetNextActor(it))
  {
    if (std::find(without.begin(), without.end(), actor) != without.end())
    {
      continue;
    }
    vtkRelievoMaterial* own = vtkRelievoMaterial::Get(actor);
    if (plain && (!own || own->GetAlphaCutoff() <= 0.0))
    {
      continue;
    }
    vtkSmartPointer<vtkRelievoMaterial>& material = materials[own];
    if (!material)
    {
      material = MakeMaterial(own, environment, renderer, surface, opaque, context);
    }
    material->Attach(actor);
  }
}

//------------------------------------------------------------------------------
void AddMapOptions(OptionRows& rows, SurfaceChoice& surface)
{
  // Words are parsed often: long texts are made once.
  static const std::string images = vtkRelievoImageFile::ListExtensions("", "|");
  static const std::string listed = vtkRelievoImageFile::ListExtensions(".");
  static const std::string values = DescribeValues(GetMaterialValues());
  rows
    .AddText("--normal-map", "F",
      "tangent-space normals from an image (" + listed +
        "; green points up, as in OpenGL), placed by the meshes' texture coordinates; linear "
        "values, not sRGB",
      surface.NormalMap)
    .Is(OptionRows::Option::READS_FILES | OptionRows::Option::SHAPES_SURFACE)
    .NamedIn("Look", "Normal map")
    .DropAs("the normal map")
    .Files = images;
  rows
    .Add("--height-map", "F[,SCALE]",
      "heights from an image; the ground lies SCALE below the mesh, in world units "
      "(0.02 of the scene's longest side)",
      surface, TakeHeightMap)
    .Is(OptionRows::Option::READS_FILES | OptionRows::Option::SHAPES_SURFACE)
    .NamedIn("Look", "Height map")
    .DropAs("the height map")
    .Files = images;
  rows
    .AddChoice("--relief", "METHOD", GetReliefMethods(),
      "how heights are drawn: off (as normals only), parallax, steep, occlusion or relief (relief)",
      [&surface](std::size_t place) { surface.ReliefMethod = GetReliefMethods()[place]; })
    .Is(OptionRows::Option::SHAPES_SURFACE | OptionRows::Option::OF_FILES)
    .NamedIn("Look", "Relief method");
  rows
    .Add("--material", "NAME=VALUE[,NAME=VALUE]...",
      "other values of the material of all surfaces" + values, surface, TakeMaterial)
    .Is(OptionRows::Option::SHAPES_SURFACE)
    .NamedIn("Look", "Material");
  rows
    .AddChoice("--texture-coordinates", "METHOD", { "box", "plane", "sphere" },
      "how texture coordinates are made for meshes without them: @choices@ (box, with a "
      "note)",
      [&surface](std::size_t place) {
        constexpr Mapping methods[] = { Mapping::Box, Mapping::Plane, Mapping::Sphere };
        surface.TextureMapping = methods[place];
      })
    .Is(OptionRows::Option::READS_FILES | OptionRows::Option::SHAPES_SURFACE |
      OptionRows::Option::OF_FILES)
    .NamedIn("Look", "Texture coordinates");
}
}
