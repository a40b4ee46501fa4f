// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The values of the options that say what surfaces wear, and what of them goes together. All throw
 * UsageError.
 */
#ifndef SurfaceOptions_h
#define SurfaceOptions_h

#include <set>
#include <string>

namespace scene
{
struct RenderOptions;

void TakeHeightMap(RenderOptions& options, const std::string& word);
void TakeRelief(RenderOptions& options, const std::string& word);
void TakeTextureCoordinates(RenderOptions& options, const std::string& word);
void TakeEnvironment(RenderOptions& options, const std::string& word);
void TakeReflectivity(RenderOptions& options, const std::string& word);
void TakeUp(RenderOptions& options, const std::string& word);

/// `given`: the names of the options that were said.
void CheckSurfaceOptions(const RenderOptions& options, const std::set<std::string>& given);
}

#endif
