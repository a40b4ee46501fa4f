// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Materials of OBJ files (colours, highlights, opacity and textures of their MTL libraries) and
 * textures of PLY files.
 */
#ifndef ObjMaterials_h
#define ObjMaterials_h

#include "ReadingNames.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkActor;
class vtkDataObject;

namespace reading
{
class ReadContext;

/// Makes an actor for each material of an OBJ surface: cells without a material first, then
/// materials in order of first use. The cell array `vtkOriginalCellIds` has the cells' numbers in
/// the surface or in the file. Returns none if the file is no OBJ file, or if no library has a
/// material. Unreadable files, and files outside the allowed folders, are noted and ignored.
std::vector<vtkSmartPointer<vtkActor>> SplitByMaterials(
  vtkDataObject* surface, const std::string& path, ReadContext& context);

/// Makes an actor for the surface of a PLY file whose comment `TextureFile` names a texture, which
/// replaces colours; none for any other surface. Unreadable files, and files outside the allowed
/// folders, are noted and ignored.
std::vector<vtkSmartPointer<vtkActor>> DrawTextured(
  vtkDataObject* surface, const std::string& path, ReadContext& context);
}

#endif
