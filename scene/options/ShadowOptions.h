// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Options of `relievo render` about how right shadows are: what their method is chosen for, and
 * whether that is proven. Each throws UsageError.
 */
#ifndef ShadowOptions_h
#define ShadowOptions_h

#include <set>
#include <string>

namespace scene
{
struct RenderOptions;

/// Rays.
void TakeCertify(RenderOptions& options, const std::string& word);

/// Whether they go together with the `given` options; a goal of right or quick shadows switches
/// them on.
void CheckShadowWishes(RenderOptions& options, const std::set<std::string>& given);

/// Whether shadows are seen in the picture, by whichever option.
bool ShowsShadows(const RenderOptions& options);

/// Throws UsageError if a layer is of a light beyond the `lights` that there are. `whose` says in
/// the message what they are, such as "--light options".
void CheckShadowLayers(const RenderOptions& options, int lights, const std::string& whose);
}

#endif
