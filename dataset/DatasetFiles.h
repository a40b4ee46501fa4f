// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Files of data sets as bytes, and bytes as files that are there whole or not at all.
 */
#ifndef DatasetFiles_h
#define DatasetFiles_h

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace scene
{
/// Makes folders, also those above. Throws FileError.
void MakeFolder(const std::string& folder);

/// `write` makes the file of a temporary name, which then takes the place of what is there; its
/// folder is made. Throws FileError.
void WriteWhole(const std::string& path, const std::function<bool(const std::string&)>& write);
void WriteWhole(const std::string& path, const std::string& bytes);

/// The bytes of a file of at most 256 MiB. Throws FileError.
std::string ReadWhole(const std::string& path);

/// Pixels row by row from the top, as a PNG.
std::string EncodePNG(
  const std::vector<unsigned char>& pixels, int columns, int rows, int components);
std::string EncodePNG(const std::vector<unsigned short>& pixels, int columns, int rows);

/// Arrays that numpy.load() reads, uncompressed.
class NumpyArchive
{
public:
  /// Row-major values of a type that numpy calls so, such as <f4.
  void Add(const std::string& name, const std::string& type, const std::vector<std::size_t>& shape,
    const void* values, std::size_t bytes);

  /// The file. Throws FileError from 4 GiB on, where a ZIP file ends.
  std::string Finish(const std::string& path);

private:
  struct Entry
  {
    std::string Name;
    unsigned int Check;
    std::size_t Size, Place;
  };
  std::vector<Entry> Entries;
  std::string Bytes;
};
}

#endif
