// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Check.h"

#include <vtksys/SystemTools.hxx>

#include <atomic>
#include <cmath>
#include <iostream>
#include <sstream>

namespace relievoTest
{
namespace
{
std::atomic<int> FailureCount{ 0 };
}

//------------------------------------------------------------------------------
void Fail(const char* file, int line, const std::string& message)
{
  ++FailureCount;
  std::ostringstream text;
  text << file << ":" << line << ": failed: " << message << "\n";
  std::cerr << text.str() << std::flush;
}

//------------------------------------------------------------------------------
int NumberOfFailures()
{
  return FailureCount;
}

//------------------------------------------------------------------------------
void ForgetFailuresAfter(int count)
{
  if (FailureCount > count)
  {
    std::cerr << "(" << FailureCount - count << " failure(s) above were wanted)\n";
    FailureCount = count;
  }
}

//------------------------------------------------------------------------------
bool Check(bool ok, const char* file, int line, const std::string& message)
{
  if (!ok)
  {
    Fail(file, line, message);
  }
  return ok;
}

//------------------------------------------------------------------------------
bool CheckAtMost(double value, double limit, const char* file, int line, const std::string& what)
{
  std::ostringstream text;
  text << what << ": " << value << " (limit " << limit << ")";
  std::cout << text.str() << std::endl;
  return Check(value <= limit, file, line, text.str());
}

//------------------------------------------------------------------------------
bool CheckNear(double value, double expected, double tolerance, const char* file, int line,
  const std::string& what)
{
  std::ostringstream text;
  text.precision(17);
  text << what << ": got " << value << ", expected " << expected << " within " << tolerance;
  return Check(std::abs(value - expected) <= tolerance, file, line, text.str());
}

//------------------------------------------------------------------------------
double Larger(double a, double b)
{
  return std::isnan(a) || a >= b ? a : b;
}

//------------------------------------------------------------------------------
std::string OutputFolder()
{
  std::string folder;
  if (!vtksys::SystemTools::GetEnv("RELIEVO_TEST_OUTPUT", folder) || folder.empty())
  {
    folder = vtksys::SystemTools::GetCurrentWorkingDirectory();
  }
  if (!vtksys::SystemTools::MakeDirectory(folder))
  {
    Fail(__FILE__, __LINE__, "the output folder '" + folder + "' cannot be made");
  }
  return folder;
}

//------------------------------------------------------------------------------
std::string DataFile(const std::string& name)
{
  std::string folder;
  vtksys::SystemTools::GetEnv("RELIEVO_DATA", folder);
  const std::string path = folder + "/" + name;
  if (folder.empty() || !vtksys::SystemTools::FileExists(path, true))
  {
    Fail(__FILE__, __LINE__,
      "no mesh " + name + " in RELIEVO_DATA='" + folder + "': run tools/unpack-data FOLDER");
    return std::string();
  }
  return path;
}
}
