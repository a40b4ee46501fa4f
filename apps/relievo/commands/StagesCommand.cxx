// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Command.h"
#include "Errors.h"
#include "Stages.h"

#include <cstdio>

namespace cli
{
namespace
{
class StagesCommand : public Command
{
public:
  StagesCommand()
    : Command("stages", "",
        "stages lists the stages of the frame, and the values that their parameters take.")
  {
  }

  int Run(const std::vector<std::string>& words) override
  {
    if (!words.empty())
    {
      throw words::UsageError("stages: got '" + words.front() + "', expected nothing after it");
    }
    std::fputs(scene::DescribeStages().c_str(), stdout);
    return 0;
  }
};
}

//------------------------------------------------------------------------------
std::unique_ptr<Command> MakeStages()
{
  return std::make_unique<StagesCommand>();
}
}
