// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Help_h
#define Help_h

#include <string>

namespace cli
{
/// The page that --help prints.
std::string GetHelpPage();
}

#endif
