// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scripts.h"

#include "Rounds.h"

#include <vtksys/Process.h>
#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <limits>
#include <system_error>

namespace relievoBench
{
namespace
{
constexpr char Folder[] = RELIEVO_BENCH_SCRIPTS;
constexpr char Package[] = RELIEVO_BENCH_PACKAGE; // the folder of this build's package relievo
constexpr char Python[] = RELIEVO_CHARTS_PYTHON;

std::vector<std::string>& Further()
{
  static std::vector<std::string> words;
  return words;
}

int Refuse(const std::string& script, const std::string& why)
{
  std::cerr << "relievo: bench: " << script << ": " << why << '\n';
  return 1;
}
}

//------------------------------------------------------------------------------
void SetScriptWords(const std::vector<std::string>& words)
{
  Further() = words;
}

//------------------------------------------------------------------------------
bool IsScriptHelp()
{
  return std::any_of(Further().begin(), Further().end(),
    [](const std::string& word) { return word == "--help" || word == "-h"; });
}

//------------------------------------------------------------------------------
std::string FindWhyNot(const std::string& script)
{
  const std::string path = std::string(Folder) + "/" + script;
  if (!vtksys::SystemTools::FileExists(path, true))
  {
    return "there is no " + path + "; it belongs to Relievo's sources";
  }
  if (vtksys::SystemTools::FindProgram(Python).empty())
  {
    return std::string("there is no Python at ") + Python +
      ", with which this build was configured";
  }
  return {};
}

//------------------------------------------------------------------------------
int RunScript(const std::string& script, const std::vector<ScriptWord>& given,
  const std::string& table, const std::vector<std::string>& quick)
{
  const std::string whyNot = FindWhyNot(script);
  if (!whyNot.empty())
  {
    return Refuse(script, whyNot);
  }
  if (!vtksys::SystemTools::FileIsDirectory(std::string(Package) + "/relievo"))
  {
    std::cout << "bench: this build has no package relievo (target relievo_python); " << script
              << " takes that of " << Python << ", if there is one\n";
  }
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  std::string data;
  vtksys::SystemTools::GetEnv("RELIEVO_DATA", data);
  std::vector<std::string> words;
  for (const ScriptWord& word : given)
  {
    const auto* place = std::get_if<ScriptPlace>(&word);
    if (place && *place == ScriptPlace::Data && data.empty() && !IsScriptHelp())
    {
      return Refuse(script, "set RELIEVO_DATA to the folder that tools/unpack-data fills");
    }
    words.push_back(!place               ? std::get<std::string>(word)
        : *place == ScriptPlace::Relievo ? program.string()
                                         : data);
  }
  if (GetRounds(std::numeric_limits<int>::max()) < std::numeric_limits<int>::max())
  {
    words.insert(words.end(), quick.begin(), quick.end());
  }
  words.insert(words.end(), Further().begin(), Further().end());
  std::string packages;
  vtksys::SystemTools::GetEnv("PYTHONPATH", packages);
  vtksys::SystemTools::PutEnv(
    std::string("PYTHONPATH=") + Package + (packages.empty() ? "" : ":" + packages));
  const std::string path = std::string(Folder) + "/" + script;
  std::vector<const char*> command = { Python, path.c_str() };
  for (const std::string& word : words)
  {
    command.push_back(word.c_str());
  }
  command.push_back(nullptr);
  vtksysProcess* process = vtksysProcess_New();
  vtksysProcess_SetCommand(process, command.data());
  vtksysProcess_SetPipeShared(process, vtksysProcess_Pipe_STDERR, 1);
  const bool isTable = !table.empty() && !IsScriptHelp();
  const std::string part = table + ".part"; // so that a failure keeps an older table
  isTable ? void(vtksysProcess_SetPipeFile(process, vtksysProcess_Pipe_STDOUT, part.c_str()))
          : vtksysProcess_SetPipeShared(process, vtksysProcess_Pipe_STDOUT, 1);
  std::cout << std::flush; // before what the script says
  vtksysProcess_Execute(process);
  vtksysProcess_WaitForExit(process, nullptr);
  std::string failure;
  int status = 1;
  switch (vtksysProcess_GetState(process))
  {
    case vtksysProcess_State_Exited:
      status = vtksysProcess_GetExitValue(process);
      failure = status == 0        ? ""
        : status == MissingPackage ? "a package that it needs cannot be imported"
                                   : "it ended with status " + std::to_string(status);
      break;
    case vtksysProcess_State_Exception:
      failure = std::string("it crashed: ") + vtksysProcess_GetExceptionString(process);
      break;
    default:
      failure = std::string("it did not start: ") + vtksysProcess_GetErrorString(process);
  }
  vtksysProcess_Delete(process);
  vtksys::SystemTools::PutEnv("PYTHONPATH=" + packages);
  if (isTable && failure.empty())
  {
    std::filesystem::rename(part, table, error);
    failure = error ? "cannot write " + table + ": " + error.message() : "";
  }
  if (isTable && !failure.empty())
  {
    std::filesystem::remove(part, error);
  }
  const int refused = failure.empty() ? 0 : Refuse(script, failure);
  return refused != 0 && status == MissingPackage ? MissingPackage : refused;
}
}
