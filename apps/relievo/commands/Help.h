// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Help_h
#define Help_h

#include "Command.h"

#include <memory>
#include <string>
#include <vector>

namespace cli
{
using Commands = std::vector<std::unique_ptr<Command>>;

/// The commands in the order of the help, up to the one with this name; all if there is none.
Commands MakeCommands(const std::string& last);

/// The output of `relievo --help`.
std::string GetHelpPage(const Commands& commands);

/// The output of `relievo COMMAND --help`.
std::string GetHelpPage(const Command& command);

/// The output of `relievo --words`, for completion in shells: vtkRelievoCommand::GetWords of each
/// command, and of the viewer.
std::string GetWords(const Commands& commands);
}

#endif
