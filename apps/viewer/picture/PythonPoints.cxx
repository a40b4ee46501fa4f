// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PythonPoints.h"

#include "Options.h"
#include "PythonWords.h"
#include "Settings.h"

#include <array>
#include <string>

namespace viewer
{
namespace
{
void BeginCall(std::ostream& out, const char* function, const std::string& file)
{
  out << "relievo." << function << "(renderer, data(" << GetReader(file) << "(), " << Quote(file)
      << ")";
}

void WriteValue(std::ostream& out, const char* name, const cli::PointValue& value)
{
  if (value.Number)
  {
    out << ", " << name << "=" << WriteNumber(*value.Number);
  }
  else if (!value.Array.empty())
  {
    out << ", " << name << "=" << Quote(value.Array);
  }
}

void WriteColor(std::ostream& out, const cli::ColorValue& color)
{
  if (color.Color)
  {
    out << ", color=(" << WriteThree(color.Color->data()) << ")";
  }
  else if (!color.Array.empty())
  {
    out << ", color=" << Quote(color.Array);
  }
}

void WriteLamps(std::ostream& out, const cli::LampChoice& lamps)
{
  BeginCall(out, "lamps", lamps.File);
  WriteValue(out, "radius", lamps.Radius);
  WriteValue(out, "intensity", lamps.Intensity);
  WriteColor(out, lamps.Color);
  if (lamps.Kind != cli::Falloff::Linear)
  {
    out << ", falloff=\"" << (lamps.Kind == cli::Falloff::VTK ? "vtk" : "inverse-square") << "\"";
  }
  if (lamps.Attenuation)
  {
    out << ", attenuation=(" << WriteThree(lamps.Attenuation->data()) << ")";
  }
  if (lamps.Casts.Number)
  {
    out << ", casts=" << (*lamps.Casts.Number == 0. ? "False" : "True");
  }
  else
  {
    WriteValue(out, "casts", lamps.Casts);
  }
  out << ")\n";
}

void WriteMarkers(std::ostream& out, const cli::MarkerChoice& markers, int upAxis)
{
  static const char* const shapes[] = { "ring", "glow", "disc", "shadow" };
  BeginCall(out, "markers", markers.File);
  out << ", shape=\"" << shapes[markers.Shape] << "\"";
  WriteValue(out, "radius", markers.Radius);
  WriteValue(out, "width", markers.Width);
  WriteValue(out, "reach", markers.Reach);
  WriteValue(out, "opacity", markers.Opacity);
  WriteColor(out, markers.Color);
  std::array<double, 3> up{ 0., 0., 0. };
  up[static_cast<std::size_t>(upAxis)] = 1.;
  up = markers.Up.value_or(up);
  out << ", up=(" << WriteThree(up.data()) << "))\n";
}
}

//------------------------------------------------------------------------------
void WritePoints(std::ostream& out, const cli::RenderOptions& options)
{
  for (const cli::LampChoice& lamps : options.Lamps)
  {
    WriteLamps(out, lamps);
  }
  for (const cli::FogChoice& fog : options.Fogs)
  {
    BeginCall(out, "fog", fog.File);
    WriteValue(out, "radius", fog.Radius);
    WriteValue(out, "density", fog.Density);
    WriteColor(out, fog.Color);
    out << ")\n";
  }
  for (const cli::MarkerChoice& markers : options.Markers)
  {
    WriteMarkers(out, markers, options.UpAxis);
  }
}
}
