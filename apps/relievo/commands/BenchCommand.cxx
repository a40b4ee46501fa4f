// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Command.h"
#include "Errors.h"

#ifdef RELIEVO_HAVE_BENCH
#include "BenchRuns.h"
#include "Display.h"
#include "RelievoBench.h"
#include "Rounds.h"
#include "Values.h"
#include "Version.h"

#include "vtkNew.h"
#include "vtkRenderWindow.h"

#include <algorithm>
#include <filesystem>
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
    : Command("bench", "NAME...",
        "bench runs benchmarks, prints their results, and writes CSV files, and charts if "
        "Python has matplotlib; otherwise bench/charts.py draws them later. Without a known "
        "NAME it lists the names. Several NAMEs, or all, run in separate processes, so that "
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
    this->AddFlag("--quick",
      "repeats each measurement three times instead of up to 31 times, for a first look; "
      "the same call without --quick measures again",
      this->Quick);
  }

  int Run(const std::vector<std::string>& words) override
  {
    this->Take(words);
#ifdef RELIEVO_HAVE_BENCH
    std::vector<std::string> names;
    for (const RelievoBenchEntry& entry : RelievoBenchEntries())
    {
      names.emplace_back(entry.Name);
    }
    const std::string all = "all";
    const bool isAll = std::find(this->Names.begin(), this->Names.end(), all) != this->Names.end();
    const std::string expected = "one of " + scene::Join(names, ", ") + ", or all";
    if (this->Names.empty())
    {
      throw scene::UsageError("bench: no NAME given, expected " + expected);
    }
    for (const std::string& name : this->Names)
    {
      if (std::find(names.begin(), names.end(), name) == names.end() && name != all)
      {
        scene::RefuseValue("bench", name, expected);
      }
    }
    {
      vtkNew<vtkRenderWindow> probe; // benches draw in windows of their own
      scene::CheckDisplay(probe);
    }
    if (isAll || this->Names.size() > 1 || !this->Beside.empty())
    {
      return this->RunSeveral(isAll ? names : this->Names);
    }
    constexpr int quickRounds = 3;
    relievoBench::SetMostRounds(this->Quick ? quickRounds : 0);
    return RelievoBench(this->Names.front(), this->Folder);
#else
    throw scene::UsageError(
      "bench: this relievo was built without its benches (RELIEVO_BUILD_BENCH=OFF)");
#endif
  }

private:
#ifdef RELIEVO_HAVE_BENCH
  int RunSeveral(const std::vector<std::string>& asked) const
  {
    std::error_code error;
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
    if (error)
    {
      throw scene::WorkError("bench: cannot find its own program: " + error.message());
    }
    std::vector<std::string> machine = scene::Split(scene::DescribeVersions(), '\n');
    machine.erase(std::remove(machine.begin(), machine.end(), ""), machine.end());
    return relievoBench::RunBenches(
      program.string(), asked, this->Folder, this->Beside, machine, this->Quick);
  }
#endif

  std::string Folder = ".";
  std::string Beside; // folder of CSV files for comparison; may be empty
  bool Quick = false; // fewer repetitions
};
}

//------------------------------------------------------------------------------
std::unique_ptr<Command> MakeBench()
{
  return std::make_unique<BenchCommand>();
}
}
