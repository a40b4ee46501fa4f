// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Ranks.h"

#include "Check.h"

#include <vtkCommunicator.h>
#include <vtkDataArray.h>
#include <vtkDummyController.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <string>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace relievoTest
{
namespace
{
long long BytesSent = 0;

// A failure here would leave the others waiting: closed sockets end them as well.
[[noreturn]] void GiveUp(const std::string& why)
{
  std::cerr << "process " << getpid() << ": " << why << std::endl;
  _exit(2);
}

void WriteAll(int to, const void* data, std::size_t length)
{
  const char* from = static_cast<const char*>(data);
  while (length > 0)
  {
    const ssize_t written = write(to, from, length);
    if (written <= 0)
    {
      GiveUp("another process has gone");
    }
    from += written;
    length -= static_cast<std::size_t>(written);
  }
}

bool ReadAll(int from, void* data, std::size_t length)
{
  char* to = static_cast<char*>(data);
  while (length > 0)
  {
    const ssize_t got = read(from, to, length);
    if (got <= 0)
    {
      return false;
    }
    to += got;
    length -= static_cast<std::size_t>(got);
  }
  return true;
}

struct Head
{
  vtkIdType Length;
  int Type;
  int Tag;
};

// VTK builds all collective calls on these two.
class Sockets : public vtkCommunicator
{
public:
  static Sockets* New();
  vtkTypeMacro(Sockets, vtkCommunicator);

  void Set(int rank, const std::vector<int>& sockets)
  {
    this->LocalProcessId = rank;
    this->NumberOfProcesses = this->MaximumNumberOfProcesses = static_cast<int>(sockets.size());
    this->Each = sockets;
  }

  int SendVoidArray(
    const void* data, vtkIdType length, int type, int remoteHandle, int tag) override
  {
    const Head head = { length, type, tag };
    const auto bytes = static_cast<std::size_t>(length * vtkDataArray::GetDataTypeSize(type));
    WriteAll(this->Each[remoteHandle], &head, sizeof(head));
    WriteAll(this->Each[remoteHandle], data, bytes);
    BytesSent += static_cast<long long>(bytes);
    return 1;
  }

  int ReceiveVoidArray(
    void* data, vtkIdType maxlength, int type, int remoteHandle, int tag) override
  {
    Head head;
    if (!ReadAll(this->Each[remoteHandle], &head, sizeof(head)))
    {
      GiveUp("process " + std::to_string(remoteHandle) + " has gone");
    }
    if (head.Type != type || head.Tag != tag || head.Length > maxlength)
    {
      GiveUp("process " + std::to_string(remoteHandle) + " makes another collective call: type " +
        std::to_string(head.Type) + ", tag " + std::to_string(head.Tag) + ", length " +
        std::to_string(head.Length) + " in place of " + std::to_string(type) + ", " +
        std::to_string(tag) + ", " + std::to_string(maxlength));
    }
    this->Count = head.Length;
    const auto bytes = static_cast<std::size_t>(head.Length * vtkDataArray::GetDataTypeSize(type));
    return ReadAll(this->Each[remoteHandle], data, bytes) ? 1 : 0;
  }

private:
  std::vector<int> Each;
};
vtkStandardNewMacro(Sockets);

[[noreturn]] void Work(int rank, const std::vector<int>& sockets, int result,
  const std::function<std::vector<float>(vtkMultiProcessController*)>& work)
{
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  const int before = NumberOfFailures();
  {
    vtkNew<Sockets> communicator;
    communicator->Set(rank, sockets);
    vtkNew<vtkDummyController> controller;
    controller->SetCommunicator(communicator);
    controller->SetRMICommunicator(communicator);
    const std::vector<float> numbers = work(controller);
    const std::size_t count = numbers.size();
    WriteAll(result, &count, sizeof(count));
    WriteAll(result, numbers.data(), count * sizeof(float));
  }
  std::cout.flush();
  _exit(NumberOfFailures() > before ? 1 : 0);
}

std::vector<float> ComposeNearest(const std::vector<std::vector<float>>& parts, int values)
{
  std::vector<float> all = parts[0];
  const auto step = static_cast<std::size_t>(values);
  for (const std::vector<float>& part : parts)
  {
    for (std::size_t i = 0; i + step <= std::min(all.size(), part.size()); i += step)
    {
      if (part[i] < all[i])
      {
        std::copy_n(part.begin() + static_cast<std::ptrdiff_t>(i), step,
          all.begin() + static_cast<std::ptrdiff_t>(i));
      }
    }
  }
  return all;
}
}

//------------------------------------------------------------------------------
long long GetBytesSent()
{
  return BytesSent;
}

//------------------------------------------------------------------------------
std::vector<std::vector<float>> RunRanks(
  int ranks, const std::function<std::vector<float>(vtkMultiProcessController*)>& work)
{
  std::cout.flush();
  std::signal(SIGPIPE, SIG_IGN);
  std::vector<std::vector<int>> sockets(ranks, std::vector<int>(ranks, -1));
  std::vector<int> all;
  const auto connect = [&all](int& a, int& b) {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends) != 0)
    {
      GiveUp("no sockets");
    }
    a = ends[0];
    b = ends[1];
    all.insert(all.end(), { a, b });
  };
  for (int i = 0; i < ranks; ++i)
  {
    for (int j = 0; j < i; ++j)
    {
      connect(sockets[i][j], sockets[j][i]);
    }
  }
  std::vector<int> results(ranks, -1);
  std::vector<pid_t> processes(ranks, -1);
  for (int i = 0; i < ranks; ++i)
  {
    int result = -1;
    connect(results[i], result);
    processes[i] = fork();
    if (processes[i] == 0)
    {
      for (const int end : all) // notices processes that have gone
      {
        const bool own =
          end == result || std::find(sockets[i].begin(), sockets[i].end(), end) != sockets[i].end();
        if (!own)
        {
          close(end);
        }
      }
      Work(i, sockets[i], result, work);
    }
    close(result);
    all.pop_back();
  }
  std::vector<std::vector<float>> numbers(ranks);
  for (const int end : all)
  {
    if (std::find(results.begin(), results.end(), end) == results.end())
    {
      close(end);
    }
  }
  for (int i = 0; i < ranks; ++i)
  {
    std::size_t count = 0;
    if (processes[i] > 0 && ReadAll(results[i], &count, sizeof(count)))
    {
      numbers[i].resize(count);
      ReadAll(results[i], numbers[i].data(), count * sizeof(float));
    }
    close(results[i]);
  }
  for (int i = 0; i < ranks; ++i)
  {
    int status = 0;
    const bool ended = processes[i] > 0 && waitpid(processes[i], &status, 0) == processes[i];
    RELIEVO_CHECK_THAT(ended && WIFEXITED(status) && WEXITSTATUS(status) == 0,
      "process " + std::to_string(i) + " of " + std::to_string(ranks) + " has failed");
  }
  return numbers;
}

//------------------------------------------------------------------------------
void CompareRanks(const std::function<std::vector<float>(vtkMultiProcessController*)>& work,
  int values, std::size_t size,
  const std::function<void(int ranks, const float* one, const float* several)>& compare)
{
  const std::vector<float> one = ComposeNearest(RunRanks(1, work), values);
  RELIEVO_CHECK(one.size() == size);
  for (const int ranks : { 2, 4 })
  {
    const std::vector<float> several = ComposeNearest(RunRanks(ranks, work), values);
    if (RELIEVO_CHECK(several.size() == size) && one.size() == size)
    {
      compare(ranks, one.data(), several.data());
    }
  }
}
}
