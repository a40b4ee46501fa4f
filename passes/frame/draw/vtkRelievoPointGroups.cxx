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
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <mutex>
#include <random>

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

struct Box
{
  glm::dvec3 Low{ 0.0 };
  glm::dvec3 High{ 0.0 };
};

// The box of most points: a few far from all others must not make the curve's steps coarse.
template <typename GetPoint>
Box FindBox(const std::vector<Key>& keys, const GetPoint& getPoint)
{
  constexpr std::size_t Samples = 4096;
  constexpr std::size_t OneIn = 1000; // left out at each end
  std::minstd_rand random;            // files may repeat a pattern
  std::array<std::vector<double>, 3> values;
  for (std::size_t i = 0; i < std::min(keys.size(), Samples); ++i)
  {
    const glm::dvec3 point = getPoint(keys[keys.size() > Samples ? random() % keys.size() : i]);
    for (int axis = 0; axis < 3; ++axis)
    {
      if (std::isfinite(point[axis]))
      {
        values[axis].push_back(point[axis]);
      }
    }
  }
  Box box;
  for (int axis = 0; axis < 3; ++axis)
  {
    std::vector<double>& sorted = values[axis];
    std::sort(sorted.begin(), sorted.end());
    if (!sorted.empty())
    {
      const std::size_t left = sorted.size() / OneIn;
      box.Low[axis] = sorted[left];
      box.High[axis] = sorted[sorted.size() - 1 - left];
    }
  }
  return box;
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
  const auto getPoint = [&](const Key& key) {
    glm::dvec3 point;
    data->GetPoint(made.GetPoint(key.Vertex), &point.x);
    return point;
  };

  std::vector<Key> keys;
  keys.reserve(static_cast<std::size_t>(numbers.size()));
  for (unsigned int vertex = 0; vertex < static_cast<unsigned int>(numbers.size()); ++vertex)
  {
    if (made.GetPoint(vertex) < numberOfPoints) // VTK's mapper draws nothing at others
    {
      keys.push_back({ 0, vertex });
    }
  }
  const Box box = FindBox(keys, getPoint);
  for (Key& key : keys)
  {
    const glm::dvec3 point = getPoint(key);
    for (int axis = 0; axis < 3; ++axis)
    {
      const double from = box.Low[axis];
      const double step = 1023.999 * (point[axis] - from) / (box.High[axis] - from);
      key.Code |= Spread(step > 0.0 ? static_cast<std::uint32_t>(std::min(step, 1023.0)) : 0u)
        << axis;
    }
  }
  Sort(keys);

  made.Order.reserve(keys.size());
  made.Places.reserve(keys.size());
  std::array<glm::dvec3, Together> points;
  const glm::dvec3 size = box.High - box.Low;
  const double largest = std::max({ size.x, size.y, size.z }); // floats are exact enough within it
  for (std::size_t first = 0; first < keys.size(); first = made.Groups.back().End)
  {
    vtkRelievoPointGroups::Group group;
    const std::size_t end = std::min(first + Together, keys.size());
    for (group.End = first; group.End < end; ++group.End)
    {
      const glm::dvec3 point = getPoint(keys[group.End]);
      const glm::dvec3 low = glm::min(group.Low, point);
      const glm::dvec3 high = glm::max(group.High, point);
      if (group.End > first && glm::any(glm::greaterThan(high - low, glm::dvec3(largest))))
      {
        break;
      }
      points[group.End - first] = point;
      group.Low = low;
      group.High = high;
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
