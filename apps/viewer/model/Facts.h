// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What panels want to know of the files that are shown, besides the settings.
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
/// Of a file's arrays with one name.
struct ArrayFacts
{
  std::string Name;
  bool OfCells = false;
  std::string Type; ///< of its numbers
  int Components = 0;
  std::array<double, 2> Range = { 1.0, -1.0 }; ///< of several components, of the magnitude
};

struct FileFacts
{
  std::string Path;
  std::string Kind; ///< what its cells are, for people: "triangles"
  long long Points = 0;
  long long Cells = 0;
  int Parts = 0; ///< that are drawn one by one
  int Textures = 0;
  std::array<int, 3> Dimensions = {}; ///< points of an image that is no box, or zeros
  std::array<double, 6> Bounds = {};  ///< in its own units: least and most of x, y, z
  std::vector<ArrayFacts> Arrays;     ///< by name
};

struct Facts
{
  std::vector<FileFacts> Files; ///< in their order
  /// The most that arrays have, by the name in the words of --color-by.
  std::map<std::string, int> Components;
  /// Those of them that are colours and no values unless a component is chosen; "" where the
  /// files' own arrays are.
  std::set<std::string> Valueless;
  std::vector<std::string> Layers;            ///< arrays in the words of layers, which can be read
  std::array<double, 2> Times = { 0.0, 0.0 }; ///< seconds; equal: nothing moves
  std::vector<std::string> Animations;        ///< names, of all models
  std::array<double, 6> Bounds = { -0.5, 0.5, -0.5, 0.5, -0.5, 0.5 };
  std::vector<std::string> Lights; ///< kinds of the files' own: sun, spot, point
  int UpAxis = 1;                  ///< by the first file: 0, 1, 2 for x, y, z
  /// Names of the point arrays of each file, by the option: lamps, fog, markers.
  std::map<std::string, std::vector<std::vector<std::string>>> PointArrays;
};
}

#endif
