// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * --tone and --exposure: parameters of the stage `tone`. All functions throw UsageError.
 */
#ifndef ToneOptions_h
#define ToneOptions_h

#include "SceneNames.h"

#include <string>

namespace scene
{
struct RenderOptions;

void TakeTone(RenderOptions& options, const std::string& word);
void TakeExposure(RenderOptions& options, const std::string& word);
}

#endif
