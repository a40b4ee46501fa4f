// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef CaveOptions_h
#define CaveOptions_h

#include <array>
#include <string>
#include <vector>

namespace cli
{
struct CaveOptions
{
  std::string File; ///< a .vti
  std::array<int, 3> Size = { 128, 64, 128 };
  int Seed = 0;
  double Width = 6.;
  double Scale = 64.;
  double VerticalScale = 2.;
  int Up = 1; ///< axis
  std::array<double, 3> Origin = {};
  std::array<double, 3> Spacing = { 1., 1., 1. };
  int Content = 0; ///< vtkRelievoCaves::ContentType
};

/// The words after "cave", as said.
CaveOptions ParseCave(const std::vector<std::string>& words);
}

#endif
