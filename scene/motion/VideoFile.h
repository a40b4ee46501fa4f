// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Writes frames to a film by the program ffmpeg, which receives them through a pipe.
 */
#ifndef VideoFile_h
#define VideoFile_h

#include "SceneNames.h"

#include <array>
#include <string>

#include <sys/types.h>

class vtkImageData;

namespace scene
{
class VideoFile
{
public:
  /// Extensions: H.264 in MP4, and FFV1 in Matroska, which is lossless.
  static constexpr const char* H264 = ".mp4";
  static constexpr const char* FFV1 = ".mkv";

  /// Whether ffmpeg is in a folder of PATH.
  static bool HasProgram();

  /// Starts ffmpeg; throws FileError. `path`: the file, which is replaced; `name` ends in the
  /// format's extension, and begins errors.
  VideoFile(const std::string& path, const std::string& name, const std::array<int, 2>& size,
    double framesPerSecond);
  ~VideoFile(); ///< ends ffmpeg, unless Finish() was called
  VideoFile(const VideoFile&) = delete;
  void operator=(const VideoFile&) = delete;

  /// Appends a picture of this size, of red, green and blue bytes. Throws FileError.
  void Add(vtkImageData* picture);

  /// Completes the file. Throws FileError.
  void Finish();

private:
  std::string GetErrors() const;
  std::string GetSystemError() const;
  [[noreturn]] void Fail();

  std::string Name;
  std::array<int, 2> Size;
  int Pipe = -1;
  int Errors = -1; // a file with the text that ffmpeg prints
  pid_t Process = 0;
};
}

#endif
