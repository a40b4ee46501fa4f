// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneFacts.h"

#include "Colormaps.h"
#include "DataSets.h"
#include "Picture.h"

#include "vtkActorCollection.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRelievoArraySampler.h"
#include "vtkRelievoDisplayStage.h"
#include "vtkRelievoLayerCatalogue.h"
#include "vtkRelievoLayerSource.h"
#include "vtkRelievoModelReader.h"
#include "vtkRelievoPass.h"
#include "vtkRelievoShadowStage.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace viewer
{
namespace
{
struct Array
{
  int Components = 0;
  bool HasValues = false; // a data set has values other than colours
};

// Arrays by name: of points and of cells.
using Arrays = std::array<std::map<std::string, Array>, 2>;

constexpr const char* Prefixes[] = { "point:", "cell:" };

bool AreValues(vtkDataArray* array)
{
  return array->GetNumberOfComponents() < 3 || !vtkUnsignedCharArray::SafeDownCast(array);
}

void AddArrays(vtkDataSet* block, Arrays& arrays)
{
  vtkDataSetAttributes* const attributes[] = { block->GetPointData(), block->GetCellData() };
  for (int kind = 0; kind < 2; ++kind)
  {
    for (int i = 0; i < attributes[kind]->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = attributes[kind]->GetArray(i);
      if (array && array->GetName())
      {
        Array& known = arrays[kind][array->GetName()];
        known.Components = std::max(known.Components, array->GetNumberOfComponents());
        known.HasValues = known.HasValues || AreValues(array);
      }
    }
  }
}

// Whether the array that colours a data set by default has values.
bool HasOwnValues(vtkDataSet* block)
{
  vtkDataArray* own = block->GetPointData()->GetScalars();
  own = own ? own : block->GetCellData()->GetScalars();
  return own && AreValues(own);
}

// Whether the given name is an array's, without a component.
bool HasWholeName(const look::LookChoice& look, const Facts& facts)
{
  return facts.Components.count(look.ColorByAsGiven) != 0;
}

// An ambiguous name needs point: or cell: in front.
bool NeedsPrefix(const std::string& name, const Arrays& arrays)
{
  const bool like = std::any_of(std::begin(Prefixes), std::end(Prefixes),
    [&name](const char* prefix) { return name.rfind(prefix, 0) == 0; });
  return like || vtkRelievoLayerCatalogue::GetIsLayer(name) ||
    (arrays[0].count(name) != 0 && arrays[1].count(name) != 0);
}
}

//------------------------------------------------------------------------------
Facts GetFacts(const Picture& picture)
{
  const scene::StyledScene& shown = picture.GetScene();
  const scene::Scene& scene = shown.GetScene();
  Arrays arrays;
  bool ownValues = false;
  vtkActorCollection* actors = scene.Renderer->GetActors();
  for (int i = 0; i < actors->GetNumberOfItems(); ++i)
  {
    vtkActor* actor = vtkActor::SafeDownCast(actors->GetItemAsObject(i));
    if (actor->GetMapper() && shown.IsOfFiles(actor)) // no skeleton
    {
      reading::ForEachDataSet(actor->GetMapper()->GetInputDataObject(0, 0), [&](vtkDataSet* block) {
        AddArrays(block, arrays);
        ownValues = ownValues || HasOwnValues(block);
      });
    }
  }
  Facts facts;
  if (!ownValues)
  {
    facts.Valueless.insert("");
  }
  facts.UpAxis = scene.UpAxis;
  if (vtkMath::AreBoundsInitialized(scene.Bounds))
  {
    std::copy_n(scene.Bounds, 6, facts.Bounds.begin());
  }
  for (const vtkSmartPointer<vtkLight>& light : shown.GetFileLights())
  {
    facts.Lights.push_back(!light->GetPositional() ? "sun"
        : light->GetConeAngle() < 90.0             ? "spot"
                                                   : "point");
  }
  for (int kind = 0; kind < 2; ++kind)
  {
    for (const auto& [name, array] : arrays[kind])
    {
      const bool shared = arrays[0].count(name) != 0 && arrays[1].count(name) != 0;
      const std::string colorBy = shared ? Prefixes[kind] + name : name;
      facts.Components[colorBy] = array.Components;
      if (!array.HasValues)
      {
        facts.Valueless.insert(colorBy);
      }
      if (array.Components <=
        vtkRelievoArraySampler::MaximumComponents) // larger arrays would break the others
      {
        facts.Layers.push_back(NeedsPrefix(name, arrays) ? Prefixes[kind] + name : name);
      }
    }
  }
  std::sort(facts.Layers.begin(), facts.Layers.end());
  facts.Times = scene.Times.value_or(facts.Times);
  std::set<std::string> known;
  for (const reading::PosedModel& model : scene.Models)
  {
    for (int i = 0; i < model.Reader->GetNumberOfAnimations(); ++i)
    {
      const std::string name = model.Reader->GetAnimationName(i);
      if (known.insert(name).second)
      {
        facts.Animations.push_back(name);
      }
    }
  }
  for (const scene::FramePointSet& set : shown.GetPoints())
  {
    Arrays ofPoints;
    reading::ForEachDataSet(set.Points->GetInputDataObject(0, 0),
      [&ofPoints](vtkDataSet* block) { AddArrays(block, ofPoints); });
    std::vector<std::string> names;
    for (const auto& array : ofPoints[0])
    {
      names.push_back(array.first);
    }
    facts.PointArrays[set.Stage].push_back(names);
  }
  return facts;
}

//------------------------------------------------------------------------------
std::optional<std::array<double, 2>> GetColorRange(const Picture& picture)
{
  if (picture.IsEmpty())
  {
    return std::nullopt;
  }
  vtkActorCollection* actors = picture.GetRenderer()->GetActors();
  for (int i = 0; i < actors->GetNumberOfItems(); ++i)
  {
    vtkActor* actor = vtkActor::SafeDownCast(actors->GetItemAsObject(i));
    vtkMapper* mapper = picture.GetScene().IsOfFiles(actor) ? actor->GetMapper() : nullptr;
    if (mapper && mapper->GetScalarVisibility() && mapper->GetUseLookupTableScalarRange())
    {
      const double* range = mapper->GetLookupTable()->GetRange();
      return std::array<double, 2>{ range[0], range[1] };
    }
  }
  return std::nullopt;
}

//------------------------------------------------------------------------------
bool HasColorsOfValues(const Picture& picture)
{
  return GetColorRange(picture) || picture.HasVolume();
}

//------------------------------------------------------------------------------
std::string FindColorLayer(const look::LookChoice& look, const Facts& facts)
{
  const std::string& name = HasWholeName(look, facts) ? look.ColorByAsGiven : look.ColorBy;
  std::vector<std::string> names = { name, Prefixes[0] + name };
  for (const std::string prefix : Prefixes) // given although not needed
  {
    if (name.rfind(prefix, 0) == 0)
    {
      names.push_back(name.substr(prefix.size()));
    }
  }
  const auto found =
    std::find_first_of(names.begin(), names.end(), facts.Layers.begin(), facts.Layers.end());
  return found == names.end() ? std::string() : *found;
}

//------------------------------------------------------------------------------
std::optional<std::array<double, 2>> FindSeenRange(
  const Picture& picture, const look::LookChoice& look, const Facts& facts)
{
  const std::string layer = FindColorLayer(look, facts);
  if (picture.IsEmpty() || layer.empty())
  {
    return std::nullopt;
  }
  vtkNew<vtkRelievoLayerSource> source;
  source->SetRenderer(picture.GetRenderer());
  source->AddLayer(layer);
  source->Update();
  vtkDataArray* values = source->GetOutput()->GetPointData()->GetArray(layer.c_str());
  const bool log = look::Colormap::Parse(look.Colormap).Log;
  const bool one = !HasWholeName(look, facts) && look.Component.has_value();
  std::array<double, 2> range = { VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX };
  for (vtkIdType i = 0; values && i < values->GetNumberOfTuples(); ++i)
  {
    double value = one ? values->GetComponent(i, *look.Component) : values->GetComponent(i, 0);
    for (int c = 1; !one && c < values->GetNumberOfComponents(); ++c)
    {
      value = std::hypot(value, values->GetComponent(i, c));
    }
    if (std::isfinite(value) && (value > 0.0 || !log))
    {
      range = { std::min(range[0], value), std::max(range[1], value) };
    }
  }
  return range[0] < range[1] ? std::optional(range) : std::nullopt;
}

//------------------------------------------------------------------------------
std::array<double, 2> GetShownRange(const Picture& picture)
{
  vtkRelievoPass* frame = picture.GetFrame();
  auto* stage = frame ? vtkRelievoDisplayStage::SafeDownCast(frame->GetStage("display")) : nullptr;
  return stage ? std::array<double, 2>{ stage->GetShownRange()[0], stage->GetShownRange()[1] }
               : std::array<double, 2>{ 0.0, 0.0 };
}

//------------------------------------------------------------------------------
relievoQt::LightNames GetLightNames(const Picture& picture)
{
  relievoQt::LightNames names;
  vtkRelievoPass* frame = picture.GetFrame();
  if (!frame) // VTK's picture
  {
    return names;
  }
  vtkRenderer* renderer = picture.GetRenderer();
  vtkRelievoShadowStage* shadows = frame->GetShadowStage();
  const std::vector<std::string> cast = shadows->GetShadowLayers(renderer);
  for (int i = 0; i < renderer->GetLights()->GetNumberOfItems(); ++i)
  {
    vtkLight* light = vtkLight::SafeDownCast(renderer->GetLights()->GetItemAsObject(i));
    const std::string layer = shadows->GetLightLayer(renderer, light);
    if (std::find(cast.begin(), cast.end(), layer) != cast.end())
    {
      names["shadow_" + std::to_string(i)] = shadows->GetLightName(renderer, light);
    }
  }
  return names;
}
}
