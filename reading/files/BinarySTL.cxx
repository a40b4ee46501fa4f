// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BinarySTL.h"

#include "vtkByteSwap.h"
#include "vtkCellArray.h"
#include "vtkErrorCode.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRelievoReserve.h"
#include "vtkTypeInt32Array.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <vector>

namespace reading
{
vtkStandardNewMacro(BinarySTL);

namespace
{
using Place = std::array<float, 3>;

// Numbers distinct places in order of first use.
class Places
{
public:
  explicit Places(vtkFloatArray* points)
    : Points(points)
    , Slots(1024, None)
  {
  }

  // NaN equals no number.
  std::int32_t Find(const Place& place)
  {
    const std::size_t mask = this->Slots.size() - 1;
    std::size_t slot = Hash(place) & mask;
    for (; this->Slots[slot] != None; slot = (slot + 1) & mask)
    {
      if (this->Get(this->Slots[slot]) == place)
      {
        return this->Slots[slot];
      }
    }
    this->Slots[slot] = this->Count;
    this->Points->InsertNextTypedTuple(place.data());
    if (2 * static_cast<std::size_t>(this->Count) > this->Slots.size())
    {
      this->Grow();
    }
    return this->Count++;
  }

private:
  static constexpr std::int32_t None = -1;

  Place Get(std::int32_t number) const
  {
    Place place;
    std::copy_n(this->Points->GetPointer(3 * static_cast<vtkIdType>(number)), 3, place.begin());
    return place;
  }

  static std::size_t Hash(const Place& place)
  {
    constexpr std::uint64_t mix = 0x9e3779b97f4a7c15u; // 2^64 over the golden ratio
    std::uint64_t hash = 0;
    for (const float coordinate : place)
    {
      const float positive = coordinate + 0.f; // turns a negative zero into zero
      std::uint32_t bits = 0;
      std::memcpy(&bits, &positive, sizeof bits);
      hash = (hash ^ (hash >> 29) ^ bits) * mix;
    }
    return static_cast<std::size_t>(hash ^ (hash >> 32));
  }

  void Grow()
  {
    this->Slots.assign(2 * this->Slots.size(), None);
    const std::size_t mask = this->Slots.size() - 1;
    for (std::int32_t number = 0; number <= this->Count; ++number)
    {
      std::size_t slot = Hash(this->Get(number)) & mask;
      while (this->Slots[slot] != None)
      {
        slot = (slot + 1) & mask;
      }
      this->Slots[slot] = number;
    }
  }

  vtkFloatArray* const Points;
  std::vector<std::int32_t> Slots; // size a power of two, at most half full
  std::int32_t Count = 0;
};
}

//------------------------------------------------------------------------------
int BinarySTL::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkPolyData* const output = vtkPolyData::GetData(outputs);
  this->SetErrorCode(vtkErrorCode::NoError);
  std::ifstream file(this->FileName, std::ios::binary);
  file.seekg(HeadSize);
  std::error_code error;
  const auto size = static_cast<std::size_t>(std::filesystem::file_size(this->FileName, error));
  if (!file || error || size < HeadSize)
  {
    this->SetErrorCode(vtkErrorCode::CannotOpenFileError);
    return 1;
  }
  const std::size_t count = (size - HeadSize) / TriangleSize;
  vtkNew<vtkFloatArray> points;
  points->SetNumberOfComponents(3);
  relievo::Reserve(
    points, 3 * static_cast<vtkIdType>(count / 2 + 3)); // the number of points in a closed surface
  vtkNew<vtkTypeInt32Array> starts, corners;
  relievo::Reserve(starts, static_cast<vtkIdType>(count) + 1);
  relievo::Reserve(corners, 3 * static_cast<vtkIdType>(count));
  starts->InsertNextValue(0);
  Places places(points);
  std::vector<char> block(TriangleSize << 16);
  for (std::size_t done = 0; done < count && !this->GetAbortExecute();)
  {
    const std::size_t now = std::min(count - done, block.size() / TriangleSize);
    if (!file.read(block.data(), static_cast<std::streamsize>(now * TriangleSize)))
    {
      this->SetErrorCode(vtkErrorCode::PrematureEndOfFileError);
      return 1;
    }
    for (std::size_t i = 0; i < now; ++i)
    {
      std::int32_t triangle[3];
      for (std::size_t corner = 0; corner < 3; ++corner)
      {
        Place place; // the place follows the normal
        std::memcpy(place.data(), &block[i * TriangleSize + 12 * (corner + 1)], sizeof place);
        vtkByteSwap::Swap4LERange(place.data(), place.size());
        triangle[corner] = places.Find(place);
      }
      if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0])
      {
        for (const std::int32_t corner : triangle)
        {
          corners->InsertNextValue(corner);
        }
        starts->InsertNextValue(static_cast<std::int32_t>(corners->GetNumberOfValues()));
      }
    }
    done += now;
    this->UpdateProgress(static_cast<double>(done) / static_cast<double>(count));
  }
  vtkNew<vtkPoints> all;
  all->SetData(points);
  output->SetPoints(all);
  vtkNew<vtkCellArray> triangles;
  triangles->SetData(starts.Get(), corners.Get());
  output->SetPolys(triangles);
  output->Squeeze();
  return 1;
}
}
