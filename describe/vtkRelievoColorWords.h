// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Colours in words, which every interface takes: the names of vtkNamedColors (CSS's and VTK's
 * own), such as `tomato`, and `#rrggbb`.
 */
#ifndef vtkRelievoColorWords_h
#define vtkRelievoColorWords_h

#include "vtkRelievoDescribeModule.h" // for the export macro

#include <string>

namespace relievo
{
/// Red, green and blue from 0 to 1; false, and nothing set, for what is neither.
VTKRELIEVODESCRIBE_EXPORT bool ReadColor(const std::string& word, double color[3]);
}

#endif
