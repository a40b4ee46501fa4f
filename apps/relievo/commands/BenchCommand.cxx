// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Command.h"
#include "Errors.h"

#ifdef RELIEVO_HAVE_BENCH
#include "BenchRuns.h"
#include "Display.h"
#include "RelievoBench.h"
#include "Rounds.h"
#include "Scripts.h"
#include "Values.h"
#include "Version.h"

#include "vtkNew.h"
#include "vtkRenderWindow.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <string>
#include <system_error>
#include <vector>
#endif

namespace cli
{
namespace
{
class BenchCommand : public Command
{
public:
  BenchCommand()
    : Command("bench", "NAME... | NAME -- OPTION...",
        "bench runs benchmarks, prints their results, and writes CSV files, and charts if "
        "Python has matplotlib; otherwise bench/charts.py draws them later. Some benches are "
        "Python scripts, which need the sources from which relievo was built; words after -- are "
        "options of the script. "
        "Several NAMEs, or all, run in separate processes, so that "
        "a failure does not stop the others: their output is in DIR/logs, and DIR/summary.md "
        "lists outcomes and times. Repeating the call runs only the unfinished ones.")
  {
    this->AddWord("--out DIR", "output folder (the current folder)", this->Folder).Files = "/";
    this
      ->AddWord("--beside DIR",
        "writes the summary, also for one NAME, with the figures of the CSV files in DIR, "
        "such as docs/charts, beside the new ones",
        this->Beside)
      .Files = "/";
    this->AddFlag("--list", "lists the benches with a line about each", this->Lists);
    this->AddFlag("--quick",
      "repeats each measurement three times instead of up to 31 times, or draws few scenes, for a "
      "first look; the same call without --quick measures again",
      this->Quick);
  }

  int Run(const std::vector<std::string>& words) override
  {
    const auto dashes = std::find(words.begin(), words.end(), "--");
    this->Take({ words.begin(), dashes });
#ifdef RELIEVO_HAVE_BENCH
    if (this->Lists)
    {
      List();
      return 0;
    }
    std::vector<std::string> names;
    for (const RelievoBenchEntry& entry : RelievoBenchEntries())
    {
      names.emplace_back(entry.Name);
    }
    const std::string all = "all";
    const bool isAll = std::find(this->Names.begin(), this->Names.end(), all) != this->Names.end();
    const std::string expected = "one of " + words::Join(names, ", ") + ", or all";
    if (this->Names.empty())
    {
      throw words::UsageError(
        "bench: no NAME given, expected " + expected + " (bench --list describes them)");
    }
    for (const std::string& name : this->Names)
    {
      if (std::find(names.begin(), names.end(), name) == names.end() && name != all)
      {
        words::RefuseValue("bench", name, expected);
      }
    }
    const bool isScript = this->Names.size() == 1 && !isAll && FindScript(this->Names.front());
    if (dashes != words.end() && !(isScript && this->Beside.empty()))
    {
      throw words::UsageError("bench: got options after --, expected one NAME of a Python script "
                              "(bench --list has them), without --beside");
    }
    {
      vtkNew<vtkRenderWindow> probe; // benches draw in windows of their own
      scene::CheckDisplay(probe);
    }
    if (isAll || this->Names.size() > 1 || !this->Beside.empty())
    {
      return this->RunSeveral(isAll ? ListRunnable() : this->Names);
    }
    if (dashes != words.end())
    {
      relievoBench::SetScriptWords({ std::next(dashes), words.end() });
    }
    constexpr int quickRounds = 3;
    relievoBench::SetMostRounds(this->Quick ? quickRounds : 0);
    return RelievoBench(this->Names.front(), this->Folder);
#else
    throw words::UsageError(
      "bench: this relievo was built without its benches (RELIEVO_BUILD_BENCH=OFF)");
#endif
  }

private:
#ifdef RELIEVO_HAVE_BENCH
  static void List()
  {
    std::size_t width = 0;
    for (const RelievoBenchEntry& entry : RelievoBenchEntries())
    {
      width = std::max(width, std::string(entry.Name).size());
    }
    for (const RelievoBenchEntry& entry : RelievoBenchEntries())
    {
      std::printf("%-*s  %s%s\n", static_cast<int>(width), entry.Name, entry.What,
        entry.Script ? (std::string(" (bench/") + entry.Script + ")").c_str() : "");
    }
  }

  // The file of a Python bench; null for others.
  static const char* FindScript(const std::string& name)
  {
    for (const RelievoBenchEntry& entry : RelievoBenchEntries())
    {
      if (name == entry.Name)
      {
        return entry.Script;
      }
    }
    return nullptr;
  }

  // The benches that `all` means: Python scripts only where they are.
  static std::vector<std::string> ListRunnable()
  {
    std::vector<std::string> names;
    for (const RelievoBenchEntry& entry : RelievoBenchEntries())
    {
      const std::string whyNot =
        entry.Script ? relievoBench::FindWhyNot(entry.Script) : std::string();
      if (whyNot.empty())
      {
        names.emplace_back(entry.Name);
        continue;
      }
      std::printf("%s is left out: %s\n", entry.Name, whyNot.c_str());
    }
    return names;
  }

  int RunSeveral(const std::vector<std::string>& asked) const
  {
    std::error_code error;
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
    if (error)
    {
      throw words::WorkError("bench: cannot find its own program: " + error.message());
    }
    std::vector<std::string> machine = words::Split(scene::DescribeVersions(), '\n');
    machine.erase(std::remove(machine.begin(), machine.end(), ""), machine.end());
    return relievoBench::RunBenches(
      program.string(), asked, this->Folder, this->Beside, machine, this->Quick);
  }
#endif

  std::string Folder = ".";
  std::string Beside; // folder of CSV files for comparison; may be empty
  bool Lists = false; // only lists the benches
  bool Quick = false; // fewer repetitions
};
}

//------------------------------------------------------------------------------
std::unique_ptr<Command> MakeBench()
{
  return std::make_unique<BenchCommand>();
}
}
