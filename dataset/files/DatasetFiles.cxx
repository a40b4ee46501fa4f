// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DatasetFiles.h"

#include "Errors.h"

#include "vtkRelievoFileKind.h"
#include "vtkRelievoTemporaryFile.h"
#include "vtk_zlib.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <new>
#include <system_error>

namespace dataset
{
namespace
{
// A number of a PNG file, the highest byte first.
void AppendReversed(std::string& bytes, std::size_t number)
{
  for (int i = 3; i >= 0; --i)
  {
    bytes += static_cast<char>(number >> (8 * i) & 255);
  }
}

// A chunk of a PNG file.
void AppendChunk(std::string& bytes, const std::string& type, const std::string& data)
{
  AppendReversed(bytes, data.size());
  const std::string checked = type + data;
  bytes += checked;
  AppendReversed(bytes,
    crc32(0, reinterpret_cast<const Bytef*>(checked.data()), static_cast<uInt>(checked.size())));
}

// A PNG of rows from the top, each after the byte of its filter.
std::string EncodeRows(
  std::string& rows, int width, int height, int bits, int components, int level, int strategy)
{
  z_stream stream = {};
  constexpr int window = 15;
  constexpr int memory = 8;
  if (deflateInit2(&stream, level, Z_DEFLATED, window, memory, strategy) != Z_OK)
  {
    throw std::bad_alloc();
  }
  const std::unique_ptr<z_stream, int (*)(z_stream*)> end(
    &stream, [](z_stream* open) { return deflateEnd(open); });
  std::string packed(deflateBound(&stream, static_cast<uLong>(rows.size())), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(rows.data());
  stream.avail_in = static_cast<uInt>(rows.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  if (deflate(&stream, Z_FINISH) != Z_STREAM_END)
  {
    throw std::bad_alloc();
  }
  packed.resize(stream.total_out);

  std::string header;
  AppendReversed(header, static_cast<std::size_t>(width));
  AppendReversed(header, static_cast<std::size_t>(height));
  header += static_cast<char>(bits);
  constexpr char types[] = { 0, 4, 2, 6 }; // grey levels or colours, without and with alpha
  header += types[components - 1];
  header.append(3, '\0');
  std::string file = "\x89PNG\r\n\x1a\n";
  AppendChunk(file, "IHDR", header);
  AppendChunk(file, "IDAT", packed);
  AppendChunk(file, "IEND", "");
  return file;
}

// Bytes are stored as differences from those above. A choice among PNG's filters for each row, and
// a longer search for repetitions, took three times as long for files a tenth smaller.
std::string EncodeImage(const unsigned char* bytes, int columns, int rows, int bits, int components)
{
  constexpr int level = 3;
  const std::size_t length =
    static_cast<std::size_t>(columns) * static_cast<std::size_t>(components * bits / 8);
  std::string lines((length + 1) * static_cast<std::size_t>(rows), '\0');
  char* to = lines.data();
  const std::vector<unsigned char> zeros(length, 0);
  const unsigned char* above = zeros.data();
  for (int row = 0; row < rows; ++row)
  {
    *to++ = 2; // the filter Up
    for (std::size_t i = 0; i < length; ++i)
    {
      to[i] = static_cast<char>(bytes[i] - above[i]);
    }
    to += length;
    above = bytes;
    bytes += length;
  }
  return EncodeRows(lines, columns, rows, bits, components, level, Z_DEFAULT_STRATEGY);
}

// Numbers of a ZIP file, the lowest byte first.
void Append(std::string& bytes, int count, std::size_t number)
{
  for (int i = 0; i < count; ++i)
  {
    bytes += static_cast<char>(number >> (8 * i) & 255);
  }
}

// Fields common to a file's two headers of an entry.
void AppendEntry(std::string& bytes, unsigned int check, std::size_t size, const std::string& name)
{
  constexpr std::size_t version = 20;
  constexpr std::size_t firstDay = 1 << 5 | 1; // 1980-01-01: equal arrays give equal bytes
  Append(bytes, 2, version);
  Append(bytes, 2, 0); // flags
  Append(bytes, 2, 0); // stored without compression
  Append(bytes, 2, 0); // time
  Append(bytes, 2, firstDay);
  Append(bytes, 4, check);
  Append(bytes, 4, size);
  Append(bytes, 4, size);
  Append(bytes, 2, name.size());
  Append(bytes, 2, 0); // no extra fields
}
}

//------------------------------------------------------------------------------
void MakeFolder(const std::string& folder)
{
  std::error_code trouble;
  std::filesystem::create_directories(folder, trouble);
  if (trouble)
  {
    throw FileError(folder + ": cannot be made: " + trouble.message());
  }
}

//------------------------------------------------------------------------------
void WriteWhole(const std::string& path, const std::function<bool(const std::string&)>& write)
{
  std::error_code trouble;
  const std::string folder = std::filesystem::path(path).parent_path().string();
  if (!folder.empty())
  {
    MakeFolder(folder);
  }
  vtkRelievoTemporaryFile file(folder.empty() ? "." : folder, trouble);
  if (!trouble && !write(file.GetName()))
  {
    throw FileError(path + ": cannot be written; is the disk full?");
  }
  if (!trouble)
  {
    file.MoveTo(path, trouble);
  }
  if (trouble)
  {
    throw FileError(path + ": cannot be written: " + trouble.message());
  }
}

//------------------------------------------------------------------------------
void WriteWhole(const std::string& path, const std::string& bytes)
{
  WriteWhole(path, [&bytes](const std::string& name) {
    std::ofstream file(name, std::ios::binary);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.close();
    return file.good();
  });
}

//------------------------------------------------------------------------------
std::string ReadWhole(const std::string& path)
{
  constexpr std::size_t most = std::size_t(1) << 28;
  std::string bytes;
  const std::string error = vtkRelievoFileKind::ReadWhole(path, most, bytes);
  if (!error.empty())
  {
    throw FileError(path + ": " + error);
  }
  return bytes;
}

//------------------------------------------------------------------------------
std::string WriteDatasetNumber(std::size_t number)
{
  constexpr std::size_t digits = 6;
  const std::string text = std::to_string(number);
  return std::string(text.size() < digits ? digits - text.size() : 0, '0') + text;
}

//------------------------------------------------------------------------------
std::string WriteDatasetJson(const nlohmann::ordered_json& json)
{
  return json.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

//------------------------------------------------------------------------------
std::string EncodePNG(
  const std::vector<unsigned char>& pixels, int columns, int rows, int components)
{
  return EncodeImage(pixels.data(), columns, rows, 8, components);
}

//------------------------------------------------------------------------------
std::string EncodePNG(const std::vector<unsigned short>& pixels, int columns, int rows)
{
  std::vector<unsigned char> bytes; // the higher one first
  bytes.reserve(2 * pixels.size());
  for (const unsigned short pixel : pixels)
  {
    bytes.push_back(static_cast<unsigned char>(pixel >> 8));
    bytes.push_back(static_cast<unsigned char>(pixel & 255));
  }
  return EncodeImage(bytes.data(), columns, rows, 16, 1);
}

//------------------------------------------------------------------------------
// Runs of equal bytes are all there is to compress: with PNG's filters and a search for other
// repetitions, masks would take most of the time of a data set.
std::string EncodeMask(const std::vector<unsigned char>& pixels, int columns, int rows)
{
  const auto length = static_cast<std::size_t>(columns);
  std::string lines;
  lines.reserve((length + 1) * static_cast<std::size_t>(rows));
  for (std::size_t row = 0; row < static_cast<std::size_t>(rows); ++row)
  {
    lines += '\0'; // no filter
    lines.append(reinterpret_cast<const char*>(pixels.data()) + row * length, length);
  }
  return EncodeRows(lines, columns, rows, 8, 1, Z_DEFAULT_COMPRESSION, Z_RLE);
}

//------------------------------------------------------------------------------
void NumpyArchive::Add(const std::string& name, const std::string& type,
  const std::vector<std::size_t>& shape, const void* values, std::size_t bytes)
{
  constexpr std::size_t aligned = 64;
  std::string header = "{'descr': '" + type + "', 'fortran_order': False, 'shape': (";
  for (const std::size_t count : shape)
  {
    header += std::to_string(count) + ",";
  }
  header += "), }";
  constexpr std::size_t before = 10; // bytes, of the magic number, the version and the length
  header.append(aligned - (before + header.size() + 1) % aligned, ' ');
  header += '\n';
  std::string data("\x93NUMPY\x01\x00", 8);
  Append(data, 2, header.size());
  data += header;
  if (bytes > 0)
  {
    data.append(static_cast<const char*>(values), bytes);
  }
  Entry entry;
  entry.Name = name + ".npy";
  entry.Size = data.size();
  entry.Place = this->Bytes.size();
  entry.Check = static_cast<unsigned int>(
    crc32(0, reinterpret_cast<const Bytef*>(data.data()), static_cast<uInt>(data.size())));
  Append(this->Bytes, 4, 0x04034b50);
  AppendEntry(this->Bytes, entry.Check, entry.Size, entry.Name);
  this->Bytes += entry.Name + data;
  this->Entries.push_back(entry);
}

//------------------------------------------------------------------------------
std::string NumpyArchive::Finish(const std::string& path)
{
  const std::size_t place = this->Bytes.size();
  for (const Entry& entry : this->Entries)
  {
    Append(this->Bytes, 4, 0x02014b50);
    Append(this->Bytes, 2, 20);
    AppendEntry(this->Bytes, entry.Check, entry.Size, entry.Name);
    Append(this->Bytes, 2, 0); // no comment
    Append(this->Bytes, 2, 0); // the first disk
    Append(this->Bytes, 2, 0);
    Append(this->Bytes, 4, 0); // attributes
    Append(this->Bytes, 4, entry.Place);
    this->Bytes += entry.Name;
  }
  const std::size_t length = this->Bytes.size() - place;
  Append(this->Bytes, 4, 0x06054b50);
  Append(this->Bytes, 4, 0); // disks
  Append(this->Bytes, 2, this->Entries.size());
  Append(this->Bytes, 2, this->Entries.size());
  Append(this->Bytes, 4, length);
  Append(this->Bytes, 4, place);
  Append(this->Bytes, 2, 0); // no comment
  if (this->Bytes.size() > UINT32_MAX)
  {
    throw FileError(path + ": would have more than 4 GiB; ask for fewer layers or pixels");
  }
  return std::move(this->Bytes);
}
}
