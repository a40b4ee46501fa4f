// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Archives in the format of tar (POSIX.1-1988, ustar), with the same bytes on every machine.
 */
#ifndef TarArchive_h
#define TarArchive_h

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace dataset
{
class TarArchive
{
public:
  /// Adds a file; its name has at most 100 bytes.
  void Add(const std::string& name, const std::string& bytes);

  /// The archive's bytes.
  std::string Finish() const;

private:
  std::string Bytes;
};

/// Archives of TarArchive joined to one. Bytes of the result, of files of such sizes.
std::uint64_t GetJoinedTarBytes(const std::vector<std::uint64_t>& sizes);

/// Calls take(bytes) for the bytes of the result, one after the other. Throws FileError.
void JoinTars(
  const std::vector<std::string>& files, const std::function<void(const std::string&)>& take);
}

#endif
