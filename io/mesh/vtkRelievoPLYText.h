// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoPLYText.h
 * @brief Reads the bytes of a PLY file into tables; private to vtkRelievoPLYReader.
 */
#ifndef vtkRelievoPLYText_h
#define vtkRelievoPLYText_h

#include "vtkRelievoMeshText.h"
#include "vtkSetGet.h" // for vtkTemplateMacro
#include "vtkType.h"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace relievo::ply
{
// Numbers of one of VTK's types, whose memory can be passed on.
class Numbers
{
public:
  Numbers() = default;
  Numbers(Numbers&& other) noexcept { *this = std::move(other); }
  Numbers& operator=(Numbers&& other) noexcept
  {
    std::swap(this->Of, other.Of);
    std::swap(this->Each, other.Each);
    std::swap(this->Bytes, other.Bytes);
    std::swap(this->Size, other.Size);
    std::swap(this->Room, other.Room);
    return *this;
  }
  ~Numbers() { std::free(this->Bytes); }

  // To be called while there are no numbers.
  void SetType(int type, std::size_t size)
  {
    this->Of = type;
    this->Each = size;
  }
  int GetType() const { return this->Of; }
  std::size_t GetSize() const { return this->Size; }

  void Reserve(std::size_t count);

  // Adds room for so many numbers, and returns its address.
  void* Add(std::size_t count)
  {
    if (count > this->Room - this->Size)
    {
      this->Reserve(std::max(this->Size + count, 2 * this->Room));
    }
    this->Size += count;
    return this->Bytes + (this->Size - count) * this->Each;
  }

  double Get(std::size_t index) const
  {
    switch (this->Of)
    {
      vtkTemplateMacro(return static_cast<double>(this->As<VTK_TT>()[index]));
      default:
        return 0.;
    }
  }

  template <typename Number>
  const Number* As() const
  {
    return reinterpret_cast<const Number*>(this->Bytes);
  }

  // Passes the memory on: the caller must free it.
  void* Release();

private:
  int Of = VTK_DOUBLE;
  std::size_t Each = sizeof(double);
  char* Bytes = nullptr;
  std::size_t Size = 0;
  std::size_t Room = 0;
};

// A property of an element with its numbers: one per element, or concatenated lists.
struct Column
{
  std::string Name;
  int Type = 0;         // of VTK
  int CountType = 0;    // of lists; 0: no list
  std::size_t Size = 0; // of a number, and of a list's length, in bytes
  std::size_t CountSize = 0;
  bool Stored = true;
  Numbers Values; // of the property's type or, from text, doubles
  // Lists: their common size, -1 before the first list; if sizes differ, 0, and Starts has the
  // beginning of each list and the end.
  vtkIdType ListSize = -1;
  std::vector<vtkIdType> Starts;

  // The beginning of a list that has been read.
  vtkIdType GetStart(vtkIdType list) const
  {
    return this->Starts.empty() ? list * this->ListSize
                                : this->Starts[static_cast<std::size_t>(list)];
  }

  // Ends a list with the last `size` values.
  void EndList(vtkIdType list, vtkIdType size)
  {
    if (this->ListSize < 0)
    {
      this->ListSize = size;
    }
    if (this->Starts.empty() && size == this->ListSize)
    {
      return;
    }
    for (auto each = static_cast<vtkIdType>(this->Starts.size()); each <= list; ++each)
    {
      this->Starts.push_back(each * this->ListSize); // of the lists before
    }
    this->ListSize = 0;
    this->Starts.push_back(static_cast<vtkIdType>(this->Values.GetSize()));
  }
};

struct Element
{
  std::string Name;
  vtkIdType Count = 0;
  std::vector<Column> Columns;

  Column* Find(const std::string& name)
  {
    for (Column& column : this->Columns)
    {
      if (column.Name == name)
      {
        return &column;
      }
    }
    return nullptr;
  }
};

struct Content
{
  std::vector<Element> Elements;
  std::vector<std::string> Textures; // names of files, from the comments TextureFile

  Element* Find(const std::string& name)
  {
    for (Element& element : this->Elements)
    {
      if (element.Name == name)
      {
        return &element;
      }
    }
    return nullptr;
  }
};

// Reads the elements `vertex`, `face`, `tristrips` and `edge`, or throws a Refusal. `goOn` is
// called regularly with the share done; if it returns false, the content read so far is returned.
Content Read(std::string_view text, const std::function<bool(double)>& goOn);
}

#endif
// VTK-HeaderTest-Exclude: vtkRelievoPLYText.h
