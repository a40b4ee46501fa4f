// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Files of trees for rays: a header, and arrays one after the other, each aligned for use in the
// mapped file.
//
// Header, 64 bytes: "RELIEVO" and a zero, version (32 bits), 0x01020304 in the byte order of the
// machine that wrote the file (32 bits), number of bytes of the file, vtkRelievoRayHash of all
// bytes after the header, zeros. Array, from a multiple of 64: number of values, bytes of a value
// (64 bits each), zeros up to 64 bytes, the values, zeros up to a multiple of 64.
#ifndef vtkRelievoRayFile_h
#define vtkRelievoRayFile_h

#include "vtkRelievoRayHash.h"
#include "vtkRelievoRaysModule.h" // for the export macro
#include "vtkRelievoStoredArray.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

class VTKRELIEVORAYS_EXPORT vtkRelievoRayFileWriter
{
public:
  // Writes beside the file, which Finish() replaces.
  explicit vtkRelievoRayFileWriter(const std::string& path);
  ~vtkRelievoRayFileWriter();
  vtkRelievoRayFileWriter(const vtkRelievoRayFileWriter&) = delete;
  void operator=(const vtkRelievoRayFileWriter&) = delete;

  template <typename Value>
  void Put(const Value* values, std::size_t count)
  {
    static_assert(std::is_trivially_copyable<Value>::value, "bytes are written");
    this->PutBytes(values, count, sizeof(Value));
  }
  template <typename Values>
  void Put(const Values& values)
  {
    this->Put(values.data(), values.size());
  }

  // Returns the reason of a failure; empty: none.
  std::string Finish();

private:
  void PutBytes(const void* values, std::size_t count, std::size_t size);
  void Append(const void* bytes, std::size_t count);
  void WriteBytes(const void* bytes, std::size_t count);

  std::string Path;
  std::string Temporary;
  std::FILE* Out = nullptr;
  std::uint64_t Bytes = 0;
  int Reason = 0; // of the first failure, of errno
  vtkRelievoRayHash Hash;
};

class VTKRELIEVORAYS_EXPORT vtkRelievoRayFileReader
{
public:
  // Maps the file into memory. Returns why it cannot be used; empty: it can.
  std::string Open(const std::string& path);

  // The next array. False if there is none of such values.
  template <typename Value>
  bool Take(const Value*& values, std::size_t& count)
  {
    values = static_cast<const Value*>(this->TakeBytes(count, sizeof(Value)));
    return values != nullptr;
  }
  template <typename Value>
  bool Take(vtkRelievoStoredArray<Value>& values)
  {
    const Value* first = nullptr;
    std::size_t count = 0;
    const bool taken = this->Take(first, count);
    values.Map(this->Memory, first, count);
    return taken;
  }
  template <typename Value>
  bool Take(std::vector<Value>& values)
  {
    const Value* first = nullptr;
    std::size_t count = 0;
    const bool taken = this->Take(first, count);
    values.assign(first, first + (taken ? count : 0));
    return taken;
  }

  bool IsAtEnd() const { return this->Place == this->Bytes; }
  const std::shared_ptr<const void>& GetMemory() const { return this->Memory; }

private:
  const void* TakeBytes(std::size_t& count, std::size_t size);

  std::shared_ptr<const void> Memory; // of the whole file
  std::size_t Bytes = 0;
  std::size_t Place = 0;
};

#endif
