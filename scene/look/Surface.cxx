// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Surface.h"

#include "Environment.h"
#include "Errors.h"
#include "Images.h"
#include "Options.h"
#include "Scene.h"
#include "SurfaceOptions.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkRelievoEnvironment.h"
#include "vtkRelievoMaterial.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace scene
{
namespace
{
// Default depth of relief, as a share of the scene's longest side.
constexpr double DefaultDepth = 0.02;

//------------------------------------------------------------------------------
void SetHeights(vtkRelievoMaterial* material, vtkRenderer* renderer, const RenderOptions& options,
  Progress& progress)
{
  double bounds[6];
  renderer->ComputeVisiblePropBounds(bounds);
  const double longest =
    std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
  material->SetHeightMap(ReadImage(options.HeightMap, progress));
  material->SetHeightScale(options.HeightScale.value_or(DefaultDepth * longest));
  material->SetParameter("relief_method", options.ReliefMethod);
  for (const char* name : { "depth_correction", "self_shadow" })
  {
    material->SetParameter(name, GetSurfaceValue(options, name));
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> ReadNormals(const std::string& path, Progress& progress)
{
  const vtkSmartPointer<vtkImageData> image = ReadImage(path, progress);
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
  vtkRelievoEnvironment* environment, vtkRenderer* renderer, const RenderOptions& options,
  Progress& progress)
{
  auto material = vtkSmartPointer<vtkRelievoMaterial>::New();
  if (!options.NormalMap.empty())
  {
    material->SetNormalMap(ReadNormals(options.NormalMap, progress));
  }
  else if (own)
  {
    material->SetNormalMap(own->GetNormalMap());
    material->SetNormalStrength(own->GetNormalStrength());
    material->SetRepeat(own->GetRepeat());
  }
  if (own && options.Look.Opacity >= 1.0) // otherwise VTK blends the cut-out
  {
    material->SetAlphaCutoff(own->GetAlphaCutoff());
  }
  if (!options.HeightMap.empty())
  {
    SetHeights(material, renderer, options, progress);
  }
  if (environment)
  {
    material->SetEnvironment(environment);
    material->SetReflectivity(options.Reflectivity);
    material->SetRoughness(options.Roughness);
  }
  for (const auto& [name, words] : options.Material)
  {
    material->SetParameter(name, words);
  }
  return material;
}
}

//------------------------------------------------------------------------------
void CheckSurface(const RenderOptions& options)
{
  for (const auto& [option, path] :
    { std::pair<const char*, std::string>("--normal-map", options.NormalMap),
      std::pair<const char*, std::string>("--height-map", options.HeightMap) })
  {
    if (!path.empty())
    {
      CheckImage(option, path);
    }
  }
  CheckEnvironment(options);
}

//------------------------------------------------------------------------------
void SetSurface(const Scene& scene, const RenderOptions& options, Progress& progress)
{
  const bool plain = options.NormalMap.empty() && options.HeightMap.empty() &&
    options.Environment.empty() && options.Material.empty();
  if (plain && options.Look.Opacity >= 1.0)
  {
    return;
  }
  vtkRenderer* renderer = scene.Renderer;
  vtkSmartPointer<vtkRelievoEnvironment> environment;
  if (!options.Environment.empty())
  {
    environment = ReadEnvironment(options, progress);
    if (options.Skybox)
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
    if (actor == scene.Ground || (scene.Grid && actor == scene.Grid->GetLines()))
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
      material = MakeMaterial(own, environment, renderer, options, progress);
    }
    material->Attach(actor);
  }
}
}
