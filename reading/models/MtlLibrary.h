// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Material libraries of OBJ files (Wavefront's MTL): the part that VTK's lighting can show.
 */
#ifndef MtlLibrary_h
#define MtlLibrary_h

#include "ReadingNames.h"

#include <array>
#include <filesystem>
#include <map>
#include <string>

class vtkRelievoAllowedFolders;

namespace reading
{
class ReadContext;

struct MtlMaterial
{
  double Diffuse[3] = { 0.8, 0.8, 0.8 };
  double Specular[3] = { 0.0, 0.0, 0.0 };
  double Exponent = 1.0;
  double Opacity = 1.0;
  bool Dissolves = false; ///< opacity is given by d, not only by Tr
  bool Highlights = true;
  std::string Texture; ///< path; empty: none
  /// Texture coordinates are multiplied by the scale, then the offset is added.
  std::array<double, 2> TextureScale = { 1.0, 1.0 };
  std::array<double, 2> TextureOffset = { 0.0, 0.0 };
  std::string TextureWithout; ///< ignored options that would change the texture
};

/// The path of a file that another one in the folder names, in quotes or not, with slashes of
/// either kind. Files name others by paths of the machine that wrote them: if no allowed file is at
/// that path, a file of the same name in the folder is used.
std::string FindNamedFile(
  std::string name, const std::filesystem::path& folder, const vtkRelievoAllowedFolders& allowed);

/// Adds the materials of a library, by name; later ones replace earlier ones. Unreadable parts of a
/// line keep their defaults. Returns the reason if the library is not allowed or cannot be opened,
/// and otherwise "".
std::string ReadMtlLibrary(const std::string& path, const vtkRelievoAllowedFolders& allowed,
  std::map<std::string, MtlMaterial>& materials, ReadContext& context);
}

#endif
