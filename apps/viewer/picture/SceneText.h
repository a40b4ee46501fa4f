// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A description of a picture's files as text.
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

/// HTML: for each file its path, size, numbers of points and cells, bounds and arrays with their
/// ranges; for all together times and lights.
QString WriteScene(const Picture& picture, const std::vector<std::string>& files);
}

#endif
