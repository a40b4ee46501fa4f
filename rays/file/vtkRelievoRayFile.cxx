// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoRayFile.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <random>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace
{
constexpr std::size_t Block = vtkRelievoRayHash::Block;
constexpr char Magic[8] = "RELIEVO";
constexpr std::uint32_t Version = 1;
constexpr std::uint32_t Order = 0x01020304;
constexpr std::uint32_t OtherOrder = 0x04030201;

struct Header
{
  char Magic[8];
  std::uint32_t Version;
  std::uint32_t Order;
  std::uint64_t Bytes;
  std::uint64_t Hash;
  std::uint64_t Zeros[4];
};
static_assert(sizeof(Header) == Block, "the arrays are aligned");

struct ArrayHeader
{
  std::uint64_t Count;
  std::uint64_t Size;
  std::uint64_t Zeros[6];
};
static_assert(sizeof(ArrayHeader) == Block, "the values are aligned");

std::size_t PadToBlock(std::size_t bytes)
{
  return (bytes + Block - 1) / Block * Block;
}

std::string FindFault(const Header& header, std::size_t bytes)
{
  if (std::memcmp(header.Magic, Magic, sizeof(Magic)) != 0)
  {
    return "is no file of a tree for rays";
  }
  if (header.Order == OtherOrder)
  {
    return "was written by a machine of the other byte order; write it again on this one";
  }
  if (header.Order != Order)
  {
    return "is damaged: its byte order is unknown";
  }
  if (header.Version != Version)
  {
    return "has version " + std::to_string(header.Version) + " of the format, expected " +
      std::to_string(Version) + "; write it again";
  }
  if (header.Bytes != bytes)
  {
    return "is damaged: it has " + std::to_string(bytes) + " bytes, expected " +
      std::to_string(header.Bytes);
  }
  return {};
}
}

//------------------------------------------------------------------------------
vtkRelievoRayFileWriter::vtkRelievoRayFileWriter(const std::string& path)
  : Path(path)
{
  constexpr int tries = 16;
  std::random_device random;
  for (int i = 0; i < tries && !this->Out; ++i)
  {
    char name[64];
    std::snprintf(name, sizeof(name), ".relievo-%08x%08x.tmp", random(), random());
    this->Temporary = (std::filesystem::path(path).parent_path() / name).string();
    this->Out = std::fopen(this->Temporary.c_str(), "wbxe"); // x: not an existing file or link
    this->Reason = this->Out ? 0 : errno;
    if (this->Reason != 0 && this->Reason != EEXIST)
    {
      break;
    }
  }
  if (!this->Out)
  {
    this->Temporary.clear();
  }
  const Header nothing{};
  this->Append(&nothing, sizeof(nothing));
}

//------------------------------------------------------------------------------
vtkRelievoRayFileWriter::~vtkRelievoRayFileWriter()
{
  if (this->Out)
  {
    std::fclose(this->Out);
  }
  if (!this->Temporary.empty())
  {
    std::remove(this->Temporary.c_str());
  }
}

//------------------------------------------------------------------------------
void vtkRelievoRayFileWriter::WriteBytes(const void* bytes, std::size_t count)
{
  if (this->Reason == 0 && count > 0 && std::fwrite(bytes, 1, count, this->Out) != count)
  {
    this->Reason = errno;
  }
}

//------------------------------------------------------------------------------
void vtkRelievoRayFileWriter::Append(const void* bytes, std::size_t count)
{
  static const char zeros[Block] = {};
  const std::size_t padded = PadToBlock(count);
  this->WriteBytes(bytes, count);
  this->WriteBytes(zeros, padded - count);
  this->Bytes += padded;
}

//------------------------------------------------------------------------------
void vtkRelievoRayFileWriter::PutBytes(const void* values, std::size_t count, std::size_t size)
{
  ArrayHeader header{};
  header.Count = count;
  header.Size = size;
  this->Hash.Add(&header, sizeof(header));
  this->Append(&header, sizeof(header));
  this->Hash.Add(values, count * size);
  this->Append(values, count * size);
}

//------------------------------------------------------------------------------
std::string vtkRelievoRayFileWriter::Finish()
{
  Header header{};
  std::memcpy(header.Magic, Magic, sizeof(Magic));
  header.Version = Version;
  header.Order = Order;
  header.Bytes = this->Bytes;
  header.Hash = this->Hash.Get();
  if (this->Reason == 0 && std::fseek(this->Out, 0, SEEK_SET) != 0)
  {
    this->Reason = errno;
  }
  this->WriteBytes(&header, sizeof(header));
  if (this->Out && std::fclose(std::exchange(this->Out, nullptr)) != 0 && this->Reason == 0)
  {
    this->Reason = errno;
  }
  if (this->Reason != 0)
  {
    return this->Path + ": cannot be written: " + std::strerror(this->Reason);
  }
  std::error_code trouble;
  std::filesystem::rename(this->Temporary, this->Path, trouble);
  if (!trouble)
  {
    this->Temporary.clear();
  }
  return trouble ? this->Path + ": cannot be written: " + trouble.message() : std::string();
}

//------------------------------------------------------------------------------
std::string vtkRelievoRayFileReader::Open(const std::string& path)
{
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  struct stat about = {};
  if (file < 0 || fstat(file, &about) != 0)
  {
    const std::string reason = std::strerror(errno);
    if (file >= 0)
    {
      close(file);
    }
    return path + ": " + reason;
  }
  const auto bytes = static_cast<std::size_t>(std::max<off_t>(about.st_size, 0));
  if (!S_ISREG(about.st_mode) || bytes < sizeof(Header))
  {
    close(file);
    return path + ": is no file of a tree for rays";
  }
  void* const memory = mmap(nullptr, bytes, PROT_READ, MAP_SHARED, file, 0);
  const std::string reason = std::strerror(errno);
  close(file);
  if (memory == MAP_FAILED)
  {
    return path + ": cannot be mapped into memory: " + reason;
  }
  this->Memory = std::shared_ptr<const void>(
    memory, [bytes](const void* mapped) { munmap(const_cast<void*>(mapped), bytes); });
  madvise(memory, bytes, MADV_WILLNEED);
  const auto& header = *static_cast<const Header*>(memory);
  std::string fault = FindFault(header, bytes);
  if (fault.empty())
  {
    vtkRelievoRayHash hash;
    hash.Add(static_cast<const char*>(memory) + sizeof(Header), bytes - sizeof(Header));
    const bool zeros = std::all_of(std::begin(header.Zeros), std::end(header.Zeros),
      [](std::uint64_t number) { return number == 0; });
    fault = hash.Get() == header.Hash && zeros ? "" : "is damaged: its hash is another one";
  }
  this->Bytes = bytes;
  this->Place = sizeof(Header);
  return fault.empty() ? std::string() : path + ": " + fault;
}

//------------------------------------------------------------------------------
const void* vtkRelievoRayFileReader::TakeBytes(std::size_t& count, std::size_t size)
{
  count = 0;
  if (this->Bytes - this->Place < sizeof(ArrayHeader))
  {
    return nullptr;
  }
  const char* const at = static_cast<const char*>(this->Memory.get()) + this->Place;
  const auto& header = *reinterpret_cast<const ArrayHeader*>(at);
  const std::size_t rest = this->Bytes - this->Place - sizeof(ArrayHeader);
  if (header.Size != size || header.Count > rest / size || PadToBlock(header.Count * size) > rest)
  {
    return nullptr;
  }
  count = header.Count;
  this->Place += sizeof(ArrayHeader) + PadToBlock(header.Count * size);
  return at + sizeof(ArrayHeader);
}
