// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Models with bones to actors: posed at a time, with their colours and textures.
 */
#ifndef Models_h
#define Models_h

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkActor;

namespace cli
{
class Progress;
struct ModelChoice;

/// An actor for each mesh. What was mended while reading and textures that are missing are noted.
/// `smooth`: as MakeActor. Throws WorkError with the path.
std::vector<vtkSmartPointer<vtkActor>> ReadModel(
  const std::string& path, const ModelChoice& choice, bool smooth, Progress& progress);
}

#endif
