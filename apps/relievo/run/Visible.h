// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Visible_h
#define Visible_h

namespace cli
{
struct VisibleOptions;

/// Writes a mesh with what cameras see of it, and says how much that is. Throws WorkError.
void Visible(const VisibleOptions& options);
}

#endif
