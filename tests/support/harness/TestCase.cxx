// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TestCase.h"

#include "Check.h"

#include <vtkRenderingCoreModule.h>   // the macros of both register
#include <vtkRenderingVolumeModule.h> // object factories

#include <cstdlib>
#include <iostream>
#include <map>
#include <string>

namespace
{
struct Declared
{
  relievoTest::TestCase::Function Function;
  bool Apart;
};

// Cases of one program by name; a local static, since other sources register cases first.
std::map<std::string, Declared>& GetCases()
{
  static std::map<std::string, Declared> cases;
  return cases;
}

int RunAll(const std::string& program, char* argv[])
{
  int failed = 0;
  for (const auto& [name, declared] : GetCases())
  {
    std::cout << "=== " << name << std::endl;
    bool passed = false;
    if (declared.Apart)
    {
      passed = std::system(("'" + program + "' --case " + name).c_str()) == 0;
    }
    else
    {
      char* words[] = { argv[0], nullptr };
      passed = declared.Function(1, words) == 0;
      relievoTest::ForgetFailuresAfter(0);
    }
    std::cout << "=== " << name << (passed ? ": passed" : ": FAILED") << std::endl;
    failed += passed ? 0 : 1;
  }
  std::cout << GetCases().size() - failed << " passed, " << failed << " failed" << std::endl;
  return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
}

namespace relievoTest
{
//------------------------------------------------------------------------------
TestCase::TestCase(const char* name, Function function, bool apart)
{
  GetCases()[name] = { function, apart };
}

//------------------------------------------------------------------------------
bool IsLong(int argc, char* argv[])
{
  return argc > 1 && std::string(argv[1]) == "long";
}
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  const std::string word = argc > 1 ? argv[1] : "";
  if (word == "--all" && argc == 2)
  {
    return RunAll(argv[0], argv);
  }
  if (word == "--case" && argc > 2)
  {
    const auto found = GetCases().find(argv[2]);
    if (found != GetCases().end())
    {
      return found->second.Function(argc - 2, argv + 2);
    }
    std::cerr << argv[0] << ": there is no case '" << argv[2] << "'; --list names them\n";
    return 2;
  }
  if (word == "--list" && argc == 2)
  {
    for (const auto& declared : GetCases())
    {
      std::cout << declared.first << '\n';
    }
    return EXIT_SUCCESS;
  }
  std::cerr << "usage: " << argv[0] << " --case NAME [WORD...] | --all | --list\n";
  return 2;
}
