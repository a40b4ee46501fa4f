// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Sets the look of meshes and the background.
 */
#ifndef Look_h
#define Look_h

#include "LookNames.h"
#include "LookOptions.h"

class vtkRenderer;

namespace reading
{
struct ArrayNames;
}

namespace look
{

/// Sets the shading of all actors' surfaces.
void SetShading(vtkRenderer* renderer, Shading kind);

/// Sets colours, edges, opacity, background, colour bar. `arrays`: names of the drawn props'
/// arrays; `mapped`: whether surfaces have a normal map or heights. Throws UsageError if no drawn
/// prop has the array to colour by, or if it has fewer components.
void SetLook(vtkRenderer* renderer, LookChoice look, const ArrayNames& arrays, bool mapped);

///@{
/// The rows of --shading, and of a look.
void AddShadingOption(OptionRows& rows, Shading& shading);
void AddLookOptions(OptionRows& rows, LookChoice& look);
///@}
}

#endif
