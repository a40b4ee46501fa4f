// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bench.h"

#include "BenchOptions.h"
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
#ifdef RELIEVO_HAVE_BENCH
namespace
{
constexpr char All[] = "all";
constexpr int QuickRounds = 3;

int RunSeveral(const BenchOptions& options, const std::vector<std::string>& names)
{
  std::vector<std::string> asked = options.Names;
  if (std::find(asked.begin(), asked.end(), All) != asked.end())
  {
    asked = names;
  }
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error)
  {
    throw scene::WorkError("bench: cannot find its own program: " + error.message());
  }
  std::vector<std::string> machine = scene::Split(scene::DescribeVersions(), '\n');
  machine.erase(std::remove(machine.begin(), machine.end(), ""), machine.end());
  return relievoBench::RunBenches(
    program.string(), asked, options.Folder, options.Beside, machine, options.Quick);
}
}
#endif

//------------------------------------------------------------------------------
int Bench(const BenchOptions& options)
{
#ifdef RELIEVO_HAVE_BENCH
  std::vector<std::string> names;
  for (const RelievoBenchEntry& entry : RelievoBenchEntries())
  {
    names.emplace_back(entry.Name);
  }
  const bool several = options.Names.size() > 1 || !options.Beside.empty() ||
    (options.Names.size() == 1 && options.Names.front() == All);
  const std::string expected = "one of " + scene::Join(names, ", ") + ", or all";
  if (options.Names.empty())
  {
    throw scene::UsageError("bench: no NAME given, expected " + expected);
  }
  for (const std::string& name : options.Names)
  {
    if (std::find(names.begin(), names.end(), name) == names.end() && name != All)
    {
      scene::RefuseValue("bench", name, expected);
    }
  }
  {
    vtkNew<vtkRenderWindow> probe; // benches draw in windows that they make themselves
    scene::CheckDisplay(probe);
  }
  if (several)
  {
    return RunSeveral(options, names);
  }
  relievoBench::SetMostRounds(options.Quick ? QuickRounds : 0);
  return RelievoBench(options.Names.front(), options.Folder);
#else
  (void)options;
  throw scene::UsageError(
    "bench: this relievo was built without its benches (RELIEVO_BUILD_BENCH=OFF)");
#endif
}
}
