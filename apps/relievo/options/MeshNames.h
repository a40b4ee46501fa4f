// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Names of files of commands that work on meshes.
 */
#ifndef MeshNames_h
#define MeshNames_h

#include <string>
#include <vector>

namespace cli
{
/// UsageError unless there are files to read that are data, and a .vtp to write.
void CheckMeshFiles(
  const std::string& command, const std::vector<std::string>& files, const std::string& output);

/// UsageError unless the name ends in .vtp.
void CheckMeshName(const std::string& option, const std::string& name);
}

#endif
