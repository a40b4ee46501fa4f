// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Failing readers, each in its own process: their failure is reported, and nothing of them is left.
#include "AddressLimit.h"
#include "Check.h"
#include "Session.h"
#include "TestCase.h"

#include <vtkRelievoReaderProcess.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <sys/resource.h>
#include <unistd.h>

namespace testReaderProcess
{
namespace
{
using relievo::ByteReader;
using relievo::ByteWriter;
using Say = vtkRelievoReaderProcess::Say;
using Work = vtkRelievoReaderProcess::Work;

bool GoOn(const std::string&, double)
{
  return true;
}

void AskNothing(ByteWriter&) {}
void TakeNothing(ByteReader&) {}

std::string Run(Work work)
{
  return vtkRelievoReaderProcess::Run(work, AskNothing, GoOn, TakeNothing);
}

//------------------------------------------------------------------------------
// Failures of readers.
void Crash(ByteReader&, const Say&, ByteWriter&)
{
  std::raise(SIGSEGV);
}

// Whose result is needed after the call, so that no compiler makes a loop of it.
int Dive(volatile int* depth)
{
  volatile char room[4096] = {};
  *depth = *depth + 1;
  if (*depth < 0) // which is further than any stack reaches
  {
    return 0;
  }
  return Dive(depth) + room[*depth % 4096];
}

void Overflow(ByteReader&, const Say&, ByteWriter&)
{
  volatile int depth = 0;
  Dive(&depth);
}

void Throw(ByteReader&, const Say&, ByteWriter&)
{
  throw std::length_error("of a library");
}

void Exit(ByteReader&, const Say&, ByteWriter&)
{
  std::exit(0);
}

void Spin(ByteReader&, const Say&, ByteWriter&)
{
  for (volatile unsigned int i = 0;; i = i + 1)
  {
  }
}

// Processor time that takes three seconds of TestTime().
void Compute(ByteReader&, const Say&, ByteWriter&)
{
  while (std::clock() < 5 * CLOCKS_PER_SEC / 4)
  {
  }
}

void Sleep(ByteReader&, const Say&, ByteWriter&)
{
  for (;;)
  {
    pause();
  }
}

// The limit is on memory that was asked for. Filling it would take processor time, which is limited
// too.
void Gorge(ByteReader&, const Say&, ByteWriter&)
{
  std::vector<std::unique_ptr<char[]>> all;
  for (;;)
  {
    all.emplace_back(new char[std::size_t(1) << 30]);
    all.back()[0] = 1;
  }
}

// VTK throws this if malloc() fails, even from noexcept functions.
void LackMemory()
{
  throw std::bad_alloc();
}

void GorgeWithoutThrowing(void (*allocate)()) noexcept
{
  allocate();
}

void GorgeInVTK(ByteReader&, const Say&, ByteWriter&)
{
  GorgeWithoutThrowing(LackMemory);
}

void GetOverIt(ByteReader&, const Say&, ByteWriter& made)
{
  std::string said = "has all";
  try
  {
    const std::vector<char> all(std::size_t(1) << 40);
  }
  catch (const std::bad_alloc&)
  {
    said = "does without";
  }
  made(said);
}

void Echo(ByteReader& asked, const Say& say, ByteWriter& made)
{
  say("reading", 0.25);
  const auto numbers = asked.Get<std::vector<double>>();
  say("writing", 0.75);
  made(numbers, getpid());
}

void Half(ByteReader&, const Say&, ByteWriter& made)
{
  made(std::uint64_t(1000)); // and nothing more
}

void AllowAndCount(ByteReader&, const Say&, ByteWriter& made)
{
  vtkRelievoReaderProcess::Allow(std::uint64_t(1) << 30);
  vtkRelievoReaderProcess::Allow(std::uint64_t(1) << 20);
  rlimit memory = {}, time = {}, core = {};
  getrlimit(RLIMIT_DATA, &memory);
  getrlimit(RLIMIT_CPU, &time);
  getrlimit(RLIMIT_CORE, &core);
  made(static_cast<std::uint64_t>(memory.rlim_cur), static_cast<std::uint64_t>(time.rlim_cur));
}

//------------------------------------------------------------------------------
std::size_t CountFiles()
{
  const std::filesystem::directory_iterator open("/proc/self/fd");
  return static_cast<std::size_t>(std::distance(begin(open), end(open)));
}

// The processes whose parent is this one.
std::vector<int> FindChildren(int parent)
{
  std::vector<int> found;
  for (const auto& each : std::filesystem::directory_iterator("/proc"))
  {
    const std::string number = each.path().filename().string();
    const bool isProcess = number.find_first_not_of("0123456789") == std::string::npos;
    std::ifstream file(isProcess ? each.path() / "stat" : std::filesystem::path());
    const std::string text{ std::istreambuf_iterator<char>(file), {} };
    const std::size_t name = text.rfind(')'); // which may have anything in it
    char state = 0;
    int its = 0;
    if (name != std::string::npos &&
      std::sscanf(text.c_str() + name, ") %c %d", &state, &its) == 2 && its == parent)
    {
      found.push_back(std::stoi(number));
    }
  }
  return found;
}

bool WaitFor(const std::function<bool()>& condition)
{
  for (int i = 0; i < 60000 && !condition(); ++i) // against hanging alone
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return condition();
}

//------------------------------------------------------------------------------
void TestEnds()
{
  const struct
  {
    Work Does;
    const char* Said;
    bool IsPossible = true;
  } rows[] = {
    { Crash, "crashed (segmentation fault)" },
    { Overflow, "crashed (segmentation fault)" },
    { Throw, "crashed (aborted)" },
    { Exit, "ended early" },
    { Gorge, "used more than 8 GiB of memory", relievoTest::AddressLimit::IsUsable },
    { GorgeInVTK, "used more than 8 GiB of memory" },
  };
  for (const auto& row : rows)
  {
    if (!row.IsPossible)
    {
      continue;
    }
    const std::string said = Run(row.Does);
    RELIEVO_CHECK_THAT(said == row.Said, "got '" + said + "', expected '" + row.Said + "'");
    RELIEVO_CHECK(FindChildren(vtkRelievoReaderProcess::GetProcess()).empty());
  }
  std::string text;
  const std::string end = vtkRelievoReaderProcess::Run(
    GetOverIt, AskNothing, GoOn, [&text](ByteReader& made) { made(text); });
  RELIEVO_CHECK(end.empty() && text == "does without");
  const std::string half = vtkRelievoReaderProcess::Run(
    Half, AskNothing, GoOn, [](ByteReader& made) { made.Get<std::vector<double>>(); });
  RELIEVO_CHECK_THAT(half.find("damaged") != std::string::npos, half);
}

// Large ones, with the steps between, in several threads at once.
void TestAnswers()
{
  const std::size_t files = CountFiles();
  std::vector<std::thread> threads;
  std::vector<int> processes(4, 0);
  std::vector<char> right(4, 0);
  for (std::size_t i = 0; i < processes.size(); ++i)
  {
    threads.emplace_back([&, i] {
      const std::vector<double> numbers(1000000 * i, 0.5 + static_cast<double>(i));
      std::vector<double> back;
      std::vector<std::string> steps;
      const std::string end = vtkRelievoReaderProcess::Run(
        Echo, [&](ByteWriter& asked) { asked(numbers); },
        [&](const std::string& what, double share) {
          if (!what.empty() && (steps.empty() || steps.back() != what + std::to_string(share)))
          {
            steps.push_back(what + std::to_string(share));
          }
          return true;
        },
        [&](ByteReader& made) { made(back, processes[i]); });
      right[i] = end.empty() && back == numbers &&
        steps == std::vector<std::string>{ "reading0.250000", "writing0.750000" };
    });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  for (std::size_t i = 0; i < processes.size(); ++i)
  {
    RELIEVO_CHECK(right[i] && processes[i] != getpid());
    RELIEVO_CHECK(i == 0 || processes[i] != processes[i - 1]);
  }
  RELIEVO_CHECK(CountFiles() == files);
  RELIEVO_CHECK(FindChildren(vtkRelievoReaderProcess::GetProcess()).empty());
  RELIEVO_CHECK(FindChildren(getpid()).size() == 1);
}

void TestStop()
{
  int looks = 0;
  const auto began = std::chrono::steady_clock::now();
  const std::string end = vtkRelievoReaderProcess::Run(
    Sleep, AskNothing, [&looks](const std::string&, double) { return ++looks < 3; }, TakeNothing);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
  RELIEVO_CHECK_THAT(end == "was stopped", end);
  RELIEVO_CHECK_AT_MOST(took.count(), 10., "seconds until it stopped");
  RELIEVO_CHECK(
    WaitFor([] { return FindChildren(vtkRelievoReaderProcess::GetProcess()).empty(); }));
}

void TestLimits()
{
  std::uint64_t memory = 0, time = 0;
  const std::string end = vtkRelievoReaderProcess::Run(
    AllowAndCount, AskNothing, GoOn, [&](ByteReader& made) { made(memory, time); });
  const std::uint64_t size = (std::uint64_t(1) << 30) + (std::uint64_t(1) << 20);
  RELIEVO_CHECK(end.empty());
  RELIEVO_CHECK(memory == (std::uint64_t(8) << 30) + 32 * size);
  RELIEVO_CHECK(time == 15 + 2 * 1025);
}

// One that computes without end, and one that waits; and one that is given a processor for less
// than half of the time, which is no waiting.
void TestTime()
{
  vtkRelievoReaderProcess::SetLimits(1, 2);
  const std::string spun = Run(Spin);
  const std::string slept = Run(Sleep);
  RELIEVO_CHECK_THAT(spun == "did not end within 1 s of processor time", spun);
  RELIEVO_CHECK_THAT(slept == "waited for more than 2 s", slept);

  vtkRelievoReaderProcess::SetLimits(15, 1);
  std::atomic<bool> busy(true);
  std::vector<std::thread> others;
  for (unsigned int i = 0; i < 2 * std::thread::hardware_concurrency(); ++i)
  {
    others.emplace_back([&busy] {
      while (busy)
      {
      }
    });
  }
  const std::string computed = Run(Compute);
  busy = false;
  for (std::thread& other : others)
  {
    other.join();
  }
  RELIEVO_CHECK_THAT(computed.empty(), computed);
  vtkRelievoReaderProcess::SetLimits(15, 60);
}

// The process that forks the others has ended: this is reported, with a remedy.
void TestGone()
{
  std::string killed;
  std::thread waiting([&killed] { killed = Run(Sleep); });
  RELIEVO_CHECK(
    WaitFor([] { return !FindChildren(vtkRelievoReaderProcess::GetProcess()).empty(); }));
  const std::vector<int> workers = FindChildren(vtkRelievoReaderProcess::GetProcess());
  kill(workers.front(), SIGKILL);
  waiting.join();
  RELIEVO_CHECK_THAT(killed.find("ended by the system") != std::string::npos, killed);

  kill(vtkRelievoReaderProcess::GetProcess(), SIGKILL);
  for (int i = 0; i < 2; ++i)
  {
    const std::string gone = Run(Crash);
    RELIEVO_CHECK_THAT(gone.find("start the program again") != std::string::npos, gone);
  }
  RELIEVO_CHECK(WaitFor([] {
    Run(Crash);
    return FindChildren(getpid()).empty();
  }));
}
}

RELIEVO_TEST_CASE_APART(testReaderProcess)
{
  setenv("RELIEVO_READ_HERE", "1", 1);
  RELIEVO_CHECK(!vtkRelievoReaderProcess::IsThere());
  RELIEVO_CHECK(vtkRelievoReaderProcess::Start() && vtkRelievoReaderProcess::IsThere());
  relievoTest::Session session;
  TestEnds();
  TestAnswers();
  TestStop();
  if (relievoTest::AddressLimit::IsUsable)
  {
    TestLimits();
  }
  TestTime();
  TestGone();
  return session.Result();
}
}
