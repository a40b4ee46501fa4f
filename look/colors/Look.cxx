// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Look.h"

#include "Actors.h"
#include "Colormaps.h"
#include "DataSets.h"
#include "Errors.h"
#include "OptionRows.h"
#include "ScalarBar.h"
#include "Values.h"
#include "VolumeImages.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkRelievoColorRange.h"
#include "vtkRelievoMaterial.h"
#include "vtkRelievoVTKVersions.h"
#include "vtkRenderer.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolume.h"
#include "vtkVolumeCollection.h"
#include "vtkVolumeMapper.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <vector>

namespace look
{
namespace
{
void ForEachActor(vtkRenderer* renderer, const std::function<void(vtkActor*)>& visit)
{
  vtkActorCollection* actors = renderer->GetActors();
  vtkCollectionSimpleIterator it;
  actors->InitTraversal(it);
  while (vtkActor* actor = actors->GetNextActor(it))
  {
    if (actor->GetMapper())
    {
      visit(actor);
    }
  }
}

void ForEachVolume(
  vtkRenderer* renderer, const std::function<void(vtkImageData*, vtkVolume*)>& visit)
{
  vtkVolumeCollection* volumes = renderer->GetVolumes();
  vtkCollectionSimpleIterator it;
  volumes->InitTraversal(it);
  while (vtkVolume* volume = volumes->GetNextVolume(it))
  {
    visit(vtkImageData::SafeDownCast(volume->GetMapper()->GetInputDataObject(0, 0)), volume);
  }
}

// The source of an actor's colours.
struct Coloring
{
  vtkMapper* Mapper;
  std::vector<vtkDataArray*> Arrays;
  bool OfPoints = false;
  std::string Name;    // of the array; may be empty
  bool Mapped = false; // has a normal map or heights
};

bool AreColors(const std::vector<vtkDataArray*>& arrays, const LookChoice& look)
{
  return !look.Magnitude && !look.Component && vtkUnsignedCharArray::SafeDownCast(arrays[0]) &&
    arrays[0]->GetNumberOfComponents() >= 3;
}

//------------------------------------------------------------------------------
// The chosen array of an actor's data, or else the active scalars; points before cells.
Coloring Find(vtkActor* actor, const LookChoice& look, bool mapped)
{
  const bool ofPoints = look.Place != LookChoice::OfCells;
  const bool ofCells = look.Place != LookChoice::OfPoints;
  vtkRelievoMaterial* material = vtkRelievoMaterial::Get(actor);
  Coloring found = { actor->GetMapper(), {}, true, look.ColorBy,
    mapped || (material && material->GetNormalMap()) };
  found.Mapper->Update();
  for (const bool points : { true, false })
  {
    if (!(points ? ofPoints : ofCells))
    {
      continue;
    }
    ForEachDataSet(found.Mapper->GetInputDataObject(0, 0), [&](vtkDataSet* block) {
      vtkDataSetAttributes* attributes = points
        ? static_cast<vtkDataSetAttributes*>(block->GetPointData())
        : static_cast<vtkDataSetAttributes*>(block->GetCellData());
      vtkDataArray* array = look.ColorBy.empty() ? attributes->GetScalars()
                                                 : attributes->GetArray(look.ColorBy.c_str());
      if (array && array->GetDataType() != VTK_BIT) // VTK maps bits to no colours
      {
        found.Arrays.push_back(array);
      }
    });
    if (!found.Arrays.empty())
    {
      found.OfPoints = points;
      found.Name = found.Arrays[0]->GetName() ? found.Arrays[0]->GetName() : "";
      break;
    }
  }
  return found;
}

//------------------------------------------------------------------------------
void CheckFound(const std::map<std::string, std::vector<Coloring>>& all, const ArrayNames& arrays,
  const LookChoice& look)
{
  if (all.empty() && !look.ColorBy.empty())
  {
    const std::vector<std::string> names(arrays.Names.begin(), arrays.Names.end());
    throw UsageError("--color-by: got '" + look.ColorBy + "', expected " +
      (names.empty() ? "no array: nothing that is drawn has any"
                     : "an array of the drawn data: " + Join(names, ", ")));
  }
  for (const auto& named : all)
  {
    for (const Coloring& each : named.second)
    {
      for (vtkDataArray* array : each.Arrays)
      {
        const int components = array->GetNumberOfComponents();
        if (look.Component && *look.Component >= components)
        {
          throw UsageError("--color-by: got component " + std::to_string(*look.Component) +
            " of '" + look.ColorBy + "', expected one from 0 to " + std::to_string(components - 1));
        }
      }
    }
  }
}

// Adds the range of a component, -1 for the magnitude; with `positive`, of positive values only.
void AddRange(vtkDataArray* array, int component, bool positive, std::array<double, 2>& range)
{
  double own[2];
  array->GetFiniteRange(own, component);
  if (positive && own[0] <= 0.0)
  {
    own[0] = VTK_DOUBLE_MAX;
    const int count = array->GetNumberOfComponents();
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      double value = component < 0 ? 0.0 : array->GetComponent(i, component);
      for (int c = 0; component < 0 && c < count; ++c)
      {
        value = std::hypot(value, array->GetComponent(i, c));
      }
      own[0] = value > 0.0 ? std::min(own[0], value) : own[0];
    }
  }
  if (own[0] <= own[1])
  {
    range = { std::min(range[0], own[0]), std::max(range[1], own[1]) };
  }
}

// Values that differ only by rounding get the range of one value.
std::array<double, 2> WithoutRounding(const std::array<double, 2>& range, double rounding)
{
  return relievo::IsOneValue(range, rounding) ? std::array<double, 2>{ range[0], range[0] } : range;
}

//------------------------------------------------------------------------------
// Empty if there are no values.
std::array<double, 2> FindRange(
  const std::vector<Coloring>& all, const LookChoice& look, bool positive)
{
  std::array<double, 2> range = { VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX };
  double rounding = 0.0;
  for (const Coloring& each : all)
  {
    if (AreColors(each.Arrays, look))
    {
      continue;
    }
    for (vtkDataArray* array : each.Arrays)
    {
      AddRange(array, look.Component.value_or(array->GetNumberOfComponents() > 1 ? -1 : 0),
        positive, range);
      rounding = std::max(rounding, relievo::GetRounding(array->GetDataType()));
    }
  }
  return WithoutRounding(range, rounding);
}

//------------------------------------------------------------------------------
bool HasNan(const std::vector<Coloring>& all, const LookChoice& look)
{
  for (const Coloring& each : all)
  {
    for (vtkDataArray* array : each.Arrays)
    {
      const int count = array->GetNumberOfComponents();
      const int first = look.Component.value_or(0);
      for (vtkIdType i = 0;
           relievo::GetRounding(array->GetDataType()) > 0.0 && i < array->GetNumberOfTuples(); ++i)
      {
        for (int c = first; c < (look.Component ? first + 1 : count); ++c)
        {
          if (std::isnan(array->GetComponent(i, c)))
          {
            return true;
          }
        }
      }
    }
  }
  return false;
}

//------------------------------------------------------------------------------
// The values of the first and last colour, for values with this range.
std::array<double, 2> ChooseRange(
  const std::array<double, 2>& found, const LookChoice& look, const std::string& name)
{
  if (look.Range)
  {
    return *look.Range;
  }
  const bool any = found[0] <= found[1];
  if (Colormap::Parse(look.Colormap).Log)
  {
    if (!any)
    {
      throw UsageError("--colormap log: '" + name + "' has no positive values");
    }
    return { found[0], found[1] > found[0] ? found[1] : 10.0 * found[0] };
  }
  if (!any)
  {
    return { 0.0, 1.0 };
  }
  if (found[0] == found[1] && !look.Symmetric)
  {
    return relievo::GetRangeOfOneValue(found[0]);
  }
  const double far = std::max(std::abs(found[0]), std::abs(found[1]));
  return look.Symmetric && far > 0.0 ? std::array<double, 2>{ -far, far } : found;
}

//------------------------------------------------------------------------------
void SetColoring(const Coloring& coloring, vtkColorTransferFunction* map, const LookChoice& look)
{
  vtkMapper* mapper = coloring.Mapper;
  mapper->ScalarVisibilityOn();
  if (!look.ColorBy.empty())
  {
    coloring.OfPoints ? mapper->SetScalarModeToUsePointFieldData()
                      : mapper->SetScalarModeToUseCellFieldData();
    mapper->SelectColorArray(look.ColorBy.c_str());
  }
  if (AreColors(coloring.Arrays, look))
  {
    return;
  }
  mapper->SetColorModeToMapScalars();
  mapper->SetLookupTable(map);
  mapper->UseLookupTableScalarRangeOn();
  // Interpolates values between points, not colours: each colour is one of the map's. A normal map
  // or heights need the texture coordinates that this uses.
  mapper->SetInterpolateScalarsBeforeMapping(coloring.OfPoints && !coloring.Mapped);
}

//------------------------------------------------------------------------------
// Values can be read from their colours on a bar only if light changes lightness a little and no
// highlight adds white: D. A. Szafir, A. Sarikaya, M. Gleicher, Lightness constancy in surface
// visualization, IEEE TVCG 22(9), 2016. Scaling a display's colour by k keeps its hue and scales
// OKLab's lightness by k^0.8 at least: with a preset's fill alone 0.8 of it remains, and 0.71 where
// no sky is visible.
void KeepReadable(vtkActor* actor)
{
  constexpr double unlit = 0.57;
  vtkMapper* mapper = actor->GetMapper();
  vtkProperty* property = actor->GetProperty();
  if (mapper->GetScalarVisibility() && mapper->GetColorMode() == VTK_COLOR_MODE_MAP_SCALARS)
  {
    if (property->GetInterpolation() == VTK_PBR) // it has no such part
    {
      property->SetInterpolationToPhong();
    }
    property->SetAmbient(unlit);
    property->SetDiffuse(1.0 - unlit);
    property->SetSpecular(0.0);
  }
}

//------------------------------------------------------------------------------
// Arrays of one name share a range of colours.
std::map<std::string, std::vector<Coloring>> FindAll(
  vtkRenderer* renderer, const LookChoice& look, bool mapped)
{
  std::map<std::string, std::vector<Coloring>> all;
  ForEachActor(renderer, [&](vtkActor* actor) {
    // The file may have coloured it already (glTF).
    if (look.ColorBy.empty() && actor->GetMapper()->GetColorMode() == VTK_COLOR_MODE_DIRECT_SCALARS)
    {
      return;
    }
    const Coloring coloring = Find(actor, look, mapped);
    if (!coloring.Arrays.empty())
    {
      all[coloring.Name].push_back(coloring);
    }
    else
    {
      actor->GetMapper()->ScalarVisibilityOff();
    }
  });
  return all;
}

//------------------------------------------------------------------------------
void SetColors(vtkRenderer* renderer, const LookChoice& look, const ArrayNames& arrays, bool mapped)
{
  const std::map<std::string, std::vector<Coloring>> all = FindAll(renderer, look, mapped);
  CheckFound(all, arrays, look);
  const int steps = Colormap::Parse(look.Colormap).Steps;
  int bars = 0;
  for (const auto& [name, colorings] : all)
  {
    const bool colors = std::all_of(colorings.begin(), colorings.end(),
      [&look](const Coloring& each) { return AreColors(each.Arrays, look); });
    const bool log = Colormap::Parse(look.Colormap).Log;
    const std::array<double, 2> found = FindRange(colorings, look, log);
    const bool values = found[0] <= found[1];
    const std::array<double, 2> range =
      colors ? std::array<double, 2>{ 1.0, 2.0 } : ChooseRange(found, look, name);
    const vtkSmartPointer<vtkColorTransferFunction> map = MakeColormap(look.Colormap, range);
    look.Component ? map->SetVectorModeToComponent() : map->SetVectorModeToMagnitude();
    map->SetVectorComponent(look.Component.value_or(0));
    for (const Coloring& each : colorings)
    {
      SetColoring(each, map, look);
    }
    if (look.ScalarBar && values && ++bars == 1)
    {
      AddScalarBar(renderer, map, steps,
        { name + (look.Component ? " " + std::to_string(*look.Component) : ""), found,
          HasNan(colorings, look) },
        look.Bar, look.Print);
    }
  }
  ForEachVolume(renderer, [&](vtkImageData* image, vtkVolume* volume) {
    vtkDataArray* values = image->GetPointData()->GetScalars();
    const std::string name = values->GetName() ? values->GetName() : "";
    std::array<double, 2> range = { VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX };
    AddRange(values, 0, Colormap::Parse(look.Colormap).Log, range);
    const std::array<double, 2> found = range;
    range =
      ChooseRange(WithoutRounding(range, relievo::GetRounding(values->GetDataType())), look, name);
    volume->GetProperty()->SetColor(MakeColormap(look.Colormap, range, true));
    if (look.ScalarBar && ++bars == 1)
    {
      AddScalarBar(
        renderer, MakeColormap(look.Colormap, range), steps, { name, found }, look.Bar, look.Print);
    }
  });
  if (look.ScalarBar && bars != 1)
  {
    throw UsageError(std::string("--scalar-bar: ") +
      (bars == 0 ? "no values give the colours" : "several arrays give the colours") +
      "; give --color-by NAME as well");
  }
}
}

//------------------------------------------------------------------------------
void SetShading(vtkRenderer* renderer, Shading kind)
{
  vtkActorCollection* actors = renderer->GetActors();
  vtkCollectionSimpleIterator place;
  actors->InitTraversal(place);
  while (vtkActor* actor = actors->GetNextActor(place))
  {
    switch (kind)
    {
      case Shading::Flat:
        actor->GetProperty()->SetInterpolationToFlat();
        break;
      case Shading::Gouraud:
        actor->GetProperty()->SetInterpolationToGouraud();
        break;
      case Shading::Phong:
        actor->GetProperty()->SetInterpolationToPhong();
        break;
      case Shading::PBR:
        actor->GetProperty()->SetInterpolationToPBR();
        if (vtkTexture* texture = actor->GetTexture()) // PBR ignores it
        {
          texture->UseSRGBColorSpaceOn();
          actor->GetProperty()->SetBaseColorTexture(texture);
        }
        break;
      case Shading::FromFile:
        break;
    }
  }
}

//------------------------------------------------------------------------------
void SetLook(vtkRenderer* renderer, LookChoice look, const ArrayNames& arrays, bool mapped)
{
  if (arrays.Names.count(look.ColorByAsGiven))
  {
    // A suffix that looks like a component belongs to the name here.
    look.ColorBy = look.ColorByAsGiven;
    look.Component.reset();
    look.Magnitude = false;
  }
  else if (arrays.Names.count(look.ColorBy) == 0 && arrays.Placed.count(look.ColorBy))
  {
    const std::size_t colon = look.ColorBy.find(':');
    look.Place = look.ColorBy[0] == 'p' ? LookChoice::OfPoints : LookChoice::OfCells;
    look.ColorBy = look.ColorBy.substr(colon + 1);
  }
  if (!look.Background.empty())
  {
    const Color& bottom = look.Background.front();
    const Color& top = look.Background.back();
    renderer->SetBackground(bottom[0], bottom[1], bottom[2]);
    renderer->SetBackground2(top[0], top[1], top[2]);
    renderer->SetGradientBackground(look.Background.size() > 1);
#ifdef RELIEVO_VTK_GRADIENT_NOISE
    renderer->DitherGradientOff(); // one picture on all versions, whole or in bands
#endif
  }
  SetColors(renderer, look, arrays, mapped);
  ForEachActor(renderer, [&](vtkActor* actor) {
    vtkProperty* property = actor->GetProperty();
    if (look.IsReadable)
    {
      KeepReadable(actor);
    }
    if (look.Solid || !look.ColorBy.empty())
    {
      // A texture would multiply the colours.
      actor->SetTexture(nullptr);
      property->RemoveTexture("albedoTex");
    }
    if (look.Solid)
    {
      actor->GetMapper()->ScalarVisibilityOff();
      property->SetColor((*look.Solid)[0], (*look.Solid)[1], (*look.Solid)[2]);
    }
    if (look.Opacity < 1.0)
    {
      property->SetOpacity(look.Opacity * property->GetOpacity());
    }
    if (look.PointSize > 1.0)
    {
      property->SetPointSize(static_cast<float>(look.PointSize));
      property->RenderPointsAsSpheresOn();
    }
    if (look.Edges)
    {
      property->EdgeVisibilityOn();
      property->SetEdgeColor(0.1, 0.1, 0.1);
      if (look.Print.Width > 0.0)
      {
        property->SetLineWidth(static_cast<float>(look.Print.GetLineWidth()));
      }
    }
  });
  ForEachVolume(renderer, [&look](vtkImageData*, vtkVolume* volume) {
    SetVolumeOpacity(volume, look.Opacity);
    SetVolumeCurve(volume, look.OpacityCurve);
    SetVolumeStep(volume, look.VolumeStep);
  });
}

//------------------------------------------------------------------------------
void AddShadingOption(OptionRows& rows, Shading& shading)
{
  rows
    .AddChoice("--shading", "KIND", { "flat", "gouraud", "phong", "pbr" },
      "@choices@ (phong; glTF keeps its own materials)",
      [&shading](std::size_t place) {
        constexpr Shading kinds[] = { Shading::Flat, Shading::Gouraud, Shading::Phong,
          Shading::PBR };
        shading = kinds[place];
      })
    .NamedIn("Look", "Shading");
}

//------------------------------------------------------------------------------
void AddLookOptions(OptionRows& rows, LookChoice& look)
{
  rows
    .AddFlag("--grid",
      "shows a grid around the scene with numbers on its axes x, y and z, only in the "
      "picture",
      look.Grid)
    .NamedIn("Scene", "Grid")
    .RefuseLens("it is drawn only over a pinhole's picture");
  rows
    .Add("--scale-bar", "UNIT[,length=LENGTH]",
      "shows a scale bar of a round length, or of LENGTH, at the lower right, only in the "
      "picture. UNIT is the unit of the scene's coordinates, such as mm; none: the number "
      "alone. In perspective the bar is correct at the depth of the focal point",
      look, TakeScaleBar)
    .NamedIn("Scene", "Scale bar")
    .RefuseLens("it is drawn only over a pinhole's picture")
    .Words = { "none" };
  rows
    .Add("--color-by", "NAME[,COMPONENT]",
      "colours by a point or cell array, point:NAME or cell:NAME if two share a name; "
      "COMPONENT is a number from 0, or magnitude (the active scalars; the magnitude; "
      "bytes of 3 or 4 components are colours)",
      look, TakeColorBy)
    .Is(OptionRows::Option::OF_FILES)
    .NamedIn("Look", "Colour by");
  rows
    .Add("--range", "MIN,MAX",
      "values of the first and the last colour (the array's finite range in all files); "
      "symmetric: that range, extended to be symmetric around zero",
      look, TakeRange)
    .Is(OptionRows::Option::OF_FILES)
    .NamedIn("Look", "Range")
    .Words = { "symmetric" };
  rows
    .Add("--colormap", "NAME",
      "viridis, cool-warm, grey, hot, rainbow, ember, ocean, blue-orange, green-purple, phase or "
      "categories, or colours between commas, evenly spaced "
      "or at shares of the range, such as black,0.3=#ff8000,white; then optionally "
      ":reversed, :log (by the logarithm of the values), :steps=N (N colours) and "
      ":nan=COLOR (the colour of NaN) (viridis)",
      look, TakeColormap)
    .NamedIn("Look", "Colour map")
    .Words = GetColormapNames();
  rows.AddFlag("--scalar-bar", "shows the colours and their values at the right", look.ScalarBar)
    .Is(OptionRows::Option::OF_FILES)
    .NamedIn("Look", "Show a colour bar")
    .RefuseLens("it is drawn only over a pinhole's picture");
  rows
    .Add("--bar", "PLACE[,title=TEXT][,unit=UNIT]",
      "the scalar bar at the right, left, bottom or top (where it is horizontal), with another "
      "title than the array's name, and with the unit of the values",
      look, TakeBar)
    .Is(OptionRows::Option::OF_FILES)
    .NamedIn("Look", "Side of the bar")
    .RefuseLens("it is drawn only over a pinhole's picture")
    .Words = { "right", "left", "bottom", "top" };
  rows
    .Add("--color", "COLOR",
      "one colour for all meshes; COLOR is R/G/B from 0 to 1 as displays show it, "
      "#rrggbb, or a name such as slategray",
      look, TakeColor)
    .NamedIn("Look", "One colour");
  rows
    .AddNumber("--opacity", "A", "opacity of all meshes and volumes, @bounds@ (1)", { 0.0, 1.0 },
      look.Opacity)
    .Is(OptionRows::Option::SHAPES_SURFACE)
    .NamedIn("Look", "Opacity");
  rows
    .Add("--opacity-curve", "VALUE/A,...",
      "volumes (--image volume): the opacity at two or more values, 0 to 1 over a hundredth of the "
      "image's diagonal, linear in between (0 below the threshold that separates the values best)",
      look, TakeOpacityCurve)
    .Is(OptionRows::Option::SHAPES_SURFACE)
    .NamedIn("Look", "Opacity curve")
    .DropAs("the opacity curve");
  rows
    .AddNumber("--volume-step", "SHARE",
      "step of rays through volumes, as a share of the smallest distance between the image's "
      "points, @bounds@; smaller steps are slower and show fewer rings (0.5, and finer in images "
      "of few points)",
      { 0.05, 4.0 }, look.VolumeStep)
    .Is(OptionRows::Option::SHAPES_SURFACE)
    .NamedIn("Look", "Step");
  rows
    .AddNumber("--point-size", "PIXELS",
      "width of points, @bounds@ pixels; wider than 1, they are drawn as spheres (4 with a "
      "preset, else 1)",
      { 1.0, 100.0 }, look.PointSize)
    .NamedIn("Look", "Point size");
  rows.AddFlag("--edges", "draws the edges of cells", look.Edges).NamedIn("Look", "Show edges");
  rows
    .Add("--background", "COLOR[,COLOR]",
      "one colour, or a gradient: the bottom's and the top's (the preset's; black with "
      "--preset none)",
      look, TakeBackground)
    .NamedIn("Look", "Background");
}
}
