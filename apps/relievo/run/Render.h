// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Render_h
#define Render_h

#include <string>
#include <vector>

namespace cli
{
/// The words after "render": reads, draws and writes. Throws scene::UsageError or scene::WorkError.
void Render(const std::vector<std::string>& words);
}

#endif
