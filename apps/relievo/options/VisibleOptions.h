// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef VisibleOptions_h
#define VisibleOptions_h

#include "Options.h"

#include <string>
#include <vector>

namespace cli
{
struct VisibleOptions
{
  std::vector<std::string> Files;          ///< the mesh, and what hides it
  std::vector<std::string> AllowedFolders; ///< of pieces, besides the files' own
  std::string File;                        ///< a .vtp
  std::string Cloud;                       ///< a .vtp; "": none
  std::string Poses;                       ///< "orbit:N", "random:N", or a file
  scene::RenderOptions Render;             ///< the cameras: size, view angle, lens
  int Up = -1;                             ///< axis; -1: by the file
  int Seed = 0;
};

/// The words after "visible", as said.
VisibleOptions ParseVisible(const std::vector<std::string>& words);
}

#endif
