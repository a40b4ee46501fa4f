// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ChartMethods.h"

#include <algorithm>

namespace relievoBench
{
//------------------------------------------------------------------------------
const std::vector<ChartMethod>& ChartMethods()
{
  using C = ChartColor;
  using M = ChartMarker;
  using D = ChartDash;
  static const std::vector<ChartMethod> methods = {
    // Normals
    { "octahedral", "octahedral", C::Blue, M::Circle, D::Solid },
    { "octahedral precise", "octahedral precise", C::Green, M::Diamond, D::Dashed },
    { "0.5n+0.5", "0.5n + 0.5", C::Vermillion, M::Square, D::DashDotted },
    { "half", "half xyz", C::Purple, M::Up, D::Solid },
    { "float", "float xyz", C::Black, M::Plus, D::Solid },
    { "spherical angles", "spherical angles", C::Grey, M::Cross, D::Dashed },
    { "azimuthal", "azimuthal", C::Grey, M::Down, D::Dotted },
    // Depth, and positions from it
    { "R32F, linear", "R32F, linear", C::Blue, M::Circle, D::Solid },
    { "R32F and id, refined", "R32F and id, refined", C::Black, M::Plus, D::Solid },
    { "reversed z, 32F", "reversed z, 32F", C::Vermillion, M::Square, D::Dashed },
    { "window z, 24 bits", "window z, 24 bits", C::Orange, M::Up, D::Solid },
    { "R16F, scaled by 2^k", "R16F, scaled by 2^k", C::Green, M::Diamond, D::DashDotted },
    { "R16F, world units", "R16F, world units", C::Grey, M::Diamond, D::Dotted },
    { "window z, 32F", "window z, 32F", C::Grey, M::Cross, D::Dashed },
    { "RGBA8 alpha, linear", "RGBA8 alpha, linear", C::Purple, M::Down, D::Dashed },
    { "world RGBA16F", "world RGBA16F", C::Grey, M::Down, D::Dotted },
    { "world RGBA32F", "world RGBA32F", C::Grey, M::Circle, D::Dashed },
    { "eye space RGBA32F", "eye space RGBA32F", C::Grey, M::Up, D::Dashed },
    // Frames with layers
    { "plain", "plain", C::Black, M::Plus, D::Solid },
    { "attached, nothing asked", "attached, idle", C::Sky, M::Circle, D::Solid },
    { "depth", "depth", C::Blue, M::Circle, D::Solid },
    { "normal + depth", "normal, depth", C::Green, M::Diamond, D::Solid },
    { "normal + depth + albedo + ids", "… and albedo, ids", C::Vermillion, M::Square, D::Solid },
    { "the same + geometric normal", "… and facet normal", C::Purple, M::Up, D::Solid },
    { "vtkSSAOPass, kernel 1", "vtkSSAOPass", C::Grey, M::Cross, D::Dashed },
    // Shadows
    { "map", "map", C::Blue, M::Circle, D::Solid },
    { "forward", "forward", C::Vermillion, M::Square, D::DashDotted },
    { "warped", "warped", C::Green, M::Diamond, D::Dashed },
    { "exact", "exact", C::Orange, M::Down, D::Solid },
    { "constant, computed", "constant bias", C::Purple, M::Up, D::Dotted },
    { "vtkShadowMapPass", "VTK", C::Grey, M::Cross, D::Dashed },
    // Lamps
    { "quads", "quads", C::Blue, M::Circle, D::Solid },
    { "clusters", "clusters", C::Vermillion, M::Square, D::DashDotted },
    { "every lamp", "every lamp", C::Purple, M::Up, D::Solid },
    { "VTK's lights", "VTK's lights", C::Grey, M::Cross, D::Dashed },
    { "deferred", "deferred", C::Green, M::Diamond, D::Solid },
    { "VTK's shading", "VTK", C::Grey, M::Cross, D::Dashed },
    // Relief
    { "relief", "relief", C::Blue, M::Circle, D::Solid },
    { "occlusion", "occlusion", C::Green, M::Diamond, D::Dashed },
    { "steep", "steep", C::Vermillion, M::Square, D::DashDotted },
    { "parallax", "parallax", C::Purple, M::Up, D::Solid },
    // Environments
    { "cube", "cube", C::Blue, M::Circle, D::Solid },
    { "tan-warped cube", "tan-warped cube", C::Vermillion, M::Square, D::DashDotted },
    { "octahedral map", "octahedral", C::Green, M::Diamond, D::Dashed },
    { "sphere map", "sphere map", C::Purple, M::Up, D::Solid },
    { "lat-long", "lat-long", C::Orange, M::Down, D::Dotted },
    // Tone
    { "clamp", "clamp", C::Black, M::Plus, D::Dashed },
    { "simple", "simple", C::Vermillion, M::Square, D::DashDotted },
    { "reinhard", "reinhard", C::Blue, M::Circle, D::Solid },
    { "reinhard_rgb", "reinhard_rgb", C::Purple, M::Up, D::Dotted },
    { "none", "no dithering", C::Vermillion, M::Square, D::DashDotted },
    { "ordered", "ordered", C::Green, M::Diamond, D::Dashed },
    { "blue_noise", "blue noise", C::Blue, M::Circle, D::Solid },
    // Surfaces of blocks
    { "smooth blocks", "smooth blocks", C::Blue, M::Circle, D::Solid },
    { "smooth blocks, 0.25", "smooth, 0.25", C::Sky, M::Circle, D::Dashed },
    { "cubes", "cubes", C::Black, M::Square, D::Dotted },
    { "flying edges", "flying edges", C::Grey, M::Cross, D::Dashed },
    { "flying edges, sinc", "… and sinc", C::Vermillion, M::Up, D::DashDotted },
    { "surface nets", "surface nets", C::Green, M::Diamond, D::Dashed },
    // Caves
    { "skipping", "skipping", C::Blue, M::Circle, D::Solid },
    { "classic", "second if the first passes", C::Grey, M::Cross, D::Dashed },
    { "naive", "both noises", C::Black, M::Square, D::Dotted },
    { "level lines", "level", C::Blue, M::Circle, D::Solid },
    { "upright lines", "upright", C::Sky, M::Up, D::Dashed },
    // Cells inside bodies
    { "parity", "parity", C::Blue, M::Circle, D::Solid },
    { "two views", "two views", C::Vermillion, M::Square, D::DashDotted },
    { "six views", "six views", C::Green, M::Diamond, D::Dashed },
    { "six views, drawn", "… drawn", C::Purple, M::Up, D::Dotted },
    { "vtkPolyDataToImageStencil", "image stencil", C::Grey, M::Cross, D::Dashed },
    { "vtkSelectEnclosedPoints", "enclosed points", C::Grey, M::Cross, D::Dashed },
    { "vtkVoxelModeller", "voxel modeller", C::Grey, M::Down, D::Dotted },
    // Particles on surfaces
    { "depth maps", "depth maps", C::Blue, M::Circle, D::Solid },
    { "closest point", "closest point", C::Grey, M::Cross, D::Dashed },
    { "not held", "not held", C::Black, M::Square, D::Dotted },
    // Bones
    { "slerp", "slerp", C::Blue, M::Circle, D::Solid },
    { "nlerp", "nlerp", C::Green, M::Diamond, D::Dashed },
    { "key-matrix", "key-matrix", C::Vermillion, M::Square, D::DashDotted },
    { "linear", "linear", C::Blue, M::Circle, D::Solid },
    { "dual quaternion", "dual quaternion", C::Green, M::Diamond, D::Dashed },
    { "rigid, GPU", "rigid, GPU", C::Grey, M::Up, D::Dotted },
    { "linear, GPU", "linear, GPU", C::Orange, M::Square, D::Solid },
    { "dual quaternion, GPU", "dual quaternion, GPU", C::Vermillion, M::Square, D::Dashed },
    { "VTK's glTF reader", "VTK's glTF reader", C::Grey, M::Cross, D::Dashed },
    // Fog
    { "pairs of floats", "pairs of floats", C::Blue, M::Circle, D::Solid },
    { "textbook, double", "textbook, double", C::Grey, M::Cross, D::Dashed },
    { "textbook, float", "textbook, float", C::Grey, M::Up, D::Dotted },
    { "perpendicular, float", "perpendicular, float", C::Grey, M::Down, D::Dashed },
  };
  return methods;
}

//------------------------------------------------------------------------------
const ChartMethod* FindChartMethod(const std::string& name)
{
  const std::vector<ChartMethod>& all = ChartMethods();
  const auto at = std::find_if(
    all.begin(), all.end(), [&name](const ChartMethod& method) { return method.Name == name; });
  return at == all.end() ? nullptr : &*at;
}

//------------------------------------------------------------------------------
const char* HexOf(ChartColor color)
{
  static const char* const hex[] = { "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00",
    "#56b4e9", "#000000", "#8c8c8c" };
  return hex[static_cast<int>(color)];
}

//------------------------------------------------------------------------------
const char* DarkHexOf(ChartColor color)
{
  static const char* const hex[] = { "#005a8c", "#a84a00", "#007756", "#9c4a76", "#8a5f00",
    "#1f6f9c", "#000000", "#666666" };
  return hex[static_cast<int>(color)];
}
}
