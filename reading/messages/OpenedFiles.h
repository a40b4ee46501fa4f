// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The files that reading opens: those that the words name, and those that these name in turn, such
 * as textures, buffers and pieces. No output may take the place of one.
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
  /// While it lives, the files that this thread opens are added to the list.
  explicit OpenedFiles(std::vector<std::string>& list);
  ~OpenedFiles();
  OpenedFiles(const OpenedFiles&) = delete;
  void operator=(const OpenedFiles&) = delete;

  /// A file is opened. Nothing happens where it is not there, or where nobody listens.
  static void Add(const std::string& path);

private:
  std::vector<std::string>* Before;
};
}

#endif
