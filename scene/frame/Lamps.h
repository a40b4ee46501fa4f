// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lamps_h
#define Lamps_h

#include "LampOptions.h"

#include "vtkSmartPointer.h"

#include <vector>

class vtkRelievoLamps;

namespace scene
{
class Progress;

/// The points of each file as lamps. Throws WorkError with the file's name: what cannot be read,
/// arrays that do not fit, files without a point that is a lamp.
std::vector<vtkSmartPointer<vtkRelievoLamps>> ReadLamps(
  const std::vector<LampChoice>& choices, Progress& progress);
}

#endif
