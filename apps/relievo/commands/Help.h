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

/// All commands, in the order of the help.
Commands MakeCommands();

/// The output of `relievo --help`.
std::string GetHelpPage(const Commands& commands);

/// The output of `relievo COMMAND --help`.
std::string GetHelpPage(const Command& command);

/// The output of `relievo --words`, for completion in shells: vtkRelievoCommand::GetWords of each
/// command, and of the viewer.
std::string GetWords(const Commands& commands);
}

#endif
