// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Properties of the displayed files that panels need besides the settings.
 */
#ifndef Facts_h
#define Facts_h

#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace viewer
{
/// The arrays of one name in a file.
struct ArrayFacts
{
  std::string Name;
  bool OfCells = false;
  std::string Type; ///< type of the numbers
  int Components = 0;
  std::array<double, 2> Range = { 1.0, -1.0 }; ///< for several components, of the magnitude
};

struct FileFacts
{
  std::string Path;
  std::string Kind; ///< kind of the cells, for display: "triangles"
  long long Points = 0;
  long long Cells = 0;
  int Parts = 0; ///< number of separately drawn parts
  int Textures = 0;
  std::array<int, 3> Dimensions = {}; ///< dimensions of an image not shown as a box, or zeros
  std::array<double, 6> Bounds = {};  ///< in the file's units: x, y, z ranges
  std::vector<ArrayFacts> Arrays;     ///< by name
};

struct Facts
{
  std::vector<FileFacts> Files; ///< in order
  /// The largest number of components of arrays of a name, by the name in words of --color-by.
  std::map<std::string, int> Components;
  /// Arrays shown as colours unless a component is chosen; "" stands for the files' own arrays.
  std::set<std::string> Valueless;
  std::vector<std::string> Layers;            ///< arrays that can be read as layers
  std::array<double, 2> Times = { 0.0, 0.0 }; ///< seconds; equal: no animation
  std::vector<std::string> Animations;        ///< names in all models
  std::array<double, 6> Bounds = { -0.5, 0.5, -0.5, 0.5, -0.5, 0.5 };
  std::vector<std::string> Lights; ///< kinds of the files' own lights: sun, spot, point
  int UpAxis = 1;                  ///< of the first file: 0, 1, 2 for x, y, z
  /// Names of the point arrays of each file, by option: lamps, fog, markers.
  std::map<std::string, std::vector<std::vector<std::string>>> PointArrays;
};
}

#endif
