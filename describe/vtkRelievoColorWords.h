// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Colours in words, for all interfaces: the names of vtkNamedColors (CSS's and VTK's own), such as
 * `tomato`, and `#rrggbb`.
 */
#ifndef vtkRelievoColorWords_h
#define vtkRelievoColorWords_h

#include "vtkRelievoDescribeModule.h" // for the export macro

#include <string>

namespace relievo
{
/// Red, green and blue from 0 to 1; returns false, and sets nothing, for any other word.
VTKRELIEVODESCRIBE_EXPORT bool ReadColor(const std::string& word, double color[3]);
}

#endif
