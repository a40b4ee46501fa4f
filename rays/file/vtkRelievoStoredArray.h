// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Values in memory of their own, or in that of a file.
#ifndef vtkRelievoStoredArray_h
#define vtkRelievoStoredArray_h

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

template <typename Value>
class vtkRelievoStoredArray
{
public:
  vtkRelievoStoredArray() = default;
  vtkRelievoStoredArray(const vtkRelievoStoredArray& other) { *this = other; }
  vtkRelievoStoredArray& operator=(const vtkRelievoStoredArray& other)
  {
    this->Set(std::vector<Value>(other.begin(), other.end()));
    return *this;
  }
  vtkRelievoStoredArray(vtkRelievoStoredArray&& other) noexcept { *this = std::move(other); }
  vtkRelievoStoredArray& operator=(vtkRelievoStoredArray&& other) noexcept
  {
    this->Own = std::move(other.Own);
    this->File = std::move(other.File);
    this->First = std::exchange(other.First, nullptr);
    this->Count = std::exchange(other.Count, 0);
    return *this;
  }

  const Value* data() const { return this->First; }
  std::size_t size() const { return this->Count; }
  bool empty() const { return this->Count == 0; }
  const Value& operator[](std::size_t i) const { return this->First[i]; }
  const Value* begin() const { return this->First; }
  const Value* end() const { return this->First + this->Count; }
  std::size_t GetBytes() const
  {
    return (this->File ? this->Count : this->Own.capacity()) * sizeof(Value);
  }

  // Moves the values out, to change them; copies those of a file.
  std::vector<Value> Release()
  {
    std::vector<Value> values =
      this->File ? std::vector<Value>(this->begin(), this->end()) : std::move(this->Own);
    this->Set({});
    return values;
  }

  void Set(std::vector<Value> values)
  {
    this->File = nullptr;
    this->Own = std::move(values);
    this->First = this->Own.data();
    this->Count = this->Own.size();
  }

  // `file` keeps the values in memory.
  void Map(std::shared_ptr<const void> file, const Value* first, std::size_t count)
  {
    this->Set({});
    this->File = std::move(file);
    this->First = first;
    this->Count = count;
  }

private:
  std::vector<Value> Own;
  std::shared_ptr<const void> File;
  const Value* First = nullptr;
  std::size_t Count = 0;
};

#endif
