// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoBytes.h"

#include "vtkDataObject.h"
#include "vtkRelievoDataBytes.h"

#include <cstring>

namespace relievo
{
//------------------------------------------------------------------------------
ByteWriter::ByteWriter(const Give& give)
  : Giving(give)
{
}

//------------------------------------------------------------------------------
void ByteWriter::PutBytes(const void* bytes, std::size_t size)
{
  constexpr std::size_t most = 1 << 16; // bytes gathered before they are written
  const char* begin = static_cast<const char*>(bytes);
  if (size > most || this->Buffer.size() + size > most)
  {
    this->Flush();
  }
  if (size > most)
  {
    this->Giving(begin, size);
  }
  else if (size > 0)
  {
    this->Buffer.insert(this->Buffer.end(), begin, begin + size);
  }
}

//------------------------------------------------------------------------------
void ByteWriter::Flush()
{
  this->Giving(this->Buffer.data(), this->Buffer.size());
  this->Buffer.clear();
}

//------------------------------------------------------------------------------
std::int64_t ByteWriter::FindNumber(const void* object)
{
  const auto [found, isNew] =
    this->Numbers.emplace(object, static_cast<std::int64_t>(this->Numbers.size()));
  return isNew ? -1 : found->second;
}

//------------------------------------------------------------------------------
void ByteWriter::PutObject(vtkDataObject* data)
{
  PutData(*this, data);
}

//------------------------------------------------------------------------------
ByteReader::ByteReader(const void* bytes, std::size_t size)
  : At(static_cast<const char*>(bytes))
  , End(At + size)
{
}

//------------------------------------------------------------------------------
void ByteReader::Refuse()
{
  throw std::runtime_error("the reader's result is damaged");
}

//------------------------------------------------------------------------------
const char* ByteReader::Take(std::size_t size)
{
  if (size > static_cast<std::size_t>(this->End - this->At))
  {
    Refuse();
  }
  const char* taken = this->At;
  this->At += size;
  return taken;
}

//------------------------------------------------------------------------------
void ByteReader::GetBytes(void* bytes, std::size_t size)
{
  const char* taken = this->Take(size);
  if (size > 0)
  {
    std::memcpy(bytes, taken, size);
  }
}

//------------------------------------------------------------------------------
std::size_t ByteReader::GetCount(std::size_t each)
{
  std::uint64_t count = 0;
  this->GetBytes(&count, sizeof count);
  if (count > static_cast<std::uint64_t>(this->End - this->At) / each)
  {
    Refuse();
  }
  return static_cast<std::size_t>(count);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> ByteReader::GetObject()
{
  return GetData(*this);
}
}
