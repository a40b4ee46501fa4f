// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// A short run of relievo-fuzz-exr: damaged files are read or refused as promised, in little memory.
#include "ExrFuzz.h"
#include "ExrMutator.h"
#include "ExrSeeds.h"

#include "Check.h"
#include "Session.h"
#include "TestCase.h"

#include <sys/resource.h>

#include <fstream>
#include <iostream>

namespace testEXRFuzz
{
namespace
{
// From here on this process may take 1 GiB of addresses more. Sanitizers need more than that.
void LimitMemory()
{
#ifndef __SANITIZE_ADDRESS__
  std::ifstream statm("/proc/self/statm");
  rlim_t pages = 0;
  statm >> pages;
  struct rlimit limit;
  getrlimit(RLIMIT_AS, &limit);
  limit.rlim_cur = pages * 4096 + (rlim_t(1) << 30);
  RELIEVO_CHECK(pages > 0 && setrlimit(RLIMIT_AS, &limit) == 0);
#endif
}

void TestMutator()
{
  const std::vector<std::string> seeds = exrFuzz::MakeSeeds(relievoTest::OutputFolder());
  const exrFuzz::Mutator mutator(seeds);
  int same = 0;
  for (int i = 0; i < 100; ++i)
  {
    RELIEVO_CHECK(mutator.Make(i) == mutator.Make(i));
    same += mutator.Make(i) == mutator.Make(i + 1);
  }
  RELIEVO_CHECK(same == 0);
}

void TestRun()
{
  const uint64_t count = 4000;
  const exrFuzz::Result result =
    exrFuzz::Run(0, count, relievoTest::OutputFolder(), 10.0, [](uint64_t) {});
  std::cout << result.Read << " read, " << result.Refused << " refused, slowest "
            << result.SlowestSeconds << " s\n";
  for (const std::string& fault : result.Faults)
  {
    RELIEVO_CHECK_THAT(false, fault);
  }
  RELIEVO_CHECK(result.Read + result.Refused == count);
  // Both happen often, or the damage is of no use.
  RELIEVO_CHECK(result.Read > count / 20 && result.Refused > count / 2);
}
}

RELIEVO_TEST_CASE_APART(testEXRFuzz)
{
  relievoTest::Session session;
  LimitMemory();
  TestMutator();
  TestRun();
  return session.Result();
}
}
