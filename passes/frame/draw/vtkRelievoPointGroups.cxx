// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoPointGroups.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkRelievoHiddenPoints.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <mutex>

namespace
{
constexpr std::size_t Together = 64; // points of a group

// Spreads ten bits to every third.
std::uint32_t Spread(std::uint32_t bits)
{
  bits = (bits | (bits << 16)) & 0x030000FFu;
  bits = (bits | (bits << 8)) & 0x0300F00Fu;
  bits = (bits | (bits << 4)) & 0x030C30C3u;
  return (bits | (bits << 2)) & 0x09249249u;
}

// A place on the Z-order curve, and the vertex there.
struct Key
{
  std::uint32_t Code;
  unsigned int Vertex;
};

// By three digits of ten bits, the least first.
void Sort(std::vector<Key>& keys)
{
  constexpr unsigned int Digit = 0x3FFu;
  std::vector<Key> sorted(keys.size());
  for (int shift = 0; shift < 30; shift += 10)
  {
    std::array<std::size_t, Digit + 2> first{};
    for (const Key& key : keys)
    {
      ++first[((key.Code >> shift) & Digit) + 1];
    }
    for (std::size_t i = 1; i < first.size(); ++i)
    {
      first[i] += first[i - 1];
    }
    for (const Key& key : keys)
    {
      sorted[first[(key.Code >> shift) & Digit]++] = key;
    }
    keys.swap(sorted);
  }
}

vtkRelievoPointGroups::Mesh Make(vtkPolyData* data)
{
  vtkRelievoPointGroups::Mesh made;
  const vtkIdType numberOfPoints = data->GetNumberOfPoints();
  const auto numbers = vtk::DataArrayValueRange<1>(data->GetVerts()->GetConnectivityArray());
  bool counts = true;
  vtkIdType next = 0;
  for (const vtkIdType number : numbers)
  {
    counts = counts && number == next++;
  }
  if (!counts || numbers.size() > numberOfPoints)
  {
    made.Points.assign(numbers.begin(), numbers.end());
  }
  const auto getPoint = [&](unsigned int vertex) {
    glm::dvec3 point;
    data->GetPoint(made.GetPoint(vertex), &point.x);
    return point;
  };

  double bounds[6];
  data->GetPoints()->GetBounds(bounds);
  std::vector<Key> keys;
  keys.reserve(static_cast<std::size_t>(numbers.size()));
  for (unsigned int vertex = 0; vertex < static_cast<unsigned int>(numbers.size()); ++vertex)
  {
    if (made.GetPoint(vertex) >= numberOfPoints)
    {
      continue; // VTK's mapper draws nothing there
    }
    const glm::dvec3 point = getPoint(vertex);
    std::uint32_t code = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double from = bounds[2 * axis];
      const double step = 1023.999 * (point[axis] - from) / (bounds[2 * axis + 1] - from);
      code |= Spread(step > 0.0 ? static_cast<std::uint32_t>(std::min(step, 1023.0)) : 0u) << axis;
    }
    keys.push_back({ code, vertex });
  }
  Sort(keys);

  made.Order.reserve(keys.size());
  made.Places.reserve(keys.size());
  std::array<glm::dvec3, Together> points;
  for (std::size_t first = 0; first < keys.size(); first += Together)
  {
    vtkRelievoPointGroups::Group group;
    group.End = std::min(first + Together, keys.size());
    for (std::size_t i = first; i < group.End; ++i)
    {
      points[i - first] = getPoint(keys[i].Vertex);
      group.Low = glm::min(group.Low, points[i - first]);
      group.High = glm::max(group.High, points[i - first]);
    }
    for (std::size_t i = first; i < group.End; ++i)
    {
      made.Order.push_back(keys[i].Vertex);
      made.Places.emplace_back(points[i - first] - group.Low);
    }
    made.Groups.push_back(group);
  }
  return made;
}
}

//------------------------------------------------------------------------------
vtkRelievoPointGroups::Key::Key(vtkPolyData* mesh)
  : Points(mesh->GetPoints())
  , Verts(mesh->GetVerts())
  , Time(std::max(this->Points->GetMTime(), this->Verts->GetMTime()))
{
}

//------------------------------------------------------------------------------
bool vtkRelievoPointGroups::Key::operator==(const Key& other) const
{
  return this->Points == other.Points && this->Verts == other.Verts && this->Time == other.Time;
}

//------------------------------------------------------------------------------
std::shared_ptr<const vtkRelievoPointGroups::Mesh> vtkRelievoPointGroups::Share(
  vtkPolyData* mesh, const Key& key)
{
  static std::mutex access;
  static std::vector<Entry<std::weak_ptr<const Mesh>>> all;
  const std::lock_guard<std::mutex> lock(access);
  all.erase(
    std::remove_if(all.begin(), all.end(), [](const auto& entry) { return entry.Made.expired(); }),
    all.end());
  for (const auto& entry : all)
  {
    std::shared_ptr<const Mesh> made = entry.Made.lock();
    if (made && entry.Of == key)
    {
      return made;
    }
  }
  std::shared_ptr<const Mesh> made = std::make_shared<Mesh>(Make(mesh));
  all.push_back({ key, made });
  return made;
}

//------------------------------------------------------------------------------
const vtkRelievoPointGroups::Mesh& vtkRelievoPointGroups::Get(vtkPolyData* mesh)
{
  const Key key(mesh);
  for (const auto& entry : this->Meshes)
  {
    if (entry.Of == key)
    {
      return *entry.Made;
    }
  }
  this->Meshes.push_back({ key, Share(mesh, key) });
  return *this->Meshes.back().Made;
}

//------------------------------------------------------------------------------
void vtkRelievoPointGroups::KeepOnly(const std::vector<vtkProp*>& props)
{
  const auto isUnused = [&props](const auto& entry) {
    return std::none_of(props.begin(), props.end(), [&entry](vtkProp* prop) {
      return vtkRelievoHiddenPoints::IsPossible(prop) &&
        Key(
          static_cast<vtkPolyDataMapper*>(static_cast<vtkActor*>(prop)->GetMapper())->GetInput()) ==
        entry.Of;
    });
  };
  this->Meshes.erase(
    std::remove_if(this->Meshes.begin(), this->Meshes.end(), isUnused), this->Meshes.end());
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoPointGroups::GetBytes() const
{
  const auto getBytes = [](const auto& array) { return array.capacity() * sizeof(*array.data()); };
  std::size_t bytes = 0;
  for (const auto& entry : this->Meshes)
  {
    const Mesh& made = *entry.Made;
    bytes += (getBytes(made.Order) + getBytes(made.Places) + getBytes(made.Points) +
               getBytes(made.Groups)) /
      static_cast<std::size_t>(entry.Made.use_count());
  }
  return static_cast<vtkIdType>(bytes);
}
