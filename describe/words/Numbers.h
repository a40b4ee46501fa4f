// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Writes and parses numbers as words of the command line.
 */
#ifndef Numbers_h
#define Numbers_h

#include <string>
#include <vector>

namespace words
{
/// The shortest digits that parse back to the value.
std::string WriteNumber(double value);

/// Rounds the value to the largest power of ten not above the step: few digits for WriteNumber.
double RoundTo(double value, double step);

/// Writes FILE,NUMBER for options of images; omits 0 unless the bare name would be parsed
/// otherwise.
std::string WriteFileAndNumber(const std::string& file, double number);

/// Writes numbers separated by commas.
std::string WriteNumbers(const std::vector<double>& values);
}

#endif
