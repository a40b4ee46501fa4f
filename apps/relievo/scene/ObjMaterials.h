// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Materials of OBJ files: colours, highlights, opacity and textures of their MTL libraries.
 */
#ifndef ObjMaterials_h
#define ObjMaterials_h

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkActor;

namespace cli
{
class Progress;

/// An actor for each material of an OBJ file's mesh, whose cells keep the numbers of the file. The
/// actor alone if the file names no materials. What is named and cannot be read is noted, and drawn
/// without.
std::vector<vtkSmartPointer<vtkActor>> SplitByMaterials(
  vtkActor* actor, const std::string& path, Progress& progress);
}

#endif
