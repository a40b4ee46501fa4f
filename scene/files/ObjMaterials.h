// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Materials of OBJ files: colours, highlights, opacity and textures of their MTL libraries.
 */
#ifndef ObjMaterials_h
#define ObjMaterials_h

#include "vtkActor.h" // for the parts
#include "vtkSmartPointer.h"

#include <optional>
#include <string>
#include <vector>

class vtkDataObject;

namespace scene
{
class Progress;

/// What an OBJ file has of one material.
struct ObjPart
{
  vtkSmartPointer<vtkActor> Actor;
  std::optional<std::string> Material; ///< the name; none: points, lines and faces before any name
};

/// An actor for each material of an OBJ file, whose cells keep the numbers of the file; none if the
/// file names no materials. Given are the actor of the whole and what the file holds, of which that
/// actor may lack cells. What is named and cannot be read is noted, and drawn without.
std::vector<ObjPart> SplitByMaterials(
  vtkActor* actor, vtkDataObject* file, const std::string& path, Progress& progress);
}

#endif
