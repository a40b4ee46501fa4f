// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Encodes files of data sets, and writes each file completely or not at all.
 */
#ifndef DatasetFiles_h
#define DatasetFiles_h

#include "DatasetNames.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace dataset
{
/// Makes a folder and its parents. Throws FileError.
void MakeFolder(const std::string& folder);

/// `write` makes a file of a temporary name, which then replaces the file at `path`; makes the
/// folder first. Throws FileError.
void WriteWhole(const std::string& path, const std::function<bool(const std::string&)>& write);
void WriteWhole(const std::string& path, const std::string& bytes);

/// Returns the bytes of a file of at most 256 MiB. Throws FileError.
std::string ReadWhole(const std::string& path);

/// The six digits, or more, of a number in the names of files.
std::string WriteDatasetNumber(std::size_t number);

/// Serializes JSON; bytes that are not Unicode are replaced.
std::string WriteDatasetJson(const nlohmann::ordered_json& json);

/// Writes pixels of 1 or 3 components as a PNG, row by row from the top.
std::string EncodePNG(
  const std::vector<unsigned char>& pixels, int columns, int rows, int components);
std::string EncodePNG(const std::vector<unsigned short>& pixels, int columns, int rows);

/// Writes a mask, one byte per pixel, as a PNG, row by row from the top.
std::string EncodeMask(const std::vector<unsigned char>& pixels, int columns, int rows);

/// An archive of arrays that numpy.load() reads, uncompressed.
class NumpyArchive
{
public:
  /// Adds row-major values of a numpy type such as <f4.
  void Add(const std::string& name, const std::string& type, const std::vector<std::size_t>& shape,
    const void* values, std::size_t bytes);

  /// The file's bytes. Throws FileError from 4 GiB on, the limit of a ZIP file.
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
