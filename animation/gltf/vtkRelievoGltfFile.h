// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/** Reads a glTF 2 file, .gltf or .glb, into a model (Khronos, glTF 2.0 specification, 2021). */
#ifndef vtkRelievoGltfFile_h
#define vtkRelievoGltfFile_h

#include "vtkRelievoModel.h"
#include "vtkRelievoModelSources.h"

#include <functional>
#include <string>

class vtkRelievoAllowedFolders;

namespace relievo
{
/// Whether the extension is one of glTF's.
bool GetIsGltfExtension(const std::string& path);

/// Fills the model. Throws the problem and its place in the file. The arguments are those of
/// ReadModel.
void ReadGltf(const std::string& path, const vtkRelievoAllowedFolders& allowed, int weights,
  const std::function<bool(double)>& progress, ModelSources& sources, Model& model);
}

#endif
