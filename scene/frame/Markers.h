// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Markers_h
#define Markers_h

#include "MarkerOptions.h"

#include "vtkSmartPointer.h"

#include <vector>

class vtkRelievoMarkers;

namespace scene
{
class Progress;

/// The points of each file as markers; shadows fall along the axis if nothing else was said. Throws
/// WorkError with the file's name: what cannot be read, arrays that do not fit, files without a
/// point that is a marker.
std::vector<vtkSmartPointer<vtkRelievoMarkers>> ReadMarkers(
  const std::vector<MarkerChoice>& choices, int upAxis, Progress& progress);
}

#endif
