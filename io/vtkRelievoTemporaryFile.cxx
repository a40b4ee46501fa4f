// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoTemporaryFile.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <vector>

#ifndef _WIN32
#include <poll.h>
#include <unistd.h>
#endif

namespace
{
// Names of all existing files. Never destroyed; changed only while the lock is held.
std::vector<std::string>* const Names = new std::vector<std::string>;
std::atomic_flag Locked = ATOMIC_FLAG_INIT;
thread_local int Holds = 0; // locks held by this thread

#ifdef _WIN32
int GetProcess()
{
  return 1;
}

void Wait() {}
#else
constexpr int Ending[] = { SIGHUP, SIGINT, SIGQUIT, SIGPIPE, SIGALRM, SIGTERM, SIGUSR1, SIGUSR2,
  SIGVTALRM, SIGXCPU };
thread_local sigset_t Before; // signal mask of this thread before blocking

int GetProcess()
{
  return static_cast<int>(getpid());
}

void Wait()
{
  poll(nullptr, 0, 1); // a millisecond; allowed in signal handlers
}

extern "C" void RemoveAndEnd(int signal)
{
  vtkRelievoTemporaryFile::RemoveAll();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}
#endif

// The process that owns the files, excluding forks. 0: not one of our programs.
int Process = 0;
std::atomic<bool> Removed(false);

// Waits for a limited time: the process may have been forked while another thread held the lock.
bool Lock()
{
  constexpr int patience = 5000; // milliseconds
  for (int i = 0; i < patience; ++i)
  {
    if (!Locked.test_and_set(std::memory_order_acquire))
    {
      return true;
    }
    Wait();
  }
  return false;
}
}

//------------------------------------------------------------------------------
vtkRelievoTemporaryFile::Uninterrupted::Uninterrupted()
{
  if (Holds++ > 0)
  {
    return;
  }
#ifndef _WIN32
  // Before locking: a signal handler in this thread would wait for this thread's own lock.
  sigset_t ending;
  sigemptyset(&ending);
  for (const int signal : Ending)
  {
    sigaddset(&ending, signal);
  }
  pthread_sigmask(SIG_BLOCK, &ending, &Before);
#endif
  Lock();
}

//------------------------------------------------------------------------------
vtkRelievoTemporaryFile::Uninterrupted::~Uninterrupted()
{
  if (--Holds > 0)
  {
    return;
  }
  Locked.clear(std::memory_order_release);
#ifndef _WIN32
  pthread_sigmask(SIG_SETMASK, &Before, nullptr);
#endif
}

//------------------------------------------------------------------------------
vtkRelievoTemporaryFile::vtkRelievoTemporaryFile(
  const std::string& folder, std::error_code& trouble, const char* extension)
{
  constexpr int tries = 16;
  std::random_device random;
  const Uninterrupted whole;
  std::FILE* file = nullptr;
  for (int i = 0; i < tries && !file; ++i)
  {
    char name[64];
    std::snprintf(name, sizeof(name), ".relievo-%08x%08x%s", random(), random(), extension);
    this->Name = (std::filesystem::path(folder) / name).string();
    file = std::fopen(this->Name.c_str(), "wbx"); // x: fails if the name exists, even as a link
    if (!file && errno != EEXIST)
    {
      break;
    }
  }
  if (!file)
  {
    trouble = std::error_code(errno, std::generic_category());
    this->Name.clear();
    return;
  }
  std::fclose(file);
  Names->push_back(this->Name);
  trouble.clear();
}

//------------------------------------------------------------------------------
vtkRelievoTemporaryFile::~vtkRelievoTemporaryFile()
{
  if (!this->Name.empty())
  {
    const Uninterrupted whole;
    std::remove(this->Name.c_str());
    Names->erase(std::remove(Names->begin(), Names->end(), this->Name), Names->end());
  }
}

//------------------------------------------------------------------------------
void vtkRelievoTemporaryFile::MoveTo(const std::string& place, std::error_code& trouble)
{
  const Uninterrupted whole;
  std::filesystem::rename(this->Name, place, trouble);
  if (!trouble)
  {
    Names->erase(std::remove(Names->begin(), Names->end(), this->Name), Names->end());
    this->Name.clear();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoTemporaryFile::RemoveAtEnd()
{
  Process = GetProcess();
  std::atexit(RemoveAll);
#ifndef _WIN32
  for (const int signal : Ending)
  {
    struct sigaction now = {};
    if (sigaction(signal, nullptr, &now) == 0 &&
      now.sa_handler != SIG_IGN) // ignored, for example by nohup
    {
      now = {};
      now.sa_handler = RemoveAndEnd;
      sigfillset(&now.sa_mask);
      sigaction(signal, &now, nullptr);
    }
  }
#endif
}

//------------------------------------------------------------------------------
void vtkRelievoTemporaryFile::RemoveAll()
{
  // Keeps the lock: nothing is begun or moved while the program ends.
  if (Process == 0 || Process != GetProcess() || Removed || !Lock())
  {
    return;
  }
  for (const std::string& name : *Names)
  {
    std::remove(name.c_str());
  }
  Removed = true;
}
