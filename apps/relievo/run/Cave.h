// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Cave_h
#define Cave_h

namespace cli
{
struct CaveOptions;

/// `relievo cave`: makes caves, writes them, and says how much of them is air.
void Cave(const CaveOptions& options);
}

#endif
