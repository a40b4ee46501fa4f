// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Sets the look of meshes and the background.
 */
#ifndef Look_h
#define Look_h

namespace scene
{
struct RenderOptions;
struct Scene;

/// Sets colours, edges, opacity, background, colour bar. Throws WorkError if no drawn prop has the
/// array to colour by, or if it has fewer components.
void SetLook(Scene& scene, const RenderOptions& options);

/// Depth peeling where anything of the files is translucent. Their materials decide that, too.
void SetDepthPeeling(const Scene& scene);
}

#endif
