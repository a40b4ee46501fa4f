// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * How meshes and the background look: colours by values or one for all, edges, opacity. All
 * functions throw UsageError.
 */
#ifndef LookOptions_h
#define LookOptions_h

#include <array>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace scene
{

/// FromFile: phong, except that a glTF file keeps the shading of its own materials.
enum class Shading
{
  FromFile,
  Flat,
  Gouraud,
  Phong,
  PBR
};

using Color = std::array<double, 3>; ///< as displays show it, 0 to 1

/// The colour map of active scalars, too.
constexpr const char* DefaultColormap = "viridis";

struct LookChoice
{
  std::string ColorByAsGiven;
  std::string ColorBy; ///< name of an array, or point:NAME; empty: the active scalars
  enum Places
  {
    Anywhere, ///< of points before cells
    OfPoints,
    OfCells
  };
  Places Place = Anywhere;      ///< of arrays of that name
  std::optional<int> Component; ///< of it; none: colours as they are, else the magnitude
  bool Magnitude = false;       ///< of arrays that could be colours
  std::optional<std::array<double, 2>> Range;
  bool Symmetric = false; ///< the range of the files, as far below zero as above it
  std::string Colormap = DefaultColormap;
  bool ScalarBar = false;
  std::optional<Color> Solid;
  double Opacity = 1.0;
  double PointSize = 1.0; ///< pixels; larger ones are spheres
  bool Edges = false;
  bool Grid = false;
  std::optional<std::string> ScaleBar; ///< its unit, which may be empty; none: no bar
  double ScaleBarLength = 0.0;         ///< world units; 0: a round one
  std::vector<Color> Background;       ///< none: VTK's; two: bottom and top
};

void TakeColorBy(LookChoice& look, const std::string& word);
void TakeRange(LookChoice& look, const std::string& word);
void TakeColormap(LookChoice& look, const std::string& word);
void TakeColor(LookChoice& look, const std::string& word);
void TakeOpacity(LookChoice& look, const std::string& word);
void TakePointSize(LookChoice& look, const std::string& word);
void TakeScaleBar(LookChoice& look, const std::string& word);
void TakeBackground(LookChoice& look, const std::string& word);

/// "#rrggbb", "R/G/B" from 0 to 1, or a name of HTML's.
Color ParseColor(const std::string& option, const std::string& word);

void CheckLookOptions(const LookChoice& look, const std::set<std::string>& given);
}

#endif
