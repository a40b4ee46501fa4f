// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What surfaces wear, from image files: normals, relief, and what is all around.
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

/// Puts maps and environment on every actor but the grid. Throws WorkError with the file's name.
void SetSurface(const Scene& scene, const RenderOptions& options, Progress& progress);
}

#endif
