// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * From data to an actor as a user expects to see it. Polygons are drawn as they are; grids, images
 * and volumes by their outer surface; composite data block by block.
 */
#ifndef Actors_h
#define Actors_h

#include "vtkSmartPointer.h"

#include <set>
#include <string>

class vtkActor;
class vtkDataObject;

namespace scene
{
class ReadContext;

/// An actor for the data of the file `path`, in phong shading. `smooth`: meshes that bring no point
/// normals get them, split at edges sharper than 30 degrees; cells keep their order. Throws
/// WorkError with the path for data that has no geometry, such as tables.
vtkSmartPointer<vtkActor> MakeActor(
  vtkDataObject* data, bool smooth, const std::string& path, ReadContext& context);

/// What MakeActor draws of the data: polygons, finite, with normals if `smooth`, and cut where VTK
/// would draw too much of them.
vtkSmartPointer<vtkDataObject> MakeSurface(
  vtkDataObject* data, bool smooth, const std::string& path, ReadContext& context);

/// An actor for what MakeSurface made.
vtkSmartPointer<vtkActor> DrawSurface(vtkDataObject* surface);

/// Names of the numeric point and cell arrays of what is drawn.
struct ArrayNames
{
  std::set<std::string> Names;
  std::set<std::string> Placed; ///< the same as point:NAME and cell:NAME
};

/// Adds those of what the actor's mapper draws from.
void AddArrayNames(vtkActor* actor, ArrayNames& arrays);
}

#endif
