// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PythonSurface.h"

#include "Options.h"
#include "PythonActors.h"
#include "PythonWords.h"
#include "Scene.h"
#include "Settings.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMapper.h"
#include "vtkPolyData.h"
#include "vtkPropCollection.h"
#include "vtkRelievoMaterial.h"
#include "vtkRelievoTextureCoordinates.h"
#include "vtkRenderer.h"
#include "vtkScalarBarActor.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace viewer
{
namespace
{
// What relievo.environment gives a material of its own, as the command line does.
bool IsPlain(const cli::Scene& scene, vtkActor* actor)
{
  const auto isOwn = [actor](const cli::PosedModel& model) { return model.Skeleton == actor; };
  auto* mesh = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0));
  return mesh && mesh->GetNumberOfPolys() > 0 &&
    std::none_of(scene.Models.begin(), scene.Models.end(), isOwn);
}

//------------------------------------------------------------------------------
void WriteMaterial(std::ostream& out, const cli::Scene& scene, vtkRelievoMaterial* material,
  const std::vector<int>& actors, const cli::RenderOptions& options)
{
  auto* first =
    vtkActor::SafeDownCast(scene.Renderer->GetActors()->GetItemAsObject(actors.front()));
  out << "\nmaterial = relievo.vtkRelievoMaterial()\n";
  if (vtkImageData* map = material->GetNormalMap())
  {
    out << "material.SetNormalMap(" << WriteImage(scene, first, map, "normal_texture") << ")\n";
    if (material->GetNormalStrength() != 1.0)
    {
      out << "material.SetNormalStrength(" << WriteNumber(material->GetNormalStrength()) << ")\n";
    }
  }
  if (!options.HeightMap.empty())
  {
    // The depth of the relief may follow from the scene's size: it is that of what is shown.
    out << "material.SetHeightMap(image(" << Quote(options.HeightMap) << "))\n"
        << "material.SetHeightScale(" << WriteNumber(material->GetHeightScale()) << ")\n"
        << "material.SetMethod(" << material->GetMethod() << ")\n"
        << "material.SetDepthCorrection(" << (material->GetDepthCorrection() ? "True" : "False")
        << ")\nmaterial.SetSelfShadow(" << (material->GetSelfShadow() ? "True" : "False") << ")\n";
  }
  if (!options.Environment.empty())
  {
    out << "material.SetReflectivity(" << WriteNumber(options.Reflectivity)
        << ")\nmaterial.SetRoughness(" << WriteNumber(options.Roughness) << ")\n";
  }
  if (static_cast<int>(actors.size()) == scene.Renderer->GetActors()->GetNumberOfItems())
  {
    out << "for actor in renderer.GetActors():\n    material.Attach(actor)\n";
    return;
  }
  out << "actors = list(renderer.GetActors())\n";
  for (const int actor : actors)
  {
    out << "material.Attach(actors[" << actor << "])\n";
  }
}

//------------------------------------------------------------------------------
void WriteMaterials(std::ostream& out, const cli::Scene& scene, const cli::RenderOptions& options)
{
  std::vector<std::pair<vtkRelievoMaterial*, std::vector<int>>> materials;
  vtkActorCollection* actors = scene.Renderer->GetActors();
  bool plain = !IsMapped(options);
  for (int i = 0; i < actors->GetNumberOfItems(); ++i)
  {
    vtkActor* actor = vtkActor::SafeDownCast(actors->GetItemAsObject(i));
    vtkRelievoMaterial* material = vtkRelievoMaterial::Get(actor);
    plain = plain && IsPlain(scene, actor) && (!material || !material->GetNormalMap());
    if (!material)
    {
      continue;
    }
    const auto known = std::find_if(materials.begin(), materials.end(),
      [material](const auto& each) { return each.first == material; });
    auto& users = known == materials.end()
      ? materials.emplace_back(material, std::vector<int>()).second
      : known->second;
    users.push_back(i);
  }
  for (const auto& [material, users] : materials)
  {
    if (!plain)
    {
      WriteMaterial(out, scene, material, users, options);
    }
  }
}

//------------------------------------------------------------------------------
// Somebody's environment lights alone: no headlight.
bool HasNullLight(vtkRenderer* renderer)
{
  vtkLightCollection* lights = renderer->GetLights();
  for (int i = 0; i < lights->GetNumberOfItems(); ++i)
  {
    vtkLight* light = vtkLight::SafeDownCast(lights->GetItemAsObject(i));
    if (light->LightTypeIsHeadlight() && light->GetIntensity() == 0.0)
    {
      return true;
    }
  }
  return false;
}
}

//------------------------------------------------------------------------------
bool IsMapped(const cli::RenderOptions& options)
{
  return !options.NormalMap.empty() || !options.HeightMap.empty();
}

//------------------------------------------------------------------------------
std::string WriteMapped(const std::string& data, const cli::RenderOptions& options)
{
  constexpr int mappings[] = { vtkRelievoTextureCoordinates::BOX,
    vtkRelievoTextureCoordinates::PLANE, vtkRelievoTextureCoordinates::SPHERE };
  const auto mapping = options.TextureMapping.value_or(cli::Mapping::Box);
  return "mapped(" + data + ", " + std::to_string(mappings[static_cast<int>(mapping)]) + ", " +
    std::to_string(options.UpAxis) + ")";
}

//------------------------------------------------------------------------------
void WriteSurface(std::ostream& out, const cli::Scene& scene, const cli::RenderOptions& options)
{
  WriteMaterials(out, scene, options);
  if (options.Environment.empty())
  {
    return;
  }
  if (HasNullLight(scene.Renderer))
  {
    out << "\nlight = vtkLight()\nlight.SetLightTypeToHeadlight()\nlight.SetIntensity(0)\n"
        << "renderer.AddLight(light)  # the environment lights\n";
  }
  out << "\nrelievo.environment(renderer, " << Quote(options.Environment)
      << ", rotation=" << WriteNumber(options.EnvironmentRotation) << ", up=\""
      << "xyz"[options.UpAxis]
      << "\",\n                    reflectivity=" << WriteNumber(options.Reflectivity)
      << ", roughness=" << WriteNumber(options.Roughness)
      << ", sky=" << (options.Skybox ? "True" : "False") << ")\n";
}

//------------------------------------------------------------------------------
void WriteScalarBar(std::ostream& out, vtkRenderer* renderer)
{
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator it;
  props->InitTraversal(it);
  while (vtkProp* prop = props->GetNextProp(it))
  {
    auto* bar = vtkScalarBarActor::SafeDownCast(prop);
    if (!bar)
    {
      continue;
    }
    const double* place = bar->GetPosition();
    out << "\nbar = vtkScalarBarActor()\nbar.SetLookupTable(colors)\nbar.SetTitle("
        << Quote(bar->GetTitle()) << ")\nbar.SetNumberOfLabels(" << bar->GetNumberOfLabels()
        << ")\nbar.SetLabelFormat(" << Quote(bar->GetLabelFormat())
        << ")\nbar.SetVerticalTitleSeparation(" << bar->GetVerticalTitleSeparation()
        << ")\nbar.UnconstrainedFontSizeOn()\n"
        << "for text in (bar.GetTitleTextProperty(), bar.GetLabelTextProperty()):\n"
        << "    text.SetColor(" << WriteThree(bar->GetTitleTextProperty()->GetColor())
        << ")\n    text.SetFontSize(" << bar->GetLabelTextProperty()->GetFontSize()
        << ")\n    text.BoldOff()\n    text.ItalicOff()\n    text.ShadowOff()\n"
        << "bar.GetTitleTextProperty().SetFontSize(" << bar->GetTitleTextProperty()->GetFontSize()
        << ")\nbar.SetPosition(" << WriteNumbers({ place[0], place[1] }) << ")\nbar.SetWidth("
        << WriteNumber(bar->GetWidth()) << ")\nbar.SetHeight(" << WriteNumber(bar->GetHeight())
        << ")\nrenderer.AddViewProp(bar)\n";
  }
}
}
