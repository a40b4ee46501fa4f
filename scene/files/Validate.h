// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Validate_h
#define Validate_h

#include <string>

class vtkDataObject;

namespace scene
{
/// Throws WorkError with the path if a cell of the data names a point that is not there. VTK's
/// readers let such files pass; what works on them afterwards reads beyond its arrays.
void CheckCells(vtkDataObject* data, const std::string& path);
}

#endif
