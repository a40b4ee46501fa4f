// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * glTF files: whole scenes, read by VTK's importer, and what it leaves out of them.
 */
#ifndef Gltf_h
#define Gltf_h

#include <map>
#include <string>
#include <vector>

class vtkActor;
class vtkRenderWindow;

namespace scene
{
class Progress;

/// Adds the actors and lights of the file to the window's renderer. Throws WorkError with the path,
/// and with the name of a buffer or an image that the file names and that is not there.
void ImportGLTF(const std::string& path, vtkRenderWindow* window, Progress& progress);

/// The opacities that materials give to the actors, which are in the order in which they were
/// added: that of the base colour where it is to be blended, 0 where a mask cuts all of it away,
/// else 1. VTK takes none before 9.5, and later also those that do not count. Empty if the file is
/// not understood that far. Notes what VTK does not draw of the materials.
std::map<vtkActor*, double> ReadOpacities(
  const std::string& path, const std::vector<vtkActor*>& actors);
}

#endif
