// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchRuns.h"

#include "BenchSummary.h"
#include "Scripts.h"
#include "Table.h"

#include <vtksys/Process.h>
#include <vtksys/SystemInformation.hxx>
#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <iostream>

namespace relievoBench
{
namespace
{
constexpr double TooLong = 7200.; // seconds; a bench that takes longer hangs
constexpr char Done[] = "done";
constexpr char LeftOut[] = "left out";         // it cannot run here
constexpr char DoneQuickly[] = "done quickly"; // fewer rounds

std::string RunsFile(const std::string& folder)
{
  return folder + "/benches.csv";
}

// Reads earlier runs; false, with a message, if the file is another table.
bool ReadRuns(const std::string& folder, std::vector<BenchRun>& runs)
{
  if (!vtksys::SystemTools::FileExists(RunsFile(folder), true))
  {
    return true;
  }
  std::vector<CsvRow> rows;
  if (!ReadCsv(RunsFile(folder), rows))
  {
    return false;
  }
  for (const CsvRow& row : rows)
  {
    const auto name = row.find("bench");
    const auto status = row.find("status");
    if (name == row.end() || status == row.end())
    {
      std::cerr << "relievo: bench: " << RunsFile(folder)
                << ": expected the columns bench, status and seconds; write to another folder\n";
      return false;
    }
    const double seconds = NumberIn(row, "seconds");
    runs.push_back({ name->second, status->second, std::isfinite(seconds) ? seconds : 0. });
  }
  return true;
}

bool WriteRuns(const std::string& folder, const std::vector<BenchRun>& runs)
{
  Table table({ "bench", "status", "seconds" });
  for (const BenchRun& run : runs)
  {
    table.AddRow({ run.Name, run.Status, Number(run.Seconds) });
  }
  return table.WriteCsv(RunsFile(folder));
}

bool IsDone(const std::string& status, bool quick)
{
  return status == Done || (quick && status == DoneQuickly);
}

// Runs a bench and returns its status; a failure ends with the last line of the log.
std::string RunOne(
  const std::string& program, const std::string& name, const std::string& folder, bool quick)
{
  const std::string path = folder + "/logs/" + name + ".txt";
  std::ofstream log(path, std::ios::binary);
  if (!log)
  {
    return "no log: cannot write " + path;
  }
  const char* const command[] = { program.c_str(), "bench", name.c_str(), "--out", folder.c_str(),
    quick ? "--quick" : nullptr, nullptr };
  vtksysProcess* process = vtksysProcess_New();
  vtksysProcess_SetCommand(process, command);
  vtksysProcess_SetTimeout(process, TooLong);
  vtksysProcess_Execute(process);
  char* data = nullptr;
  int length = 0;
  std::string last;
  while (vtksysProcess_WaitForData(process, &data, &length, nullptr))
  {
    log.write(data, length);
    log.flush();
    last.append(data, static_cast<std::size_t>(length));
    last.erase(0, last.size() > 400 ? last.size() - 400 : 0);
  }
  vtksysProcess_WaitForExit(process, nullptr);
  std::string status;
  switch (vtksysProcess_GetState(process))
  {
    case vtksysProcess_State_Exited:
    {
      const int value = vtksysProcess_GetExitValue(process);
      status = value == MissingPackage ? LeftOut
        : value != 0                   ? "failed, status " + std::to_string(value)
        : quick                        ? DoneQuickly
                                       : Done;
      break;
    }
    case vtksysProcess_State_Exception:
      status = std::string("crashed: ") + vtksysProcess_GetExceptionString(process);
      break;
    case vtksysProcess_State_Expired:
      status = "stopped after " + Number(TooLong) + " s";
      break;
    default:
      status = std::string("did not start: ") + vtksysProcess_GetErrorString(process);
  }
  vtksysProcess_Delete(process);
  if (!IsDone(status, true))
  {
    last.erase(last.find_last_not_of("\n") + 1);
    const std::string line = last.substr(last.find_last_of('\n') + 1);
    status += line.empty() ? "" : ": " + line;
  }
  return status;
}
}

//------------------------------------------------------------------------------
int RunBenches(const std::string& program, const std::vector<std::string>& names,
  const std::string& folder, const std::string& beside, std::vector<std::string> machine,
  bool quick)
{
  if (!beside.empty() && !HasTables(beside))
  {
    std::cerr << "relievo: --beside: got '" << beside
              << "', expected a folder with tables of benches (CSV)\n";
    return 2;
  }
  std::vector<BenchRun> runs;
  if (!ReadRuns(folder, runs))
  {
    return 2;
  }
  if (!MakeFolder(folder) || !MakeFolder(folder + "/logs"))
  {
    return 1;
  }
  vtksys::SystemInformation system;
  system.RunCPUCheck();
  machine.push_back(std::string(system.GetModelName()) + ", " +
    std::to_string(system.GetNumberOfLogicalCPU()) + " logical processors");

  bool good = true;
  for (const std::string& name : names)
  {
    auto run = std::find_if(
      runs.begin(), runs.end(), [&name](const BenchRun& each) { return each.Name == name; });
    std::cout << name << " ... " << std::flush;
    if (run != runs.end() && IsDone(run->Status, quick))
    {
      std::cout << "done before; without " << RunsFile(folder) << " it is measured again\n";
      continue;
    }
    if (run == runs.end())
    {
      runs.push_back({ name, "", 0. });
      run = runs.end() - 1;
    }
    const auto start = std::chrono::steady_clock::now();
    run->Status = RunOne(program, name, folder, quick);
    run->Seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    good = good && (IsDone(run->Status, quick) || run->Status.rfind(LeftOut, 0) == 0);
    std::cout << run->Status << ", " << Number(run->Seconds, 3) << " s\n" << std::flush;
    if (!WriteRuns(folder, runs) || !WriteSummary(folder, beside, machine, runs))
    {
      return 1;
    }
  }
  if (!WriteSummary(folder, beside, machine, runs))
  {
    return 1;
  }
  std::cout << "summary: " << folder << "/summary.md\n";
  return good ? 0 : 1;
}
}
