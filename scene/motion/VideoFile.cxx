// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VideoFile.h"

#include "Errors.h"
#include "MotionOptions.h"
#include "Numbers.h"
#include "Readers.h"
#include "Values.h"

#include "vtkImageData.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <vector>

#include <fcntl.h>
#include <locale.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace scene
{
namespace
{
constexpr const char* Program = "ffmpeg";

void Close(int& number)
{
  if (number >= 0)
  {
    close(number);
  }
  number = -1;
}

// The arguments: frames from standard input, the same bytes for the same frames, and for H.264 even
// sizes and the colours of HD television, which all players can show.
std::vector<std::string> GetWords(const std::string& path, const std::string& name,
  const std::array<int, 2>& size, double framesPerSecond)
{
  std::vector<std::string> words = { Program, "-nostdin", "-loglevel", "error", "-y", "-f",
    "rawvideo", "-pix_fmt", "rgb24", "-video_size",
    std::to_string(size[0]) + "x" + std::to_string(size[1]), "-framerate",
    WriteNumber(framesPerSecond), "-i", "pipe:0", "-fflags", "+bitexact", "-flags:v", "+bitexact" };
  const std::vector<std::string> lossless = { "-c:v", "ffv1", "-level", "3", "-pix_fmt", "bgr0",
    "-f", "matroska" };
  const std::vector<std::string> common = { "-vf",
    "pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix=bt709:out_range=tv", "-c:v", "libx264",
    "-crf", "16", "-pix_fmt", "yuv420p", "-colorspace", "bt709", "-color_primaries", "bt709",
    "-color_trc", "iec61966-2-1", "-color_range", "tv", "-movflags", "+faststart", "-f", "mp4" };
  const std::vector<std::string>& own = ExtensionOf(name) == VideoFile::FFV1 ? lossless : common;
  words.insert(words.end(), own.begin(), own.end());
  words.push_back("file:" + path); // a colon in the path begins no protocol
  return words;
}
}

//------------------------------------------------------------------------------
bool VideoFile::HasProgram()
{
  const char* folders = std::getenv("PATH");
  const std::vector<std::string> all = Split(folders ? folders : "", ':');
  return std::any_of(all.begin(), all.end(), [](const std::string& folder) {
    return access((std::filesystem::path(folder) / Program).c_str(), X_OK) == 0;
  });
}

//------------------------------------------------------------------------------
VideoFile::VideoFile(const std::string& path, const std::string& name,
  const std::array<int, 2>& size, double framesPerSecond)
  : Name(name)
  , Size(size)
{
  std::FILE* errors = std::tmpfile();
  this->Errors = errors ? fcntl(fileno(errors), F_DUPFD_CLOEXEC, STDERR_FILENO + 1) : -1;
  if (errors)
  {
    std::fclose(errors);
  }
  // A socket, because writing to it need not raise a signal if ffmpeg has ended.
  int ends[2] = { -1, -1 };
  int trouble =
    this->Errors < 0 || socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0 ? errno : 0;
  this->Pipe = ends[0];
  if (trouble == 0)
  {
    std::vector<std::string> words = GetWords(path, name, size, framesPerSecond);
    std::vector<char*> arguments;
    for (std::string& word : words)
    {
      arguments.push_back(word.data());
    }
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, this->Errors, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, this->Errors, STDERR_FILENO);
    trouble = posix_spawnp(&this->Process, Program, &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
  }
  Close(ends[1]);
  if (trouble != 0)
  {
    this->Process = 0;
    Close(this->Pipe);
    Close(this->Errors);
    throw FileError(name + ": ffmpeg cannot be started: " + std::strerror(trouble));
  }
}

//------------------------------------------------------------------------------
VideoFile::~VideoFile()
{
  if (this->Process > 0)
  {
    kill(this->Process, SIGKILL);
    waitpid(this->Process, nullptr, 0);
  }
  Close(this->Pipe);
  Close(this->Errors);
}

//------------------------------------------------------------------------------
// The errors that ffmpeg has printed.
std::string VideoFile::GetErrors() const
{
  std::string text(65536, '\0');
  const ssize_t got = pread(this->Errors, text.data(), text.size(), 0);
  text.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
  text.erase(text.find_last_not_of('\n') + 1);
  return text;
}

//------------------------------------------------------------------------------
// The system's message if a file could not grow; otherwise empty. When the disk is full, ffmpeg 5
// may print it and exit with 0.
std::string VideoFile::GetSystemError() const
{
  const std::string text = this->GetErrors();
  const locale_t plain = newlocale(LC_ALL_MASK, "C", locale_t(nullptr)); // which ffmpeg keeps
  std::string found;
  for (const int error : { ENOSPC, EDQUOT, EFBIG, EIO })
  {
    const std::string message = strerror_l(error, plain);
    found = found.empty() && text.find(message) != std::string::npos ? message : found;
  }
  freelocale(plain);
  return found;
}

//------------------------------------------------------------------------------
// Throws with the system's message or with the last line that ffmpeg has printed.
void VideoFile::Fail()
{
  std::string text = this->GetSystemError();
  text = text.empty() ? this->GetErrors() : text;
  text.erase(0, text.rfind('\n') + 1); // npos + 1 is 0
  throw FileError(this->Name + ": ffmpeg cannot write it" + (text.empty() ? "" : ": " + text));
}

//------------------------------------------------------------------------------
void VideoFile::Add(vtkImageData* picture)
{
  const int* size = picture->GetDimensions();
  const int components = picture->GetNumberOfScalarComponents();
  if (size[0] != this->Size[0] || size[1] != this->Size[1] || components != 3)
  {
    throw FileError(this->Name + ": a frame has " + std::to_string(size[0]) + "x" +
      std::to_string(size[1]) + " pixels of " + std::to_string(components) +
      " values, expected the film's " + std::to_string(this->Size[0]) + "x" +
      std::to_string(this->Size[1]) + " of 3");
  }
  const auto length = 3 * static_cast<std::size_t>(size[0]);
  std::vector<char> frame(length * static_cast<std::size_t>(size[1]));
  for (int row = 0; row < size[1]; ++row) // from the top
  {
    std::memcpy(frame.data() + length * static_cast<std::size_t>(row),
      picture->GetScalarPointer(0, size[1] - 1 - row, 0), length);
  }
  std::size_t sent = 0;
  while (sent < frame.size())
  {
    const ssize_t some = send(this->Pipe, frame.data() + sent, frame.size() - sent, MSG_NOSIGNAL);
    if (some < 0 && errno != EINTR)
    {
      Close(this->Pipe); // else ffmpeg could wait for more
      waitpid(this->Process, nullptr, 0);
      this->Process = 0;
      this->Fail();
    }
    sent += some > 0 ? static_cast<std::size_t>(some) : 0;
  }
}

//------------------------------------------------------------------------------
void VideoFile::Finish()
{
  Close(this->Pipe);
  int status = 0;
  while (waitpid(this->Process, &status, 0) < 0 && errno == EINTR)
  {
  }
  this->Process = 0;
  if (status != 0 || !this->GetSystemError().empty())
  {
    this->Fail();
  }
}
}
