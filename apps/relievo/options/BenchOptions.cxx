// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Errors.h"
#include "Options.h"

namespace cli
{
//------------------------------------------------------------------------------
BenchOptions ParseBench(const std::vector<std::string>& words)
{
  BenchOptions options;
  ParseArguments(
    words, "bench",
    { { "--out", false }, { "--redraw", false }, { "--beside", false }, { "--quick", true } },
    [&](const std::string& name, const std::string& value) {
      if (name == "--quick")
      {
        options.Quick = true;
        return;
      }
      if (value.empty())
      {
        throw UsageError(name + ": its value is empty; give a folder");
      }
      (name == "--out"         ? options.Folder
          : name == "--redraw" ? options.Redraw
                               : options.Beside) = value;
    },
    [&](const std::string& word) { options.Names.push_back(word); });
  if (options.Names.size() > 1 && !options.Redraw.empty())
  {
    throw UsageError("bench: got '" + options.Names[0] + "' and '" + options.Names[1] +
      "', expected one NAME with --redraw");
  }
  if (!options.Redraw.empty() && !options.Beside.empty())
  {
    throw UsageError("--beside: compares what is measured, expected without --redraw");
  }
  if (!options.Redraw.empty() && options.Quick)
  {
    throw UsageError("--quick: of what is measured, expected without --redraw");
  }
  return options;
}
}
