// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Values as bytes for another process of the same program, which has the same types in memory.
#ifndef vtkRelievoBytes_h
#define vtkRelievoBytes_h

#include "vtkObjectBase.h"      // for objects that are read
#include "vtkRelievoIOModule.h" // for the export macro
#include "vtkSmartPointer.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <valarray>
#include <vector>

class vtkDataObject;

namespace relievo
{
// Types with a function `VisitFields(value, visit)`, which calls visit with all members, are
// written through it.
template <typename Value, typename = void>
struct HasFields : std::false_type
{
};
template <typename Value>
struct HasFields<Value,
  std::void_t<decltype(VisitFields(std::declval<Value&>(), std::declval<void (*)(...)>()))>>
  : std::true_type
{
};

// Bytes without ownership: those read are the reader's.
struct ByteSpan
{
  const char* Data = nullptr;
  std::size_t Size = 0;
};

// Writes bytes, passing them on in batches.
class VTKRELIEVOIO_EXPORT ByteWriter
{
public:
  using Give = std::function<void(const char* bytes, std::size_t size)>;
  explicit ByteWriter(const Give& give);
  ByteWriter(const ByteWriter&) = delete;
  void operator=(const ByteWriter&) = delete;

  void PutBytes(const void* bytes, std::size_t size);
  void Flush();

  template <typename... Values>
  void operator()(const Values&... values)
  {
    (this->Put(values), ...);
  }

  // The number of an object already written; -1: not written yet, it gets the next number.
  std::int64_t FindNumber(const void* object);

private:
  void Put(const std::string& text)
  {
    this->Put(static_cast<std::uint64_t>(text.size()));
    this->PutBytes(text.data(), text.size());
  }

  template <typename Value>
  void Put(const std::vector<Value>& values)
  {
    this->Put(static_cast<std::uint64_t>(values.size()));
    if constexpr (std::is_trivially_copyable_v<Value>)
    {
      this->PutBytes(values.data(), values.size() * sizeof(Value));
    }
    else
    {
      for (const Value& value : values)
      {
        this->Put(value);
      }
    }
  }

  void Put(const std::valarray<double>& values)
  {
    this->Put(static_cast<std::uint64_t>(values.size()));
    this->PutBytes(values.size() > 0 ? &values[0] : nullptr, values.size() * sizeof(double));
  }

  template <typename Value>
  void Put(const std::optional<Value>& value)
  {
    this->Put(value.has_value());
    if (value)
    {
      this->Put(*value);
    }
  }

  template <typename Value>
  void Put(const std::map<std::string, Value>& values)
  {
    this->Put(static_cast<std::uint64_t>(values.size()));
    for (const auto& [name, value] : values)
    {
      this->Put(name);
      this->Put(value);
    }
  }

  void Put(const ByteSpan& span)
  {
    this->Put(static_cast<std::uint64_t>(span.Size));
    this->PutBytes(span.Data, span.Size);
  }

  template <typename Data>
  void Put(const vtkSmartPointer<Data>& data)
  {
    this->PutObject(data);
  }
  void PutObject(vtkDataObject* data);

  template <typename Value>
  void Put(const Value& value)
  {
    if constexpr (HasFields<Value>::value)
    {
      VisitFields(const_cast<Value&>(value), [this](const auto&... each) { (*this)(each...); });
    }
    else
    {
      static_assert(std::is_trivially_copyable_v<Value> && !std::is_pointer_v<Value>);
      this->PutBytes(&value, sizeof value);
    }
  }

  Give Giving;
  std::vector<char> Buffer;
  std::map<const void*, std::int64_t> Numbers;
};

// Reads the output of a ByteWriter. Never reads beyond the given bytes, whatever they contain: it
// throws std::runtime_error instead.
class VTKRELIEVOIO_EXPORT ByteReader
{
public:
  ByteReader(const void* bytes, std::size_t size);
  ByteReader(const ByteReader&) = delete;
  void operator=(const ByteReader&) = delete;

  void GetBytes(void* bytes, std::size_t size);
  // The address of the next bytes, which are then skipped.
  const char* Take(std::size_t size);
  std::size_t GetLeft() const { return static_cast<std::size_t>(this->End - this->At); }
  // A number of items that take at least `each` bytes each.
  std::size_t GetCount(std::size_t each);

  template <typename... Values>
  void operator()(Values&... values)
  {
    (this->Get(values), ...);
  }

  template <typename Value>
  Value Get()
  {
    Value value{};
    this->Get(value);
    return value;
  }

  // The objects read so far, by number.
  std::vector<vtkSmartPointer<vtkObjectBase>> Objects;

  [[noreturn]] static void Refuse();

private:
  void Get(std::string& text)
  {
    const std::size_t size = this->GetCount(1);
    text.assign(this->Take(size), size);
  }

  void Get(bool& value)
  {
    unsigned char byte = 0;
    this->GetBytes(&byte, 1);
    value = byte != 0;
  }

  template <typename Value>
  void Get(std::vector<Value>& values)
  {
    constexpr bool plain = std::is_trivially_copyable_v<Value>;
    values.resize(this->GetCount(plain ? sizeof(Value) : 1));
    if constexpr (plain)
    {
      this->GetBytes(values.data(), values.size() * sizeof(Value));
    }
    else
    {
      for (Value& value : values)
      {
        this->Get(value);
      }
    }
  }

  void Get(std::valarray<double>& values)
  {
    values.resize(this->GetCount(sizeof(double)));
    this->GetBytes(values.size() > 0 ? &values[0] : nullptr, values.size() * sizeof(double));
  }

  template <typename Value>
  void Get(std::optional<Value>& value)
  {
    value.reset();
    if (this->Get<bool>())
    {
      this->Get(value.emplace());
    }
  }

  template <typename Value>
  void Get(std::map<std::string, Value>& values)
  {
    values.clear();
    for (std::size_t count = this->GetCount(1); count > 0; --count)
    {
      std::string name;
      this->Get(name);
      this->Get(values[name]);
    }
  }

  void Get(ByteSpan& span)
  {
    span.Size = this->GetCount(1);
    span.Data = this->Take(span.Size);
  }

  template <typename Data>
  void Get(vtkSmartPointer<Data>& data)
  {
    data = Data::SafeDownCast(this->GetObject());
  }
  vtkSmartPointer<vtkDataObject> GetObject();

  template <typename Value>
  void Get(Value& value)
  {
    if constexpr (HasFields<Value>::value)
    {
      VisitFields(value, [this](auto&... each) { (*this)(each...); });
    }
    else
    {
      static_assert(std::is_trivially_copyable_v<Value> && !std::is_pointer_v<Value>);
      this->GetBytes(&value, sizeof value);
    }
  }

  const char* At;
  const char* End;
};
}

#endif
