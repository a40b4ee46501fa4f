// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Numbers as words of the command line.
 */
#ifndef Numbers_h
#define Numbers_h

#include <string>
#include <vector>

namespace viewer
{
/// The shortest digits that give the number back.
std::string WriteNumber(double value);

/// Numbers between commas.
std::string WriteNumbers(const std::vector<double>& values);
}

#endif
