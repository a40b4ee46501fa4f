// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Hashes that find damaged files: MD5, in hexadecimal digits, as md5sum prints them.
 */
#ifndef FileHash_h
#define FileHash_h

#include "DatasetNames.h"

#include <cstddef>
#include <string>
#include <vector>

namespace dataset
{
class FileHash
{
public:
  FileHash();
  ~FileHash();
  FileHash(const FileHash&) = delete;
  void operator=(const FileHash&) = delete;

  void Add(const void* bytes, std::size_t size);

  /// The hash of all bytes; nothing can be added after it.
  std::string Finish();

  static std::string Of(const std::string& bytes);

  /// The hash of a file; empty if it is no file that can be read.
  static std::string OfFile(const std::string& path);

private:
  void* State;
};
}

#endif
