// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Numbers as words of the command line.
 */
#ifndef Numbers_h
#define Numbers_h

#include <string>
#include <vector>

namespace scene
{
/// The shortest digits that give the number back.
std::string WriteNumber(double value);

/// The value to a power of ten that is not above the step: few digits for WriteNumber.
double RoundTo(double value, double step);

/// FILE,NUMBER, as options of images have it; without a 0 where the name alone is read as such.
std::string WriteFileAndNumber(const std::string& file, double number);

/// Numbers between commas.
std::string WriteNumbers(const std::vector<double>& values);
}

#endif
