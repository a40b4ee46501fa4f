// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoReaderProcess.h"

#ifdef __linux__
#include "vtkObject.h"
#include "vtkSetGet.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <chrono>
#include <cinttypes>
#include <climits>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <exception>
#include <fstream>
#include <memory>
#include <mutex>
#include <new>
#include <stdexcept>
#include <utility>
#include <vector>

#include <dlfcn.h>
#include <fcntl.h>
#include <link.h>
#include <poll.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace
{
constexpr std::uint64_t Memory = std::uint64_t(8) << 30;
constexpr std::uint64_t MemoryOfMiB = std::uint64_t(32) << 20;
constexpr std::uint64_t SecondsOfMiB = 2; // of processor time and of waiting
std::uint64_t ProcessorSeconds = 15;
std::uint64_t WaitingSeconds = 60;

// A file descriptor, closed by the destructor.
class Descriptor
{
public:
  explicit Descriptor(int number = -1)
    : Number(number)
  {
  }
  ~Descriptor() { this->Close(); }
  Descriptor(const Descriptor&) = delete;
  void operator=(const Descriptor&) = delete;

  void Close()
  {
    if (this->Number >= 0)
    {
      close(this->Number);
    }
    this->Number = -1;
  }
  void Take(int number)
  {
    this->Close();
    this->Number = number;
  }
  int Release() { return std::exchange(this->Number, -1); }
  int Get() const { return this->Number; }
  explicit operator bool() const { return this->Number >= 0; }

private:
  int Number;
};

// Two connected sockets, never with the descriptor of a closed standard stream: printed text must
// not go into a socket.
bool Connect(int kind, Descriptor& ours, Descriptor& its)
{
  int ends[2];
  if (socketpair(AF_UNIX, kind | SOCK_CLOEXEC, 0, ends) != 0)
  {
    return false;
  }
  ours.Take(ends[0]);
  its.Take(ends[1]);
  for (Descriptor* end : { &ours, &its })
  {
    if (end->Get() <= STDERR_FILENO)
    {
      end->Take(fcntl(end->Get(), F_DUPFD_CLOEXEC, STDERR_FILENO + 1));
    }
  }
  return ours && its;
}

// Messages about the work in progress, sent in packets.
struct Note
{
  enum Kinds : int
  {
    Progress,
    Began,    // Status: the process's number
    Opened,   // Size
    NoMemory, // the reader may still succeed
    Whole,    // the result of Size bytes is complete
    Ended,    // the process ended with Status
    Refused   // no process; Text has the reason
  };
  Kinds Kind = Progress;
  int Status = 0; // exit status of the process, or its number
  std::uint64_t Size = 0;
  double Share = 0.;
  char Text[5000] = "";
};

struct Request
{
  vtkRelievoReaderProcess::Work Work = nullptr;
  // The library that contains the work, and the work's offset in it, for a server that is no fork
  // of the program and has other addresses.
  char Library[PATH_MAX] = "";
  std::uint64_t Place = 0;
  // Bytes of the request, which arrive through the first socket; the result returns through it.
  std::uint64_t Size = 0;
  std::uint64_t ProcessorSeconds = 0;
};

int Server = -1; // the program's socket to the process; -1: none
pid_t Process = 0;
bool Forked = false;   // the process is a fork of the program
bool Searched = false; // for the program relievo-reader
uid_t User = 0;        // user of the server
gid_t Group = 0;
std::mutex Starting;
int Line = -1;            // during a work: to the program
std::uint64_t Opened = 0; // during a work: bytes of files

//------------------------------------------------------------------------------
// Collects the bytes from a socket in contiguous memory.
class Buffer
{
public:
  Buffer() = default;
  ~Buffer() { std::free(this->Bytes); }
  Buffer(const Buffer&) = delete;
  void operator=(const Buffer&) = delete;

  // Waits for some bytes, at most `most`. False at the end.
  bool Receive(int socket, std::size_t most)
  {
    constexpr std::size_t step = 1 << 20;
    if (this->Size == this->Room)
    {
      const std::size_t room = std::max(2 * this->Room, step);
      void* grown = std::realloc(this->Bytes, room); // moves pages instead of bytes
      if (!grown)
      {
        throw std::bad_alloc();
      }
      this->Bytes = static_cast<char*>(grown);
      this->Room = room;
    }
    ssize_t got = -1;
    do
    {
      got = recv(socket, this->Bytes + this->Size, std::min(most, this->Room - this->Size), 0);
    } while (got < 0 && errno == EINTR);
    this->Size += static_cast<std::size_t>(std::max<ssize_t>(got, 0));
    return got > 0;
  }

  const char* Get() const { return this->Bytes; }
  std::size_t GetSize() const { return this->Size; }

private:
  char* Bytes = nullptr;
  std::size_t Size = 0;
  std::size_t Room = 0;
};

// False if the other end is closed.
bool SendBytes(int socket, const char* bytes, std::size_t size)
{
  while (size > 0)
  {
    const ssize_t sent = send(socket, bytes, size, MSG_NOSIGNAL);
    if (sent < 0 && errno != EINTR)
    {
      return false;
    }
    bytes += std::max<ssize_t>(sent, 0);
    size -= static_cast<std::size_t>(std::max<ssize_t>(sent, 0));
  }
  return true;
}

//------------------------------------------------------------------------------
bool Send(int line, const Note& note)
{
  ssize_t sent = -1;
  do
  {
    sent = send(line, &note, sizeof note, MSG_NOSIGNAL);
  } while (sent < 0 && errno == EINTR);
  return sent == sizeof note;
}

// False at the end.
bool Receive(int line, Note& note)
{
  ssize_t got = -1;
  do
  {
    got = recv(line, &note, sizeof note, 0);
  } while (got < 0 && errno == EINTR);
  note.Text[sizeof note.Text - 1] = '\0';
  return got == sizeof note;
}

// The socket for request and result, the line for notes, and the folder of relative paths.
constexpr std::size_t FilesSent = 3;

bool SendRequest(int server, Request& request, const std::array<int, FilesSent>& files)
{
  iovec data = { &request, sizeof request };
  alignas(cmsghdr) char control[CMSG_SPACE(sizeof files)] = {};
  msghdr message = {};
  message.msg_iov = &data;
  message.msg_iovlen = 1;
  message.msg_control = control;
  message.msg_controllen = sizeof control;
  cmsghdr* header = CMSG_FIRSTHDR(&message);
  header->cmsg_level = SOL_SOCKET;
  header->cmsg_type = SCM_RIGHTS;
  header->cmsg_len = CMSG_LEN(sizeof files);
  std::memcpy(CMSG_DATA(header), files.data(), sizeof files);
  ssize_t sent = -1;
  do
  {
    sent = sendmsg(server, &message, MSG_NOSIGNAL);
  } while (sent < 0 && errno == EINTR);
  return sent == sizeof request;
}

bool ReceiveRequest(
  int server, Request& request, Descriptor& bytes, Descriptor& line, Descriptor& folder)
{
  iovec data = { &request, sizeof request };
  std::array<int, FilesSent> files = {};
  alignas(cmsghdr) char control[CMSG_SPACE(sizeof files)] = {};
  msghdr message = {};
  message.msg_iov = &data;
  message.msg_iovlen = 1;
  message.msg_control = control;
  message.msg_controllen = sizeof control;
  ssize_t got = -1;
  do
  {
    got = recvmsg(server, &message, MSG_CMSG_CLOEXEC);
  } while (got < 0 && errno == EINTR);
  const cmsghdr* header = got == sizeof request ? CMSG_FIRSTHDR(&message) : nullptr;
  if (!header || header->cmsg_len != CMSG_LEN(sizeof files))
  {
    return false;
  }
  std::memcpy(files.data(), CMSG_DATA(header), sizeof files);
  bytes.Take(files[0]);
  line.Take(files[1]);
  folder.Take(files[2]);
  return true;
}

//------------------------------------------------------------------------------
// The absolute path of the file that was loaded at an address; empty if another file has replaced
// it since, as after an update. The dynamic linker's name may be relative to a former folder.
std::string FindLoadedFile(const void* address)
{
  const auto at = reinterpret_cast<std::uintptr_t>(address);
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);)
  {
    std::uintptr_t begin = 0, end = 0;
    const bool has = std::sscanf(line.c_str(), "%" SCNxPTR "-%" SCNxPTR, &begin, &end) == 2 &&
      begin <= at && at < end;
    const std::size_t path = has ? line.find('/') : std::string::npos;
    if (path != std::string::npos) // the kernel adds " (deleted)" to a replaced file's
    {
      return access(line.c_str() + path, R_OK) == 0 ? line.substr(path) : "";
    }
  }
  return "";
}

// Returns an error message, or an empty string.
std::string FindPlace(vtkRelievoReaderProcess::Work work, Request& request)
{
  Dl_info about;
  link_map* library = nullptr;
  void* const address = reinterpret_cast<void*>(work);
  if (!dladdr1(address, &about, reinterpret_cast<void**>(&library), RTLD_DL_LINKMAP) ||
    library->l_name[0] == '\0') // the program itself
  {
    return "its work is in no shared library";
  }
  const std::string file = FindLoadedFile(address);
  if (file.empty() || file.size() >= sizeof request.Library)
  {
    return "its library has been replaced; start the program again";
  }
  std::memcpy(request.Library, file.c_str(), file.size() + 1);
  request.Place = reinterpret_cast<std::uintptr_t>(address) - library->l_addr;
  return "";
}

// Loads the library of a request, and finds its work. Libraries stay loaded for more files. With
// RTLD_GLOBAL, ExpatDeferral.cxx in relievo-reader finds the functions that it overrides.
bool LoadWork(Request& request)
{
  link_map* library = nullptr;
  void* const handle = dlopen(request.Library, RTLD_NOW | RTLD_GLOBAL);
  if (!handle || dlinfo(handle, RTLD_DI_LINKMAP, &library) != 0)
  {
    return false;
  }
  request.Work = reinterpret_cast<vtkRelievoReaderProcess::Work>(library->l_addr + request.Place);
  return true;
}

//------------------------------------------------------------------------------
// The bytes that a process may take for files of so many bytes; fewer if the user has limited all
// processes (ulimit -v, -d).
std::uint64_t GetMemory(std::uint64_t size)
{
  rlimit addresses = {};
  rlimit data = {};
  getrlimit(RLIMIT_AS, &addresses);
  getrlimit(RLIMIT_DATA, &data);
  return std::min<std::uint64_t>(
    Memory + MemoryOfMiB * (size >> 20), std::min(addresses.rlim_cur, data.rlim_max));
}

std::uint64_t GetSeconds(std::uint64_t least, std::uint64_t size)
{
  return least + SecondsOfMiB * (size >> 20);
}

// The seconds since a process began in which it waited: none of its threads computed, and its first
// thread was not queued for a processor. So a slow file on a busy machine does not count as
// waiting.
double GetWaitingSeconds(pid_t process, double passed)
{
  clockid_t clock = 0;
  timespec computed = {};
  if (process == 0) // not begun yet
  {
    return passed;
  }
  if (clock_getcpuclockid(process, &clock) != 0 || clock_gettime(clock, &computed) != 0)
  {
    return 0.0; // it has ended
  }
  std::ifstream statistics("/proc/" + std::to_string(process) + "/schedstat");
  std::uint64_t ran = 0, queued = 0;
  statistics >> ran >> queued; // in nanoseconds; 0 if the kernel has no statistics
  return passed - static_cast<double>(computed.tv_sec) -
    1e-9 * (static_cast<double>(computed.tv_nsec) + static_cast<double>(queued));
}

// Keeps the user's own limits if they are lower.
template <typename Resource>
void Limit(Resource resource, std::uint64_t most)
{
  rlimit limit = {};
  getrlimit(resource, &limit);
  limit.rlim_cur = std::min<rlim_t>(most, limit.rlim_max);
  setrlimit(resource, &limit);
}

void LimitAll(std::uint64_t size)
{
  // Sanitizers reserve terabytes of address space.
#ifndef __SANITIZE_ADDRESS__
  Limit(RLIMIT_DATA, GetMemory(size));
#endif
  Limit(RLIMIT_CPU, GetSeconds(ProcessorSeconds, size));
}

// Runs in the process of one file.
[[noreturn]] void Work(const Request& request, int bytes, int line, int folder)
{
  if (fchdir(folder) != 0)
  {
    _exit(1);
  }
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  prctl(PR_SET_DUMPABLE, 0); // no core
  ProcessorSeconds = request.ProcessorSeconds;
  LimitAll(0);
  Line = line;
  Note began;
  began.Kind = Note::Began;
  began.Status = getpid();
  Send(line, began);
  std::set_new_handler([] {
    vtkRelievoReaderProcess::LackMemory();
    throw std::bad_alloc();
  });
  // VTK throws if malloc() fails, even from noexcept functions.
  std::set_terminate([] {
    try
    {
      if (const std::exception_ptr thrown = std::current_exception())
      {
        std::rethrow_exception(thrown);
      }
    }
    catch (const std::bad_alloc&)
    {
      vtkRelievoReaderProcess::LackMemory();
    }
    catch (...)
    {
    }
    std::abort();
  });
  try
  {
    Buffer asked;
    while (asked.GetSize() < request.Size && asked.Receive(bytes, request.Size - asked.GetSize()))
    {
    }
    relievo::ByteReader reader(asked.Get(), asked.GetSize());
    std::uint64_t sent = 0;
    relievo::ByteWriter writer([bytes, &sent](const char* part, std::size_t size) {
      if (!SendBytes(bytes, part, size))
      {
        _exit(0); // the requester has gone
      }
      sent += size;
    });
    int percent = -1;
    std::string before;
    const auto say = [&](const std::string& what, double share) {
      const int now = static_cast<int>(100. * std::clamp(share, 0., 1.));
      if (now != percent || what != before)
      {
        percent = now;
        before = what;
        Note note;
        note.Share = share;
        std::snprintf(note.Text, sizeof note.Text, "%s", what.c_str());
        Send(line, note);
      }
      return true;
    };
    request.Work(reader, say, writer);
    writer.Flush();
    Note note;
    note.Kind = Note::Whole;
    note.Size = sent;
    Send(line, note);
  }
  catch (const std::bad_alloc&)
  {
    vtkRelievoReaderProcess::LackMemory();
  }
  _exit(0);
}

//------------------------------------------------------------------------------
// A process of one file, as seen by the process that forked it.
struct Child
{
  pid_t Number = 0;
  Descriptor Life; // readable when the process has ended
  Descriptor Line; // to the requester
};

std::unique_ptr<Child> Fork(const Request& request, int bytes, int line, int folder)
{
  auto child = std::make_unique<Child>();
  child->Line.Take(fcntl(line, F_DUPFD_CLOEXEC, 0));
  int life[2];
  if (!child->Line || pipe2(life, O_CLOEXEC) != 0)
  {
    return nullptr;
  }
  child->Life.Take(life[0]);
  const Descriptor its(life[1]);
  child->Number = fork();
  if (child->Number == 0)
  {
    Work(request, bytes, line, folder);
  }
  return child->Number < 0 ? nullptr : std::move(child);
}

void Bury(const Child& child)
{
  Note note;
  note.Kind = Note::Ended;
  while (waitpid(child.Number, &note.Status, 0) < 0 && errno == EINTR)
  {
  }
  Send(child.Line.Get(), note);
}

[[noreturn]] void ServeProgram(int server)
{
  prctl(PR_SET_NAME, "relievo-reader");
  // These signals end the program; this process then ends when the program's socket closes.
  for (const int signal : { SIGHUP, SIGINT, SIGQUIT, SIGTERM })
  {
    std::signal(signal, SIG_IGN);
  }
  // waitpid and the limit of processor time need these signals, which the program that started this
  // one may ignore or block.
  for (const int signal : { SIGCHLD, SIGXCPU })
  {
    std::signal(signal, SIG_DFL);
  }
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  const int nowhere = open("/dev/null", O_RDWR | O_CLOEXEC);
  for (const int stream : { STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO })
  {
    dup2(nowhere, stream); // the original's other end may be awaited
  }
  std::vector<std::unique_ptr<Child>> children;
  for (;;)
  {
    std::vector<pollfd> ready = { { server, POLLIN, 0 } };
    for (const std::unique_ptr<Child>& child : children)
    {
      ready.push_back({ child->Life.Get(), POLLIN, 0 });
      ready.push_back({ child->Line.Get(), POLLIN, 0 });
    }
    if (poll(ready.data(), ready.size(), -1) < 0)
    {
      continue;
    }
    for (std::size_t i = children.size(); i-- > 0;)
    {
      Child& child = *children[i];
      if (ready[1 + 2 * i].revents != 0)
      {
        Bury(child);
        children.erase(children.begin() + static_cast<std::ptrdiff_t>(i));
      }
      else if (ready[2 + 2 * i].revents != 0) // the requester has cancelled or is gone
      {
        kill(child.Number, SIGKILL); // its number cannot be reused before waitpid
        pollfd life = { child.Life.Get(), POLLIN, 0 };
        poll(&life, 1, -1);
        Bury(child);
        children.erase(children.begin() + static_cast<std::ptrdiff_t>(i));
      }
    }
    if (ready[0].revents != 0)
    {
      Request request;
      Descriptor bytes, line, folder;
      if (!ReceiveRequest(server, request, bytes, line, folder))
      {
        _exit(0); // its children end with it
      }
      Note refused;
      refused.Kind = Note::Refused;
      if (request.Library[0] != '\0' && !LoadWork(request))
      {
        std::snprintf(refused.Text, sizeof refused.Text, "%s", dlerror());
        Send(line.Get(), refused);
      }
      else if (auto child = Fork(request, bytes.Get(), line.Get(), folder.Get()))
      {
        children.push_back(std::move(child));
      }
      else
      {
        std::snprintf(refused.Text, sizeof refused.Text, "%s", std::strerror(errno));
        Send(line.Get(), refused);
      }
    }
  }
}

//------------------------------------------------------------------------------
std::string InGiB(std::uint64_t size)
{
  char text[32];
  std::snprintf(text, sizeof text, size % (1 << 30) == 0 ? "%.0f GiB" : "%.1f GiB",
    static_cast<double>(size) / (1 << 30));
  return text;
}

std::string DescribeSignal(int signal)
{
  const char* name = strsignal(signal);
  std::string text = name ? name : std::to_string(signal);
  text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
  return text;
}

// The end of a process that left no complete result, as a text.
std::string Describe(int status, bool lackedMemory, std::uint64_t size)
{
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  if (signal == SIGXCPU)
  {
    return "did not end within " + std::to_string(GetSeconds(ProcessorSeconds, size)) +
      " s of processor time";
  }
  if (lackedMemory)
  {
    return "used more than " + InGiB(GetMemory(size)) + " of memory";
  }
  if (signal == SIGKILL)
  {
    return "was ended by the system; is there memory for it?";
  }
  return signal != 0 ? "crashed (" + DescribeSignal(signal) + ")" : "ended early";
}

void Stop()
{
  if (Server >= 0)
  {
    close(Server);
    Server = -1;
    if (Forked)
    {
      waitpid(Process, nullptr, 0);
    }
  }
}

//------------------------------------------------------------------------------
constexpr int ServedDescriptor = 3; // of relievo-reader

// Starts relievo-reader from the folder `relievo` beside the library that contains this code. A
// fork of the program would keep all locks that its other threads hold. Returns "", or the failure.
std::string StartProgram()
{
  std::string path = FindLoadedFile(reinterpret_cast<void*>(&StartProgram));
  path = path.substr(0, path.rfind('/') + 1) + "relievo/relievo-reader";
  const std::string cannot = path + " cannot be started: ";
  Descriptor ours, its;
  if (!Connect(SOCK_SEQPACKET, ours, its))
  {
    return cannot + std::strerror(errno);
  }
  char* const words[] = { path.data(), nullptr };
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, its.Get(), ServedDescriptor);
  pid_t started = 0;
  const int trouble = posix_spawn(&started, path.c_str(), &actions, nullptr, words, environ);
  posix_spawn_file_actions_destroy(&actions);
  its.Close();
  if (trouble != 0)
  {
    return cannot + std::strerror(trouble);
  }
  while (waitpid(started, nullptr, 0) < 0 && errno == EINTR) // it forks the server, then ends
  {
  }
  pid_t process = 0;
  ssize_t got = -1;
  do
  {
    got = recv(ours.Get(), &process, sizeof process, 0);
  } while (got < 0 && errno == EINTR);
  if (got != sizeof process)
  {
    return cannot + "it ended early";
  }
  Process = process;
  User = geteuid();
  Group = getegid();
  Server = ours.Release();
  std::atexit(Stop);
  return "";
}

// Gives up the server; the next file starts the program again.
void LeaveProgram()
{
  close(Server);
  Server = -1;
  Process = 0;
  Searched = false;
}
}

//------------------------------------------------------------------------------
bool vtkRelievoReaderProcess::Start()
{
  Descriptor ours, its;
  if (Server >= 0 || !Connect(SOCK_SEQPACKET, ours, its))
  {
    return Server >= 0;
  }
  Process = fork();
  if (Process == 0)
  {
    ours.Close();
    ServeProgram(its.Get());
  }
  if (Process < 0)
  {
    Process = 0;
    return false;
  }
  Server = ours.Release();
  Forked = true;
  std::atexit(Stop);
  return true;
}

//------------------------------------------------------------------------------
bool vtkRelievoReaderProcess::Serve()
{
  struct stat about = {};
  if (fstat(ServedDescriptor, &about) != 0 || !S_ISSOCK(about.st_mode))
  {
    return false; // started by hand
  }
  const pid_t served = fork(); // so that a script that waits for its children ignores the server
  if (served != 0)
  {
    return served > 0;
  }
  close_range(ServedDescriptor + 1, ~0U, 0); // files that the program left open
  fcntl(ServedDescriptor, F_SETFD, FD_CLOEXEC);
  const pid_t process = getpid();
  if (send(ServedDescriptor, &process, sizeof process, MSG_NOSIGNAL) == sizeof process)
  {
    ServeProgram(ServedDescriptor);
  }
  return false;
}

//------------------------------------------------------------------------------
bool vtkRelievoReaderProcess::IsThere()
{
  if (Line >= 0) // within a work, which reads referenced files itself
  {
    return false;
  }
  std::unique_lock<std::mutex> guard(Starting);
  // Nothing is read with rights that the program has given up.
  if (Server >= 0 && !Forked && (User != geteuid() || Group != getegid()))
  {
    LeaveProgram();
  }
  if (Server < 0 && !Searched)
  {
    Searched = true;
    const std::string trouble = std::getenv("RELIEVO_READ_HERE") ? "" : StartProgram();
    static bool warned = false;
    if (!trouble.empty() && !std::exchange(warned, true))
    {
      guard.unlock(); // whoever shows the message may read a file for it
      vtkGenericWarningMacro("Files are read in this process, which a damaged file can crash: "
        << trouble << ". Install this program, or set RELIEVO_READ_HERE=1 to read without it.");
      return false;
    }
  }
  return Server >= 0;
}

//------------------------------------------------------------------------------
int vtkRelievoReaderProcess::GetProcess()
{
  return Process;
}

//------------------------------------------------------------------------------
std::string vtkRelievoReaderProcess::Run(Work work,
  const std::function<void(relievo::ByteWriter&)>& ask, const Say& say,
  const std::function<void(relievo::ByteReader&)>& take)
{
  const std::string cannot = "cannot be started: ";
  Descriptor bytes, its, line, itsLine;
  constexpr int how = O_PATH | O_DIRECTORY | O_CLOEXEC;
  Descriptor folder(open(".", how));
  if (!folder && errno == EACCES) // as after sudo; only absolute paths then work
  {
    folder.Take(open("/", how));
  }
  if (!folder || !Connect(SOCK_STREAM, bytes, its) || !Connect(SOCK_SEQPACKET, line, itsLine))
  {
    return cannot + std::strerror(errno);
  }
  Request request;
  request.Work = work;
  const std::string nowhere = Forked ? "" : FindPlace(work, request);
  if (!nowhere.empty())
  {
    return cannot + nowhere;
  }
  std::vector<char> asked;
  relievo::ByteWriter writer(
    [&asked](const char* part, std::size_t size) { asked.insert(asked.end(), part, part + size); });
  ask(writer);
  writer.Flush();
  request.Size = asked.size();
  request.ProcessorSeconds = ProcessorSeconds;
  Descriptor server; // a copy, since another thread may close the socket
  pid_t served = 0;
  {
    const std::lock_guard<std::mutex> guard(Starting);
    server.Take(fcntl(Server, F_DUPFD_CLOEXEC, STDERR_FILENO + 1));
    served = Process;
    if (!server && Server >= 0)
    {
      return cannot + std::strerror(errno);
    }
  }
  const auto fail = [served, &cannot] {
    const std::lock_guard<std::mutex> guard(Starting);
    if (!Forked)
    {
      if (Server >= 0 && Process == served) // not another thread's new one
      {
        LeaveProgram();
      }
      return cannot + "the process that reads files has been ended; read it again";
    }
    waitpid(Process, nullptr, WNOHANG);
    return cannot + "the process that reads files has been ended; start the program again";
  };
  if (!SendRequest(server.Get(), request, { its.Get(), itsLine.Get(), folder.Get() }))
  {
    const bool lacks = errno == ETOOMANYREFS || errno == ENOBUFS || errno == ENOMEM;
    return lacks ? cannot + std::strerror(errno) : fail();
  }
  server.Close();
  its.Close();
  itsLine.Close();
  SendBytes(bytes.Get(), asked.data(), asked.size()); // a failure is reported as the process's end

  using Clock = std::chrono::steady_clock;
  const Clock::time_point began = Clock::now();
  pid_t process = 0;
  constexpr int patience = 50; // milliseconds between checks whether to go on
  std::uint64_t size = 0;
  std::uint64_t total = 0; // bytes of the result
  std::string what;
  double share = 0.;
  bool whole = false, lackedMemory = false, stopped = false, late = false, made = false;
  Buffer answer;
  Note note;
  for (bool ended = false; !ended;)
  {
    std::array<pollfd, 2> ready = { { { line.Get(), POLLIN, 0 },
      { made ? -1 : bytes.Get(), POLLIN, 0 } } };
    const bool waits = poll(ready.data(), ready.size(), patience) <= 0;
    bool tells = waits;
    if (!waits && ready[1].revents != 0)
    {
      made = !answer.Receive(bytes.Get(), SIZE_MAX);
      lackedMemory = lackedMemory || answer.GetSize() > GetMemory(size);
    }
    if (!waits && ready[0].revents != 0)
    {
      if (!Receive(line.Get(), note))
      {
        if (!stopped && !late && !lackedMemory)
        {
          return fail();
        }
        break; // the process no longer exists
      }
      if (note.Kind == Note::Refused)
      {
        return cannot + note.Text;
      }
      ended = note.Kind == Note::Ended;
      process = note.Kind == Note::Began ? note.Status : process;
      size += note.Kind == Note::Opened ? note.Size : 0;
      whole = whole || note.Kind == Note::Whole;
      total = note.Kind == Note::Whole ? note.Size : total;
      lackedMemory = lackedMemory || note.Kind == Note::NoMemory;
      tells = note.Kind == Note::Progress;
      what = tells ? note.Text : what;
      share = tells ? note.Share : share;
    }
    const bool unwanted = stopped || late;
    stopped = stopped || (tells && !say(what, share));
    const auto patient = static_cast<double>(GetSeconds(WaitingSeconds, size));
    const double passed = std::chrono::duration<double>(Clock::now() - began).count();
    late = late || (!ended && passed > patient && GetWaitingSeconds(process, passed) > patient) ||
      answer.GetSize() > GetMemory(size);
    if (!unwanted && (stopped || late))
    {
      Send(line.Get(), Note());
    }
  }
  if (stopped)
  {
    return "was stopped";
  }
  if (!whole && late && !lackedMemory)
  {
    return "waited for more than " + std::to_string(GetSeconds(WaitingSeconds, size)) + " s";
  }
  if (!whole)
  {
    return Describe(note.Status, lackedMemory, size);
  }
  // Does not wait for the socket's end: a process forked by another thread may hold a copy of it.
  while (!made && answer.GetSize() < total && answer.Receive(bytes.Get(), SIZE_MAX))
  {
  }
  relievo::ByteReader reader(answer.Get(), answer.GetSize());
  try
  {
    take(reader);
  }
  catch (const std::runtime_error&)
  {
    return "crashed: its result is damaged";
  }
  return "";
}

//------------------------------------------------------------------------------
void vtkRelievoReaderProcess::Allow(std::uint64_t size)
{
  if (Line >= 0)
  {
    Opened += size;
    LimitAll(Opened);
    Note note;
    note.Kind = Note::Opened;
    note.Size = size;
    Send(Line, note);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoReaderProcess::SetLimits(
  std::uint64_t processorSeconds, std::uint64_t waitingSeconds)
{
  ProcessorSeconds = processorSeconds;
  WaitingSeconds = waitingSeconds;
}

//------------------------------------------------------------------------------
void vtkRelievoReaderProcess::LackMemory()
{
  if (Line >= 0)
  {
    Note note;
    note.Kind = Note::NoMemory;
    Send(Line, note);
  }
}
#else
bool vtkRelievoReaderProcess::Start()
{
  return false;
}

bool vtkRelievoReaderProcess::Serve()
{
  return false;
}

bool vtkRelievoReaderProcess::IsThere()
{
  return false;
}

int vtkRelievoReaderProcess::GetProcess()
{
  return 0;
}

std::string vtkRelievoReaderProcess::Run(Work, const std::function<void(relievo::ByteWriter&)>&,
  const Say&, const std::function<void(relievo::ByteReader&)>&)
{
  return "";
}

void vtkRelievoReaderProcess::Allow(std::uint64_t) {}

void vtkRelievoReaderProcess::SetLimits(std::uint64_t, std::uint64_t) {}

void vtkRelievoReaderProcess::LackMemory() {}
#endif
