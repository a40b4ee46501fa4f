// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Render_h
#define Render_h

namespace cli
{
struct RenderOptions;

/// `relievo render`: reads, draws and writes what was asked for, and nothing else. Throws
/// UsageError or WorkError; then none of the outputs is written.
void Render(const RenderOptions& options);
}

#endif
