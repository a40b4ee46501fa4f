// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchOptions.h"

#include "Arguments.h"
#include "Errors.h"

namespace cli
{
//------------------------------------------------------------------------------
BenchOptions ParseBench(const std::vector<std::string>& words)
{
  BenchOptions options;
  scene::ParseArguments(
    words, "bench", { { "--out", false }, { "--beside", false }, { "--quick", true } },
    [&](const std::string& name, const std::string& value) {
      if (name == "--quick")
      {
        options.Quick = true;
        return;
      }
      if (value.empty())
      {
        throw scene::UsageError(name + ": its value is empty; give a folder");
      }
      (name == "--out" ? options.Folder : options.Beside) = value;
    },
    [&](const std::string& word) { options.Names.push_back(word); });
  return options;
}
}
