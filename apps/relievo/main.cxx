// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bench.h"
#include "BenchOptions.h"
#include "Cave.h"
#include "CaveOptions.h"
#include "Dataset.h"
#include "DatasetOptions.h"
#include "Errors.h"
#include "Help.h"
#include "Outputs.h"
#include "Render.h"
#include "Stages.h"
#include "StandardError.h"
#include "SunHours.h"
#include "SunOptions.h"
#include "Version.h"
#include "Visible.h"
#include "VisibleOptions.h"

#include <algorithm>
#include <cstdio>
#include <exception>

namespace
{
int Run(std::vector<std::string> words)
{
  const auto end = std::find(words.begin(), words.end(), "--");
  if (std::find(words.begin(), end, "--help") != end || std::find(words.begin(), end, "-h") != end)
  {
    std::fputs(cli::GetHelpPage().c_str(), stdout);
    return 0;
  }
  if (std::find(words.begin(), end, "--version") != end)
  {
    std::fputs(scene::DescribeVersions().c_str(), stdout);
    return 0;
  }
  if (words.empty())
  {
    throw scene::UsageError("no command given, expected render, dataset, visible, sun, cave, "
                            "stages or bench; see relievo --help");
  }
  const std::string command = words.front();
  words.erase(words.begin());
  if (command == "render")
  {
    cli::Render(words);
  }
  else if (command == "dataset")
  {
    cli::Dataset(cli::ParseDataset(words));
  }
  else if (command == "visible")
  {
    cli::Visible(cli::ParseVisible(words));
  }
  else if (command == "sun")
  {
    cli::SunHours(cli::ParseSun(words));
  }
  else if (command == "cave")
  {
    cli::Cave(cli::ParseCave(words));
  }
  else if (command == "stages")
  {
    if (!words.empty())
    {
      throw scene::UsageError("stages: got '" + words.front() + "', expected nothing behind it");
    }
    std::fputs(scene::DescribeStages().c_str(), stdout);
  }
  else if (command == "bench")
  {
    return cli::Bench(cli::ParseBench(words));
  }
  else
  {
    throw scene::UsageError("got '" + command +
      "', expected render, dataset, visible, sun, cave, stages, bench, --help or --version; see "
      "relievo --help");
  }
  return 0;
}

int Fail(const char* text, int status)
{
  std::fprintf(scene::StandardError(), "relievo: %s\n", text);
  return status;
}
}

int main(int argc, char* argv[])
{
  scene::BeProgram();
  scene::Outputs::RemoveAtEnd();
  try
  {
    const int status = Run(std::vector<std::string>(argv + std::min(argc, 1), argv + argc));
    if (!scene::FlushStandardOutput())
    {
      throw scene::WorkError("the standard output cannot be written; is the disk full?");
    }
    return status;
  }
  catch (const scene::UsageError& error)
  {
    return Fail(error.what(), 2);
  }
  catch (const std::bad_alloc&)
  {
    return Fail("out of memory; a smaller --size or fewer --layers need less", 1);
  }
  catch (const std::exception& error)
  {
    return Fail(error.what(), 1);
  }
}
