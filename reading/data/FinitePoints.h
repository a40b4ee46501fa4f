// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Points that cannot be drawn: infinite ones, NaN, and those that OpenGL's floats cannot hold.
 */
#ifndef FinitePoints_h
#define FinitePoints_h

#include "vtkSmartPointer.h"

#include <string>

class vtkDataObject;
class vtkProp3D;

namespace scene
{
class ReadContext;

/// The polygons without the cells that use points with a coordinate that is not finite; a note says
/// how many. The cell array `vtkOriginalCellIds` then says which cells of the file are left. Throws
/// WorkError if no point is finite. Data that is whole comes back as it is.
vtkSmartPointer<vtkDataObject> LeaveOutInfinite(
  vtkDataObject* surface, const std::string& path, ReadContext& context);

/// Throws WorkError if what the prop draws is too far away or too small for OpenGL's floats.
void CheckReach(vtkProp3D* prop, const std::string& path);
}

#endif
