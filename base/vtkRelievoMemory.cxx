// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoMemory.h"

#include "vtkRelievoCgroup.h"

#include <vtksys/SystemInformation.hxx>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <limits>

#ifdef __linux__
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace relievo
{
namespace
{
// Address space that the process may still take (ulimit -v).
double FreeAddresses()
{
#ifdef __linux__
  rlimit limit = {};
  double pages = 0.;
  if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY &&
    std::ifstream("/proc/self/statm") >> pages)
  {
    const double used = pages * static_cast<double>(sysconf(_SC_PAGESIZE));
    return std::max(static_cast<double>(limit.rlim_cur) - used, 0.);
  }
#endif
  return std::numeric_limits<double>::infinity();
}

// Infinite if the system does not tell.
double FreeBytes()
{
  vtksys::SystemInformation system;
  double free = std::min(FreeBytesOfCgroup(), FreeAddresses());
  const auto add = [&free](double available, double used) {
    if (available > 0. && used >= 0.)
    {
      free = std::min(free, 1024. * std::max(available - used, 0.));
    }
  };
  add(static_cast<double>(system.GetHostMemoryAvailable()),
    static_cast<double>(system.GetHostMemoryUsed()));
  add(static_cast<double>(system.GetProcMemoryAvailable()),
    static_cast<double>(system.GetProcMemoryUsed()));
  return free;
}

// Formats a number of bytes: "1234567 bytes (1.2 MiB)".
std::string Words(double bytes)
{
  static const char* const units[] = { "KiB", "MiB", "GiB", "TiB", "PiB", "EiB" };
  int unit = 0;
  double size = bytes / 1024.;
  for (; size >= 1024. && unit < 5; ++unit)
  {
    size /= 1024.;
  }
  char words[80];
  std::snprintf(words, sizeof(words), "%.0f bytes (%.1f %s)", bytes, size, units[unit]);
  return words;
}
}

//------------------------------------------------------------------------------
std::string LackOfMemory(double bytes, double limit, double held)
{
  const double room = limit > 0. ? limit : FreeBytes() + held;
  if (bytes <= room)
  {
    return "";
  }
  return "it would take " + Words(bytes) + ", and " +
    (limit > 0. ? "MemoryLimit is " : "the machine has ") + Words(room) +
    (limit > 0. ? "" : " left");
}
}
