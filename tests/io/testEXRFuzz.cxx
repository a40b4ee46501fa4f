// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// A short run of relievo-fuzz-exr: damaged files are read or refused as promised, in little memory.
#include "ExrFuzz.h"
#include "ExrMutator.h"
#include "ExrSeeds.h"

#include "AddressLimit.h"
#include "Check.h"
#include "Session.h"
#include "TestCase.h"

#include <iostream>
#include <optional>

namespace testEXRFuzz
{
namespace
{
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
  std::optional<relievoTest::AddressLimit> limit;
  if (relievoTest::AddressLimit::IsUsable)
  {
    limit.emplace(1 << 30);
  }
  TestMutator();
  TestRun();
  return session.Result();
}
}
