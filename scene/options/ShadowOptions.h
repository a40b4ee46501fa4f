// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Options of `relievo render` about the accuracy of shadows: goals for choosing the method, and
 * certification. Each throws UsageError.
 */
#ifndef ShadowOptions_h
#define ShadowOptions_h

#include "SceneNames.h"
#include "Values.h" // for NamedWords

#include <string>

namespace scene
{
struct RenderOptions;

/// The rows of shadows, from --shadows to --certify.
void AddShadowOptions(OptionRows& rows, RenderOptions& options);

/// Shows shadows by maps, unless options say otherwise.
void ShowShadows(RenderOptions& options, const NamedWords& parameters = {});

/// Checks that the goals fit the other options; a goal of accuracy or speed switches shadows on.
void CheckShadowWishes(RenderOptions& options);

/// Rejects options about shadows that have no effect without shadows.
void CheckShadowsAsked(const RenderOptions& options);

/// Whether any option shows shadows in the picture.
bool ShowsShadows(const RenderOptions& options);

/// Throws UsageError if a layer refers to a light beyond the `lights` available. `whose` names the
/// lights in the message, such as "--light options".
void CheckShadowLayers(const RenderOptions& options, int lights, const std::string& whose);
}

#endif
