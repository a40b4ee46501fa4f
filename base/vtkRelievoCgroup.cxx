// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoCgroup.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <sstream>

namespace relievo
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

// The number at the beginning of a file, or after a word in it; otherwise the default.
double NumberIn(const std::string& path, const std::string& word, double otherwise)
{
  std::ifstream file(path);
  double number = otherwise;
  std::string first;
  if (word.empty())
  {
    return file >> number ? number : otherwise;
  }
  while (file >> first >> number)
  {
    if (first == word)
    {
      return number;
    }
  }
  return otherwise;
}

// The free memory of the control group of a folder.
double FreeIn(const std::string& folder, bool second)
{
  const double limit =
    NumberIn(folder + (second ? "/memory.max" : "/memory.limit_in_bytes"), "", Infinity);
  const double used =
    NumberIn(folder + (second ? "/memory.current" : "/memory.usage_in_bytes"), "", 0.);
  const double files =
    NumberIn(folder + "/memory.stat", second ? "inactive_file" : "total_inactive_file", 0.);
  return std::max(limit - std::max(used - files, 0.), 0.);
}
}

//------------------------------------------------------------------------------
double FreeBytesOfCgroup(const std::string& processGroups, const std::string& root)
{
  double free = Infinity;
  std::ifstream groups(processGroups);
  std::string line;
  while (std::getline(groups, line)) // number:controllers:/group/in/group
  {
    std::istringstream parts(line);
    std::string number;
    std::string controllers;
    std::string group;
    std::getline(parts, number, ':');
    std::getline(parts, controllers, ':');
    std::getline(parts, group);
    const bool second = controllers.empty();
    if (!second && ("," + controllers + ",").find(",memory,") == std::string::npos)
    {
      continue;
    }
    const std::string folder = root + (second ? "" : "/memory");
    group = group == "/" ? "" : group;
    while (true)
    {
      free = std::min(free, FreeIn(folder + group, second));
      const std::size_t slash = group.rfind('/');
      if (group.empty() || slash == std::string::npos)
      {
        break;
      }
      group.resize(slash);
    }
  }
  return free;
}
}
