// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Sets surface maps from image files: normals, relief, and the environment.
 */
#ifndef Surface_h
#define Surface_h

namespace scene
{
class Progress;
struct RenderOptions;
struct Scene;

/// Throws UsageError or WorkError for a file that is no image, or cannot be opened.
void CheckSurface(const RenderOptions& options);

/// Sets maps and environment on every actor but the grid. Throws WorkError naming the file.
void SetSurface(const Scene& scene, const RenderOptions& options, Progress& progress);
}

#endif
