// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Materials of OBJ files: colours, highlights, opacity and textures of their MTL libraries; and the
 * textures of PLY files.
 */
#ifndef ObjMaterials_h
#define ObjMaterials_h

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkActor;
class vtkDataObject;

namespace scene
{
class ReadContext;

/// An actor for each material of the surface of an OBJ file, those without one first, then by the
/// first use of the name; the cell array `vtkOriginalCellIds` has the numbers that cells have in
/// the surface, or had in the file. None if the file is no OBJ file, or no library has a material.
/// What is named and cannot be read, or lies where it is not allowed, is noted, and drawn without.
std::vector<vtkSmartPointer<vtkActor>> SplitByMaterials(
  vtkDataObject* surface, const std::string& path, ReadContext& context);

/// An actor for the surface of a PLY file with the texture that its comment `TextureFile` names, in
/// place of colours; none for any other surface. What cannot be read, or lies where it is not
/// allowed, is noted, and drawn without.
std::vector<vtkSmartPointer<vtkActor>> DrawTextured(
  vtkDataObject* surface, const std::string& path, ReadContext& context);
}

#endif
