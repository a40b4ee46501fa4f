// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LayerWords.h"

#include "vtkRelievoColormaps.h"
#include "vtkRelievoDisplayStage.h"
#include "vtkRelievoLayer.h"
#include "vtkRelievoLayerCatalogue.h"

#include <QColor>
#include <QStringList>

#include <cmath>
#include <set>

namespace relievoQt
{
namespace
{
constexpr int Shades = 256;
constexpr int ValueDigits = 4;

const char* const WorldUnits = "world units";

bool IsLength(const std::string& layer)
{
  const std::set<std::string> lengths = { "depth", "range", "position", "light_depth",
    "volume_depth" };
  return lengths.count(layer) != 0;
}

QImage MakeStrip(const std::string& map, bool reversed)
{
  QImage strip(Shades, 1, QImage::Format_RGB32);
  const auto colors = vtkRelievoColormaps::Sample(map, reversed, Shades);
  for (int i = 0; i < Shades; ++i)
  {
    const auto& rgb = colors[static_cast<std::size_t>(i)];
    strip.setPixelColor(i, 0, QColor::fromRgbF(rgb[0], rgb[1], rgb[2]));
  }
  return strip;
}

// One line about the layer, without the unit that its values have.
QString MakeHelp(const vtkRelievoLayer& known)
{
  const QString help = QString::fromStdString(known.Help).remove(QString(", ") + WorldUnits);
  return help.isEmpty() ? help : help.left(1).toUpper() + help.mid(1) + ".";
}

// Empty for a layer with a colour strip.
QString DescribeColors(const vtkRelievoLayer& layer, int components)
{
  switch (layer.Kind)
  {
    case vtkRelievoLayer::ID:
      return "Each has a colour of its own.";
    case vtkRelievoLayer::VECTOR:
      return "Red, green and blue are x, y and z, from -1 to 1.";
    case vtkRelievoLayer::POSITION:
      return "Red, green and blue are x, y and z, each from the least to the greatest seen.";
    case vtkRelievoLayer::COLOR:
      return "";
    default:
      return components > 2
        ? "Red, green and blue are the first three components, each from the least to the greatest "
          "seen."
        : "";
  }
}
}

//------------------------------------------------------------------------------
bool IsOfVolume(const std::string& layer)
{
  return layer.compare(0, 6, "volume") == 0 &&
    vtkRelievoLayerCatalogue::Find(layer).Kind != vtkRelievoLayer::ARRAY;
}

//------------------------------------------------------------------------------
QString NameLayer(const std::string& layer, const LightNames& lights)
{
  const auto named = lights.find(layer);
  return named != lights.end() ? "Shadow of " + QString::fromStdString(named->second)
                               : QString::fromStdString(vtkRelievoLayerCatalogue::GetTitle(layer));
}

//------------------------------------------------------------------------------
QString GroupLayer(const std::string& layer)
{
  const vtkRelievoLayer& known = vtkRelievoLayerCatalogue::Find(layer);
  constexpr int ofFrame = vtkRelievoLayer::FROM_STAGE | vtkRelievoLayer::FROM_PICTURE;
  return IsOfVolume(layer)                          ? "Volumes"
    : vtkRelievoLayerCatalogue::GetIsOfLight(layer) ? "Light and effects"
    : known.Kind == vtkRelievoLayer::ARRAY          ? ""
    : known.Kind == vtkRelievoLayer::ID             ? "Objects"
    : (known.Source & ofFrame) != 0                 ? "Light and effects"
                                                    : "Surfaces";
}

//------------------------------------------------------------------------------
QString GetUnit(const std::string& layer)
{
  return IsLength(layer) ? WorldUnits : "";
}

//------------------------------------------------------------------------------
QString AddUnit(const QString& value, const std::string& layer)
{
  return (value + " " + GetUnit(layer)).trimmed();
}

//------------------------------------------------------------------------------
QString LayerWords::GetText() const
{
  QStringList lines;
  for (const QString& line : { this->Title, this->Words, this->First, this->Last })
  {
    if (!line.isEmpty())
    {
      lines += line;
    }
  }
  return lines.join('\n');
}

//------------------------------------------------------------------------------
LayerWords DescribeLayer(vtkRelievoDisplayStage* stage, bool isDrawnHere, const LightNames& lights)
{
  const std::string layer = stage->GetLayer();
  const bool ofLight = vtkRelievoLayerCatalogue::GetIsOfLight(layer); // by any name
  const vtkRelievoLayer& known =
    ofLight ? vtkRelievoLayerCatalogue::GetOfLight() : vtkRelievoLayerCatalogue::Find(layer);
  LayerWords words;
  words.Title = NameLayer(layer, lights);
  if (isDrawnHere && stage->GetReasonCode() != "ran")
  {
    words.Words = "Nothing to see: " + QString::fromStdString(stage->GetReason()) + ".";
    return words;
  }
  if (isDrawnHere && !std::isfinite(stage->GetShownRange()[0]))
  {
    words.Words = "Nothing to see: no pixel has a value.";
    return words;
  }
  words.Words = MakeHelp(known);
  if (isDrawnHere && stage->GetSame())
  {
    words.Words = ("Nothing to see: all pixels are alike. " + words.Words).trimmed();
    return words;
  }
  const bool given = stage->GetRange()[0] < stage->GetRange()[1];
  const bool named = ofLight && !given && stage->HasScale(); // the strip's ends have values
  const QString colors = DescribeColors(known, stage->GetShownComponents());
  words.Words =
    named ? words.Words.section(':', 0, 0) + "." : (words.Words + " " + colors).trimmed();
  if (!stage->HasScale())
  {
    return words;
  }
  const bool share = known.Kind == vtkRelievoLayer::SHARE;
  const double* range = given ? stage->GetRange() : stage->GetShownRange();
  const auto write = [&](double value, const char* unknown) {
    return isDrawnHere || given ? QString::number(value, 'g', ValueDigits) : QString(unknown);
  };
  words.First = write(range[0], share ? "0" : "the least");
  words.Last = write(range[1], share ? "1" : "the greatest");
  if (isDrawnHere || given)
  {
    words.Last = AddUnit(words.Last, layer);
  }
  if (named)
  {
    words.First = "in shadow";
    words.Last = "lit";
  }
  words.Strip = MakeStrip(stage->GetShownColormap(), stage->GetShownReversed());
  return words;
}
}
