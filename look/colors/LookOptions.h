// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Options for the look of meshes and the background: colours by values or one for all, edges,
 * opacity. All functions throw UsageError.
 */
#ifndef LookOptions_h
#define LookOptions_h

#include "AnnotationOptions.h"
#include "Arguments.h"
#include "LookNames.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace look
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

using Color = std::array<double, 3>; ///< as on displays, 0 to 1

/// Options of colours by values, which also apply to active scalars.
constexpr const char* DefaultColormap = "viridis";

struct LookChoice
{
  std::string ColorByAsGiven;
  std::string ColorBy; ///< name of an array, or point:NAME; empty: the active scalars
  enum Places
  {
    Anywhere, ///< points before cells
    OfPoints,
    OfCells
  };
  Places Place = Anywhere;      ///< where to look for the array
  std::optional<int> Component; ///< none: bytes as colours, else the magnitude
  bool Magnitude = false;       ///< even for bytes that could be colours
  std::optional<std::array<double, 2>> Range;
  bool Symmetric = false; ///< extends the files' range as far below zero as above it
  std::string Colormap = DefaultColormap;
  bool IsReadable = false; ///< whether light changes the colours of values only a little
  bool ScalarBar = false;
  BarChoice Bar;
  PrintChoice Print;
  std::optional<Color> Solid;
  double Opacity = 1.0;
  std::vector<std::array<double, 2>> OpacityCurve; ///< values and opacities of volumes; none: found
  double VolumeStep = 0.5; ///< of rays through volumes, as a share of the points' distance
  double PointSize = 1.0;  ///< pixels; larger ones are spheres
  bool Edges = false;
  bool Grid = false;
  std::optional<std::string> ScaleBar; ///< unit, may be empty; none: no bar
  double ScaleBarLength = 0.0;         ///< world units; 0: a round length
  std::vector<Color> Background;       ///< none: VTK's; two: bottom and top
};

void TakeColorBy(LookChoice& look, const std::string& word);
void TakeRange(LookChoice& look, const std::string& word);
void TakeColormap(LookChoice& look, const std::string& word);
void TakeBar(LookChoice& look, const std::string& word);
void TakeColor(LookChoice& look, const std::string& word);
void TakeOpacityCurve(LookChoice& look, const std::string& word);
void TakeScaleBar(LookChoice& look, const std::string& word);
void TakeBackground(LookChoice& look, const std::string& word);

/// The word of an opacity curve.
std::string WriteOpacityCurve(const std::vector<std::array<double, 2>>& curve);

/// Parses "#rrggbb", "R/G/B" from 0 to 1, or an HTML colour name.
Color ParseColor(const std::string& option, const std::string& word);

void CheckLookOptions(const LookChoice& look, const GivenWords& given);
}

#endif
