// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoMemory.h
 * @brief Whether there is room for what a filter is about to make.
 */
#ifndef vtkRelievoMemory_h
#define vtkRelievoMemory_h

#include <string>

namespace relievo
{
/**
 * Empty if so many bytes fit under the limit, or, with a limit of 0, into the memory that the
 * machine and its limits for this process leave; else words for the message, with both numbers. Of
 * these bytes, the caller may hold some already: they are not to be found again.
 */
std::string LackOfMemory(double bytes, double limit, double held = 0.);
}

#endif
