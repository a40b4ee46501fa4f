// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoRayFile.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

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
  , Temporary(path + "." + std::to_string(getpid()) + ".tmp")
  , Out(this->Temporary, std::ios::binary)
{
  const Header nothing{};
  this->Append(&nothing, sizeof(nothing));
}

//------------------------------------------------------------------------------
vtkRelievoRayFileWriter::~vtkRelievoRayFileWriter()
{
  this->Out.close();
  std::error_code trouble;
  std::filesystem::remove(this->Temporary, trouble);
}

//------------------------------------------------------------------------------
void vtkRelievoRayFileWriter::Append(const void* bytes, std::size_t count)
{
  static const char zeros[Block] = {};
  const std::size_t padded = PadToBlock(count);
  this->Out.write(static_cast<const char*>(bytes), static_cast<std::streamsize>(count));
  this->Out.write(zeros, static_cast<std::streamsize>(padded - count));
  this->Reason = this->Reason == 0 && !this->Out ? errno : this->Reason;
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
  this->Out.seekp(0);
  this->Out.write(reinterpret_cast<const char*>(&header), sizeof(header));
  this->Out.close();
  this->Reason = this->Reason == 0 && !this->Out ? errno : this->Reason;
  if (!this->Out)
  {
    return this->Path + ": cannot be written: " + std::strerror(this->Reason);
  }
  std::error_code trouble;
  std::filesystem::rename(this->Temporary, this->Path, trouble);
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
