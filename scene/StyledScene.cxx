// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StyledScene.h"

#include "ReadContext.h"
#include "ShadowOptions.h"
#include "Shadows.h"
#include "Surface.h"

#include "vtkActorCollection.h"
#include "vtkCamera.h"
#include "vtkLightCollection.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkPropCollection.h"
#include "vtkRelievoPass.h"
#include "vtkRelievoStage.h"
#include "vtkRenderWindow.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <vector>

namespace scene
{
namespace
{
// VTK's copy of a property releases textures without having referenced them: once for each name of
// a texture.
vtkSmartPointer<vtkProperty> Copy(vtkProperty* property)
{
  std::map<vtkTexture*, int> counts; // references, including the copy's
  for (const auto& named : property->GetAllTextures())
  {
    const auto known = counts.emplace(named.second, named.second->GetReferenceCount()).first;
    ++known->second;
  }
  auto copy = vtkSmartPointer<vtkProperty>::New();
  copy->DeepCopy(property);
  for (const auto& [texture, count] : counts)
  {
    while (texture->GetReferenceCount() < count)
    {
      texture->Register(copy);
    }
  }
  return copy;
}

std::vector<vtkSmartPointer<vtkProp>> GetProps(vtkRenderer* renderer)
{
  std::vector<vtkSmartPointer<vtkProp>> props;
  vtkPropCollection* all = renderer->GetViewProps();
  for (int i = 0; i < all->GetNumberOfItems(); ++i)
  {
    props.emplace_back(vtkProp::SafeDownCast(all->GetItemAsObject(i)));
  }
  return props;
}

// The values of the options that `counts` selects.
template <typename Counts>
std::string MakeKey(const Settings& settings, const Counts& counts)
{
  std::string key;
  for (const vtkRelievoOption& option : GetRenderCommand().Options)
  {
    for (const std::string& value :
      counts(option) ? settings.GetAll(option.Name) : std::vector<std::string>())
    {
      key += option.Name + '\n' + value + '\n';
    }
  }
  return key;
}

std::string MakeSurfaceKey(const Settings& settings, const RenderOptions& options)
{
  const bool shadowed = !options.Surface.HeightMap.empty() && ShowsShadows(options);
  const auto shapes = [](const vtkRelievoOption& option) {
    return option.Has(vtkRelievoOption::SHAPES_SURFACE);
  };
  return MakeKey(settings, shapes) + (shadowed ? "in its own shadow" : "") +
    (options.Surface.FindsIntensity ? "of its own intensity" : "");
}

std::string MakeStyleKey(const Settings& settings)
{
  return MakeKey(settings,
    [](const vtkRelievoOption& option) { return !option.Has(vtkRelievoOption::KEEPS_STYLE); });
}

RenderOptions WithCamera(RenderOptions options, vtkCamera* camera)
{
  options.View.Place = GetPlace(camera);
  options.View.ParallelScale.reset();
  if (camera->GetParallelProjection())
  {
    options.View.ParallelScale = camera->GetParallelScale();
    options.View.Angle.reset();
  }
  return options;
}
}

//------------------------------------------------------------------------------
std::string GetSceneKey(const Settings& settings)
{
  std::string key = MakeKey(settings,
    [](const vtkRelievoOption& option) { return option.Has(vtkRelievoOption::READS_FILES); });
  key += settings.Get("--shading") == "flat" ? "flat\n" : "";
  for (const std::string& file : settings.Files)
  {
    key += file + '\n';
  }
  return key;
}

//------------------------------------------------------------------------------
std::string GetReadingKey(const Settings& settings)
{
  std::string key = GetSceneKey(settings);
  for (const PointStage& stage : GetPointStages())
  {
    key += MakeKey(settings,
      [&stage](const vtkRelievoOption& option) { return option.Name == "--" + stage.Name; });
  }
  return key;
}

//------------------------------------------------------------------------------
StyledScene::StyledScene(const Scene& scene, const FramePoints& points)
  : Read(scene)
  , Points(points)
{
  vtkRenderer* renderer = this->Read.Renderer;
  this->Props = this->Unstyled = GetProps(renderer);
  for (vtkProp* prop : this->Props)
  {
    vtkActor* actor = vtkActor::SafeDownCast(prop);
    vtkMapper* mapper = actor ? actor->GetMapper() : nullptr;
    if (!mapper)
    {
      continue;
    }
    const char* name = mapper->GetArrayName();
    vtkTexture* texture = actor->GetTexture();
    this->Parts.push_back(
      { actor, Copy(actor->GetProperty()), texture, texture && texture->GetUseSRGBColorSpace(),
        vtkRelievoMaterial::Get(actor), mapper->GetScalarVisibility() != 0, mapper->GetScalarMode(),
        mapper->GetColorMode(), mapper->GetArrayAccessMode(), mapper->GetArrayId(),
        name ? name : "", mapper->GetUseLookupTableScalarRange() != 0,
        mapper->GetInterpolateScalarsBeforeMapping() != 0 });
  }
  vtkLightCollection* lights = renderer->GetLights();
  for (int i = 0; i < lights->GetNumberOfItems(); ++i)
  {
    this->Lights.emplace_back(vtkLight::SafeDownCast(lights->GetItemAsObject(i)));
  }
}

//------------------------------------------------------------------------------
bool StyledScene::IsOfFiles(vtkActor* actor) const
{
  return std::any_of(this->Parts.begin(), this->Parts.end(),
    [actor](const Part& part) { return part.Actor == actor; });
}

//------------------------------------------------------------------------------
std::map<int, std::string> StyledScene::GetObjectNames() const
{
  std::map<int, std::string> names;
  int actor = 0;
  for (std::size_t i = 0; i < this->Read.Counts.size(); ++i)
  {
    const std::string name = std::filesystem::path(this->Options.Files[i]).filename().string();
    for (int k = 0; k < this->Read.Counts[i]; ++k)
    {
      names[actor++] = name;
    }
  }
  if (this->Read.Ground)
  {
    names[this->GetRenderer()->GetActors()->IsItemPresent(this->Read.Ground) - 1] = "ground";
  }
  return names;
}

//------------------------------------------------------------------------------
vtkRelievoPass* StyledScene::GetFrame() const
{
  vtkRenderer* renderer = this->GetRenderer();
  return renderer ? vtkRelievoPass::SafeDownCast(renderer->GetPass()) : nullptr;
}

//------------------------------------------------------------------------------
void StyledScene::SetPoints(const FramePoints& points)
{
  this->Points = points;
  vtkRelievoPass::Detach(this->GetRenderer()); // a new frame takes the points
}

//------------------------------------------------------------------------------
bool StyledScene::HasSurfaceOf(const Settings& settings) const
{
  return MakeSurfaceKey(settings, settings.Parse()) == this->Surface;
}

//------------------------------------------------------------------------------
void StyledScene::Update(
  const Settings& settings, const RenderOptions& asked, bool keepCamera, Progress& progress)
{
  vtkRenderer* renderer = this->GetRenderer();
  const RenderOptions known = FollowFile(asked, this->Read);
  const RenderOptions options = keepCamera ? WithCamera(known, renderer->GetActiveCamera()) : known;
  const std::string surface = MakeSurfaceKey(settings, options);
  const std::string style = MakeStyleKey(settings);
  const bool isNewSurface = surface != this->Surface;
  const bool isStyled = !isNewSurface && style == this->Style;
  try
  {
    if (!isStyled)
    {
      renderer->GetActiveCamera()->SetViewAngle(StandardViewAngle);
      this->RemoveStyle();
      StyleScene(this->Read, options);
    }
    else if (!keepCamera)
    {
      renderer->GetActiveCamera()->SetViewAngle(StandardViewAngle);
      PlaceCamera(renderer, options.View, options.UpAxis, this->GetBounds());
    }
    if (isNewSurface)
    {
      this->ReplaceSurface(options, progress);
    }
    if (!isStyled)
    {
      // Materials and the look decide together what is translucent.
      renderer->SetUseDepthPeeling(std::any_of(this->Parts.begin(), this->Parts.end(),
        [](const Part& part) { return part.Actor->HasTranslucentPolygonalGeometry() != 0; }));
    }
    this->Surface = surface;
    this->Style = style;
    this->SetFrame(options, isStyled);
  }
  catch (...)
  {
    this->Style = "\n";
    throw;
  }
  this->Options = options;
}

//------------------------------------------------------------------------------
void StyledScene::Restore(const Part& part)
{
  part.Actor->SetProperty(Copy(part.Property));
  part.Actor->SetTexture(part.Texture);
  if (part.Texture)
  {
    part.Texture->SetUseSRGBColorSpace(part.SRGB);
  }
  vtkMapper* mapper = part.Actor->GetMapper();
  mapper->SetScalarVisibility(part.Colored);
  mapper->SetScalarMode(part.ScalarMode);
  mapper->SetColorMode(part.ColorMode);
  mapper->SetUseLookupTableScalarRange(part.OwnRange);
  mapper->SetInterpolateScalarsBeforeMapping(part.Interpolated);
  mapper->SetLookupTable(nullptr);
  mapper->SetArrayName(part.ArrayName.c_str());
  mapper->SetArrayId(part.ArrayId);
  mapper->SetArrayAccessMode(part.ArrayAccess);
}

//------------------------------------------------------------------------------
void StyledScene::RemoveStyle()
{
  vtkRenderer* renderer = this->Read.Renderer;
  for (const vtkSmartPointer<vtkProp>& prop : GetProps(renderer))
  {
    if (std::find(this->Unstyled.begin(), this->Unstyled.end(), prop) == this->Unstyled.end())
    {
      renderer->RemoveViewProp(prop);
    }
  }
  for (const Part& part : this->Parts)
  {
    this->Restore(part);
  }
  renderer->RemoveAllLights();
  renderer->AutomaticLightCreationOn();
  for (vtkLight* light : this->Lights)
  {
    renderer->AddLight(light);
  }
  renderer->SetBackground(0.0, 0.0, 0.0);
  renderer->GradientBackgroundOff();
}

//------------------------------------------------------------------------------
void StyledScene::RemoveSurface()
{
  for (const Part& part : this->Parts)
  {
    if (vtkRelievoMaterial* material = vtkRelievoMaterial::Get(part.Actor))
    {
      material->Detach(part.Actor);
    }
    if (part.Material)
    {
      part.Material->Attach(part.Actor);
    }
  }
  for (const vtkSmartPointer<vtkProp>& prop : this->Unstyled)
  {
    if (std::find(this->Props.begin(), this->Props.end(), prop) == this->Props.end())
    {
      this->Read.Renderer->RemoveViewProp(prop);
    }
  }
  this->Unstyled = this->Props;
}

//------------------------------------------------------------------------------
void StyledScene::ReplaceSurface(const RenderOptions& options, Progress& progress)
{
  std::vector<vtkSmartPointer<vtkRelievoMaterial>> materials;
  for (const Part& part : this->Parts)
  {
    materials.emplace_back(vtkRelievoMaterial::Get(part.Actor));
  }
  const std::vector<vtkSmartPointer<vtkProp>> kept = this->Unstyled;
  this->RemoveSurface();
  const std::vector<vtkSmartPointer<vtkProp>> before = GetProps(this->Read.Renderer);
  const auto keepNew = [this, &before] {
    for (const vtkSmartPointer<vtkProp>& prop : GetProps(this->Read.Renderer))
    {
      if (std::find(before.begin(), before.end(), prop) == before.end())
      {
        this->Unstyled.push_back(prop);
      }
    }
  };
  try
  {
    ReadContext context(progress, options.AllowedFolders);
    const Scene& scene = this->Read;
    SetSurface(scene.Renderer, { scene.Ground, scene.Grid ? scene.Grid->GetLines() : nullptr },
      options.Surface, options.UpAxis, options.Look.Opacity >= 1.0, context);
    keepNew();
  }
  catch (...)
  {
    keepNew();
    this->RemoveSurface();
    for (std::size_t i = 0; i < materials.size(); ++i)
    {
      if (materials[i])
      {
        materials[i]->Attach(this->Parts[i].Actor);
      }
    }
    for (const vtkSmartPointer<vtkProp>& prop : kept)
    {
      if (!this->Read.Renderer->HasViewProp(prop))
      {
        this->Read.Renderer->AddViewProp(prop);
      }
    }
    this->Unstyled = kept;
    throw;
  }
}

//------------------------------------------------------------------------------
// Unchanged stages keep their resources; choices of lights and volumes, made since the last update
// on the stage itself, stay as long as the options about them are the same.
void StyledScene::SetFrame(const RenderOptions& options, bool isStyled)
{
  vtkRenderer* renderer = this->GetRenderer();
  if (!NeedsFrame(options))
  {
    vtkRelievoPass::Detach(renderer);
    return;
  }
  vtkNew<vtkRelievoPass> wanted;
  scene::SetFrame(wanted, renderer, options, FramePoints());
  const auto colors = [](const RenderOptions& of) {
    const std::string* given = FindStageChoice(of.Stages, "shadows", "colored_shadows");
    return given && *given == "on";
  };
  if (colors(options) != colors(this->Options))
  {
    vtkRelievoPass::Detach(renderer); // the frame marks props as casters
  }
  const bool isNew = !this->GetFrame();
  vtkRelievoPass* frame = vtkRelievoPass::Attach(renderer);
  for (int i = 0; i < wanted->GetNumberOfStages(); ++i)
  {
    vtkRelievoStage* from = wanted->GetStage(i);
    vtkRelievoStage* to = frame->GetStage(from->GetStageName());
    to->SetEnabled(from->GetEnabled());
    for (int k = 0; k < from->GetNumberOfParameters(); ++k)
    {
      const std::string name = from->GetParameterName(k);
      const std::string value = from->GetParameter(name);
      if (to->GetParameter(name) != value)
      {
        to->SetParameter(name, value);
      }
    }
  }
  if (isNew || !isStyled)
  {
    SetCastingLights(frame, renderer, options);
  }
  if (isNew || options.GetWord("--volume-shadows") != this->Options.GetWord("--volume-shadows"))
  {
    SetCastingVolumes(frame, renderer, options);
  }
  if (isNew)
  {
    AddFramePoints(frame, this->Points);
  }
}
}
