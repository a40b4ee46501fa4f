// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the files of a picture hold, to be read.
 */
#ifndef SceneText_h
#define SceneText_h

#include <QString>

#include <array>
#include <string>
#include <vector>

namespace viewer
{
class Picture;

/// "181 × 217 × 181 points"
QString WriteDimensions(const std::array<int, 3>& dimensions);

/// HTML: of each file its place, size, numbers of points and cells, bounds and arrays with their
/// ranges; of all together times and lights.
QString WriteScene(const Picture& picture, const std::vector<std::string>& files);
}

#endif
