// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * --tone and --exposure: parameters of the stage `tone`.
 */
#ifndef ToneOptions_h
#define ToneOptions_h

#include "SceneNames.h"

namespace scene
{
struct RenderOptions;

/// The rows of these options.
void AddToneOptions(OptionRows& rows, RenderOptions& options);
}

#endif
