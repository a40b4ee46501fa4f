// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/** Reads a file into a model: glTF by our own reader, other formats through Assimp. */
#ifndef vtkRelievoModelFile_h
#define vtkRelievoModelFile_h

#include "vtkRelievoModel.h"
#include "vtkRelievoModelSources.h"

#include <functional>
#include <string>
#include <vector>

namespace relievo
{
/// Fills the model and returns "", or returns the problem and leaves the model empty. `folders`:
/// folders, besides the file's own, of files that the model may name. `weights`: most bones per
/// point. `progress` gets 0 to 1 and returns whether to go on. `sources` gets the files looked for,
/// in their state before they were read.
std::string ReadModel(const std::string& path, const std::vector<std::string>& folders, int weights,
  const std::function<bool(double)>& progress, ModelSources& sources, Model& model);

/// Whether the extension is one of glTF or of Assimp.
bool GetIsModelExtension(const std::string& path);
}

#endif
