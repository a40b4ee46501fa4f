// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Turns data into an actor. Polygons are drawn unchanged; grids, images and volumes by their outer
 * surface; composite data block by block.
 */
#ifndef Actors_h
#define Actors_h

#include "ReadingNames.h"
#include "vtkSmartPointer.h"

#include <set>
#include <string>

class vtkActor;
class vtkDataObject;

namespace reading
{
class ReadContext;

/// Makes an actor for the data of the file `path`, with Phong shading. `smooth`: meshes without
/// point normals get them, split at edges sharper than 30 degrees; the order of cells stays. Throws
/// WorkError naming the path for data without geometry, such as tables.
vtkSmartPointer<vtkActor> MakeActor(
  vtkDataObject* data, bool smooth, const std::string& path, ReadContext& context);

/// The surface that MakeActor draws: finite polygons, with normals if `smooth`, cut where VTK would
/// draw too much of them.
vtkSmartPointer<vtkDataObject> MakeSurface(
  vtkDataObject* data, bool smooth, const std::string& path, ReadContext& context);

/// An actor for a surface of MakeSurface.
vtkSmartPointer<vtkActor> DrawSurface(vtkDataObject* surface);

/// Names of the numeric point and cell arrays of drawn data.
struct ArrayNames
{
  std::set<std::string> Names;
  std::set<std::string> Placed; ///< Arrays as point:NAME and cell:NAME
};

/// Adds the names of the arrays of the actor's mapper.
void AddArrayNames(vtkActor* actor, ArrayNames& arrays);
}

#endif
