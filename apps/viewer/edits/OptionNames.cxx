// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OptionNames.h"

#include "Options.h"

#include <QRegularExpression>

#include <algorithm>
#include <iterator>

namespace viewer
{
namespace
{
struct Row
{
  const char* Option;
  const char* Label;
  const char* Panel;
};

constexpr Row Rows[] = {
  { "--image", "Images", "Scene" },
  { "--preset", "Preset", "Scene" },
  { "--ground", "Ground", "Scene" },
  { "--grid", "Grid", "Scene" },
  { "--scale-bar", "Scale bar", "Scene" },
  { "--up", "Up", "Scene" },
  { "--view-angle", "View angle", "Scene" },
  { "--animation", "Animation", "Scene" },
  { "--skin", "Skinning", "Scene" },
  { "--loop", "Start anew after the end", "Scene" },
  { "--skeleton", "Show the bones", "Scene" },
  { "--light", "Lights", "Light" },
  { "--fill", "Fill", "Light" },
  { "--environment", "Environment", "Light" },
  { "--reflectivity", "Reflectivity", "Light" },
  { "--skybox", "Show as sky", "Light" },
  { "--shadows", "Shadows", "Light" },
  { "--shadow-size", "Map size", "Light" },
  { "--soft-shadows", "Samples", "Light" },
  { "--colored-shadows", "Coloured shadows", "Light" },
  { "--shadow-tolerance", "Tolerance", "Light" },
  { "--time-budget", "Time budget", "Light" },
  { "--lamps", "Lamps", "Light" },
  { "--shading", "Shading", "Look" },
  { "--opacity", "Opacity", "Look" },
  { "--opacity-curve", "Opacity curve", "Look" },
  { "--volume-step", "Step", "Look" },
  { "--volume-shadows", "Volume shadows", "Look" },
  { "--point-size", "Point size", "Look" },
  { "--edges", "Show edges", "Look" },
  { "--color-by", "Colour by", "Look" },
  { "--range", "Range", "Look" },
  { "--colormap", "Colour map", "Look" },
  { "--scalar-bar", "Show a colour bar", "Look" },
  { "--bar", "Side of the bar", "Look" },
  { "--color", "One colour", "Look" },
  { "--normal-map", "Normal map", "Look" },
  { "--height-map", "Height map", "Look" },
  { "--relief", "Relief method", "Look" },
  { "--texture-coordinates", "Texture coordinates", "Look" },
  { "--material", "Material", "Look" },
  { "--background", "Background", "Look" },
  { "--tone", "Tone", "Look" },
  { "--exposure", "Exposure", "Look" },
  { "--fog", "Fog", "Look" },
  { "--markers", "Markers", "Look" },
  { "--deferred", "Deferred shading", "Look" },
};

const Row* FindRow(const QString& option)
{
  const auto* found = std::find_if(
    std::begin(Rows), std::end(Rows), [&option](const Row& row) { return option == row.Option; });
  return found == std::end(Rows) ? nullptr : found;
}
}

//------------------------------------------------------------------------------
OptionName FindOptionName(const QString& option)
{
  const Row* row = FindRow(option);
  return row ? OptionName{ row->Label, row->Panel } : OptionName();
}

//------------------------------------------------------------------------------
QString NameOptions(const QString& text)
{
  // Omits placeholders of values, which are in capitals.
  static const QRegularExpression spelled(
    "(?<![\\w/.-])(--[a-z][a-z-]*[a-z])(?![\\w.-])(?: ([A-Z]+)\\b| ([a-z]+)\\b)?");
  QString named;
  int end = 0;
  for (auto matches = spelled.globalMatch(text); matches.hasNext();)
  {
    const QRegularExpressionMatch match = matches.next();
    const Row* row = FindRow(match.captured(1));
    if (!row)
    {
      continue;
    }
    const QString value = match.captured(3);
    const std::vector<std::string>& words = scene::GetRenderCommand().Find(row->Option)->Words;
    const bool known = std::find(words.begin(), words.end(), value.toStdString()) != words.end();
    named += text.mid(end, static_cast<int>(match.capturedStart()) - end) + QChar(0x201c) +
      row->Label + (known ? ": " + value : QString()) + QChar(0x201d) + " in " + row->Panel;
    const bool whole = known || !match.captured(2).isEmpty();
    end = static_cast<int>(whole ? match.capturedEnd() : match.capturedEnd(1));
  }
  return named + text.mid(end);
}
}
