// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Errors.h"
#include "Help.h"
#include "Outputs.h"
#include "StandardError.h"
#include "Values.h"
#include "Version.h"

#include <algorithm>
#include <cstdio>
#include <exception>

namespace
{
int Run(std::vector<std::string> words)
{
  const cli::Commands commands = cli::MakeCommands(words.empty() ? "" : words.front());
  std::vector<std::string> names;
  for (const auto& command : commands)
  {
    names.push_back(command->Describe().Name);
  }
  const auto end = std::find(words.begin(), words.end(), "--");
  const auto found =
    words.empty() ? names.end() : std::find(names.begin(), names.end(), words.front());
  const auto place = static_cast<std::size_t>(found - names.begin());
  if (std::find(words.begin(), end, "--help") != end || std::find(words.begin(), end, "-h") != end)
  {
    const std::string page =
      found == names.end() ? cli::GetHelpPage(commands) : cli::GetHelpPage(*commands[place]);
    std::fputs(page.c_str(), stdout);
    return 0;
  }
  if (std::find(words.begin(), end, "--version") != end)
  {
    std::fputs(scene::DescribeVersions().c_str(), stdout);
    return 0;
  }
  if (words.empty())
  {
    throw words::UsageError(
      "no command given, expected " + vtkRelievoEither(names) + "; see relievo --help");
  }
  const std::string name = words.front();
  if (name == "--words")
  {
    std::fputs(cli::GetWords(commands).c_str(), stdout);
    return 0;
  }
  if (found == names.end())
  {
    throw words::UsageError("got '" + name + "', expected " + words::Join(names, ", ") +
      ", --help or --version; see relievo --help");
  }
  words.erase(words.begin());
  return commands[place]->Run(words);
}

int Fail(const char* text, int status)
{
  std::fprintf(reading::StandardError(), "relievo: %s\n", text);
  return status;
}
}

int main(int argc, char* argv[])
{
  reading::BeProgram();
  reading::Outputs::RemoveAtEnd();
  try
  {
    const int status = Run(std::vector<std::string>(argv + std::min(argc, 1), argv + argc));
    if (!reading::FlushStandardOutput())
    {
      throw words::WorkError("the standard output cannot be written; is the disk full?");
    }
    return status;
  }
  catch (const words::UsageError& error)
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
