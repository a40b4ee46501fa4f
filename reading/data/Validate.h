// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Validate_h
#define Validate_h

#include "ReadingNames.h"

#include <string>

class vtkDataObject;

namespace reading
{
/// Throws WorkError with the path, the cell and the expected value if a cell refers to a missing
/// point, has the wrong number of points for its type, or is of a type unknown to VTK; if points or
/// coordinates of a structured grid do not fit its extent, an array is too short, or a structured
/// grid has more than 1200 million points or 100 million faces. VTK's readers accept such files,
/// and later filters would read beyond their arrays.
void CheckCells(vtkDataObject* data, const std::string& path);
}

#endif
