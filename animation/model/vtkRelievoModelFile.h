// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * From a file to a model: glTF by our own reader, all else through Assimp.
 */
#ifndef vtkRelievoModelFile_h
#define vtkRelievoModelFile_h

#include "vtkRelievoModel.h"
#include "vtkRelievoModelSources.h"

#include <functional>
#include <string>
#include <vector>

namespace relievo
{
/// Fills the model and returns "", or returns what is wrong and leaves the model empty. `folders`:
/// those of files that the model may name, besides its own. `weights`: most bones of a point.
/// `progress` gets 0 to 1 and returns whether to go on. `sources` gets the files that were looked
/// for, as they were before they were read.
std::string ReadModel(const std::string& path, const std::vector<std::string>& folders, int weights,
  const std::function<bool(double)>& progress, ModelSources& sources, Model& model);

/// Whether the extension is glTF's or one that Assimp reads.
bool GetIsModelExtension(const std::string& path);
}

#endif
