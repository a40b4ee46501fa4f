// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The files of commands that ask rays what lies before a mesh: the first is the mesh, the others
 * hide it.
 */
#ifndef SightFiles_h
#define SightFiles_h

#include <string>
#include <vector>

class vtkPolyData;
class vtkRelievoSightAlgorithm;

namespace scene
{
class Outputs;
class Progress;
}

namespace cli
{
/// Gives the filter the surfaces of the files; `folders` are those that files may name others in,
/// besides their own. Returns the up axis of the first.
int ReadMeshes(const std::vector<std::string>& files, const std::vector<std::string>& folders,
  vtkRelievoSightAlgorithm* filter, scene::Progress& progress);

/// Writes what is to be at the path of the outputs.
void WriteMesh(vtkPolyData* mesh, const std::string& option, const std::string& path,
  const scene::Outputs& outputs, scene::Progress& progress);
}

#endif
