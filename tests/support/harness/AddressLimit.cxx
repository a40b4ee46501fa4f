// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "AddressLimit.h"

#include "Check.h"

#ifdef __linux__
#include <sys/resource.h>
#include <unistd.h>

#include <fstream>
#endif

namespace relievoTest
{
#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__)
const bool AddressLimit::IsUsable = true;
#else
const bool AddressLimit::IsUsable = false;
#endif

//------------------------------------------------------------------------------
AddressLimit::AddressLimit([[maybe_unused]] double bytes)
{
#ifdef __linux__
  rlimit limit = {};
  getrlimit(RLIMIT_AS, &limit);
  this->Before = limit.rlim_cur;
  double pages = 0.;
  std::ifstream("/proc/self/statm") >> pages;
  limit.rlim_cur = static_cast<rlim_t>(pages * static_cast<double>(sysconf(_SC_PAGESIZE)) + bytes);
  RELIEVO_CHECK(pages > 0. && setrlimit(RLIMIT_AS, &limit) == 0);
#endif
}

//------------------------------------------------------------------------------
AddressLimit::~AddressLimit()
{
#ifdef __linux__
  rlimit limit = {};
  getrlimit(RLIMIT_AS, &limit);
  limit.rlim_cur = this->Before;
  setrlimit(RLIMIT_AS, &limit);
#endif
}
}
