// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The files opened while reading: those named by the words, and those that these name in turn, such
 * as textures, buffers and pieces. No output may replace one.
 */
#ifndef OpenedFiles_h
#define OpenedFiles_h

#include <string>
#include <vector>

namespace scene
{
class OpenedFiles
{
public:
  /// While it lives, files opened by this thread are added to the list.
  explicit OpenedFiles(std::vector<std::string>& list);
  ~OpenedFiles();
  OpenedFiles(const OpenedFiles&) = delete;
  void operator=(const OpenedFiles&) = delete;

  /// Records that a file is opened. Without a list, or without the file, does nothing.
  static void Add(const std::string& path);

private:
  std::vector<std::string>* Before;
};
}

#endif
