// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoMemory.h
 * @brief Checks whether there is memory for a filter's output.
 */
#ifndef vtkRelievoMemory_h
#define vtkRelievoMemory_h

#include "vtkRelievoBaseModule.h" // for the export macro

#include <string>

namespace relievo
{
/**
 * Empty if so many bytes fit under the limit or, with a limit of 0, into the memory free for this
 * process; otherwise a text for the message, with both numbers. The caller may hold `held` of these
 * bytes already; they need not be free.
 */
VTKRELIEVOBASE_EXPORT std::string LackOfMemory(double bytes, double limit, double held = 0.);
}

#endif
