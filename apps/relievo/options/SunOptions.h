// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SunOptions_h
#define SunOptions_h

#include <array>
#include <string>
#include <vector>

namespace cli
{
struct SunOptions
{
  std::vector<std::string> Files;          ///< the mesh, and what shades it
  std::vector<std::string> AllowedFolders; ///< of pieces, besides the files' own
  std::string File;                        ///< a .vtp
  double Latitude;
  double Longitude;
  std::array<int, 3> Days[2]; ///< first and last
  int DayStep = 1;
  double Step = 20.; ///< minutes
  int Up = -1;       ///< axis; -1: by the file
  bool Points = false;
  int Sky = 0; ///< rays
};

/// The words after "sun", as said.
SunOptions ParseSun(const std::vector<std::string>& words);
}

#endif
