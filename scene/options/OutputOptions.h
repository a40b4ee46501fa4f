// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The files that `relievo render` writes.
 */
#ifndef OutputOptions_h
#define OutputOptions_h

#include "SceneNames.h"

namespace scene
{
struct RenderOptions;

///@{
/// The rows of --layers, --png and --transparent, and of --exr and the later ones.
void AddPictureOptions(OptionRows& rows, RenderOptions& options);
void AddOutputOptions(OptionRows& rows, RenderOptions& options);
///@}

/// Throws UsageError unless there is a file and an output.
void CheckOutputs(const RenderOptions& options);
}

#endif
