// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What meshes and the background look like.
 */
#ifndef Look_h
#define Look_h

namespace scene
{
struct RenderOptions;
struct Scene;

/// Colours, edges, opacity, background, colour bar. Throws WorkError if nothing that is drawn has
/// the array to colour by, or not so many components.
void SetLook(Scene& scene, const RenderOptions& options);

/// Depth peeling where anything of the files is translucent. Their materials decide that, too.
void SetDepthPeeling(const Scene& scene);
}

#endif
