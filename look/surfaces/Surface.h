// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Sets surface maps from image files: normals, relief, and the environment.
 */
#ifndef Surface_h
#define Surface_h

#include "LookNames.h"

#include <vector>

class vtkActor;
class vtkRenderer;

namespace reading
{
class ReadContext;
}

namespace look
{
struct SurfaceChoice;

/// Throws UsageError or WorkError for a file that is no image, or cannot be opened.
void CheckSurface(const SurfaceChoice& surface);

/// Sets maps and environment on every actor but those of `without`, some of which may be null.
/// `up`: the axis that points up; `opaque`: no option makes surfaces translucent. Throws WorkError
/// naming the file.
void SetSurface(vtkRenderer* renderer, const std::vector<vtkActor*>& without,
  const SurfaceChoice& surface, int up, bool opaque, ReadContext& context);

/// The rows of maps, relief, material and texture coordinates.
void AddMapOptions(OptionRows& rows, SurfaceChoice& surface);
}

#endif
