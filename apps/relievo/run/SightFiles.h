// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Input and output files of commands that trace rays at a mesh: the first file is the mesh, the
 * others hide it.
 */
#ifndef SightFiles_h
#define SightFiles_h

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkPolyData;
class vtkRelievoSightAlgorithm;

namespace reading
{
class Outputs;
class Progress;
}

namespace cli
{
/// Passes the surfaces of the files to the filter; `folders`: allowed folders of referenced files,
/// besides the files' own. `rays`: the file of the meshes' trees, which is written if it does not
/// exist and stays whatever follows, or "". Returns the up axis of the first file.
int ReadMeshes(const std::vector<std::string>& files, const std::vector<std::string>& folders,
  const std::string& rays, vtkRelievoSightAlgorithm* filter, reading::Progress& progress);

/// Reads the surface of a file.
vtkSmartPointer<vtkPolyData> ReadMesh(
  const std::string& file, const std::vector<std::string>& folders, reading::Progress& progress);

/// Whether the output is a raster. Throws UsageError if the filter's mesh then has none.
bool CheckRaster(vtkRelievoSightAlgorithm* filter, const std::string& output);

/// Writes a text or bytes to its output's path.
void WriteText(const std::string& text, const std::string& option, const std::string& path,
  const reading::Outputs& outputs);

/// Writes the mesh to its output's path; to .tif the arrays at a terrain's points, on its grid.
void WriteMesh(vtkPolyData* mesh, const std::string& option, const std::string& path,
  const reading::Outputs& outputs, reading::Progress& progress);
}

#endif
