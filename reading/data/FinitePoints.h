// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Handles points that cannot be drawn: infinite ones, NaN, and those beyond OpenGL's floats.
 */
#ifndef FinitePoints_h
#define FinitePoints_h

#include "ReadingNames.h"
#include "vtkSmartPointer.h"

#include <string>

class vtkDataObject;
class vtkProp3D;

namespace reading
{
class ReadContext;

/// The polygons without cells that use points with a coordinate that is not finite; a note gives
/// their number. The cell array `vtkOriginalCellIds` then maps the remaining cells to the file's.
/// Throws WorkError if no point is finite. Data without such points is returned unchanged.
vtkSmartPointer<vtkDataObject> LeaveOutInfinite(
  vtkDataObject* surface, const std::string& path, ReadContext& context);

/// Throws WorkError if the prop's geometry is too far away or too small for OpenGL's floats.
void CheckReach(vtkProp3D* prop, const std::string& path);
}

#endif
