// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Guesses the up axis of a file that does not define it.
 */
#ifndef UpAxis_h
#define UpAxis_h

#include "ReadingNames.h"

#include <string>

namespace reading
{
/// Returns 1 (y) or 2 (z), by the format's custom and by the place of the bounds: models from tools
/// with z up stand on z = 0.
int FindUpAxis(const std::string& path, const double bounds[6]);

/// The row of --up: 0, 1, 2 for x, y, z.
void AddUpOption(OptionRows& rows, int& axis);
}

#endif
