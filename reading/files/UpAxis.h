// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Which way is up in a file that does not say so.
 */
#ifndef UpAxis_h
#define UpAxis_h

#include <string>

namespace scene
{
/// 1 (y) or 2 (z), by the format's custom, and by where what was read lies: models of tools with z
/// up stand on z = 0.
int FindUpAxis(const std::string& path, const double bounds[6]);
}

#endif
