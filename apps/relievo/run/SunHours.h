// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SunHours_h
#define SunHours_h

namespace cli
{
struct SunOptions;

/// Writes a mesh with its hours of sun, and says how many there are. Throws WorkError.
void SunHours(const SunOptions& options);
}

#endif
