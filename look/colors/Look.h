// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What meshes and the background look like.
 */
#ifndef Look_h
#define Look_h

#include "LookOptions.h"

class vtkRenderer;

namespace scene
{
struct ArrayNames;

/// How the surfaces of all actors are shaded.
void SetShading(vtkRenderer* renderer, Shading kind);

/// Colours, edges, opacity, background, colour bar. `arrays`: those of what is shown; `mapped`:
/// whether surfaces have a normal map or heights. Throws UsageError if nothing that is drawn has
/// the array to colour by, or not so many components.
void SetLook(vtkRenderer* renderer, LookChoice look, const ArrayNames& arrays, bool mapped);
}

#endif
