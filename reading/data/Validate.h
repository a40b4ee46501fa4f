// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Validate_h
#define Validate_h

#include <string>

class vtkDataObject;

namespace scene
{
/// Throws WorkError with the path, the cell and what was expected if a cell of the data names a
/// point that is not there, has another number of points than its type, or is of a type that VTK
/// has no cells of; if points or coordinates of a structured grid do not fit its extent, an array
/// is too short, or a structured grid has more than 1200 million points or 100 million faces. VTK's
/// readers let such files pass; what works on them afterwards reads beyond its arrays.
void CheckCells(vtkDataObject* data, const std::string& path);
}

#endif
