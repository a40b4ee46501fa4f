// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShadowExchange.h"

#include "vtkCommunicator.h"
#include "vtkRelievoShadowMaps.h"
#include "vtkRelievoShadowRegion.h"
#include "vtkTimerLog.h"

#include <algorithm>
#include <sstream>

namespace
{
constexpr int Root = 0;

void Put(std::vector<double>& numbers, const std::vector<vtkRelievoBox>& boxes)
{
  numbers.push_back(static_cast<double>(boxes.size()));
  for (const vtkRelievoBox& box : boxes)
  {
    numbers.insert(numbers.end(),
      { static_cast<double>(box.Number), box.Min.x, box.Min.y, box.Min.z, box.Max.x, box.Max.y,
        box.Max.z, box.Loose ? 1.0 : 0.0 });
  }
}

const double* Take(const double* from, std::vector<vtkRelievoBox>& boxes)
{
  const auto count = static_cast<std::size_t>(*from++);
  for (std::size_t i = 0; i < count; ++i, from += 8)
  {
    vtkRelievoBox box;
    box.Number = static_cast<int>(from[0]);
    box.Min = glm::dvec3(from[1], from[2], from[3]);
    box.Max = glm::dvec3(from[4], from[5], from[6]);
    box.Loose = from[7] != 0.0;
    vtkRelievoBox::Join(box, boxes);
  }
  return from;
}

// A single function lists the numbers of a view, for sending and receiving.
template <typename Each>
void ForEachNumber(vtkRelievoShadowCache::Map& map, Each each)
{
  vtkRelievoShadowView& view = map.View;
  for (int i = 0; i < 3; ++i)
  {
    each(view.Position[i]);
    each(view.Forward[i]);
    each(view.Up[i]);
  }
  for (int i = 0; i < 4; ++i)
  {
    for (int j = 0; j < 4; ++j)
    {
      each(view.WorldToView[i][j]);
      each(view.ViewToNDC[i][j]);
    }
  }
  for (double* number : { &view.Near, &view.Far, &view.Texel, &view.Width, &view.Height })
  {
    each(*number);
  }
  for (vtkRelievoMapAxis* axis : { &view.U, &view.V })
  {
    each(axis->Pieces);
    each(axis->Focus);
    each(axis->Ratio);
    for (int i = 0; i <= vtkRelievoMapAxis::MostPieces; ++i)
    {
      each(axis->From[i]);
      each(axis->To[i]);
    }
  }
  each(view.Parallel);
  each(view.NearCut);
  each(view.Side);
  each(map.Layer);
  each(map.Drawn);
}
}

//------------------------------------------------------------------------------
std::vector<int> vtkRelievoShadowExchange::FindCommon(const std::vector<int>& lights)
{
  constexpr int Most = 256; // equal on all processes; more lights do not fit a shader
  std::vector<unsigned char> own(Most, 0);
  for (const int light : lights)
  {
    if (light < Most)
    {
      own[light] = 1;
    }
  }
  std::vector<unsigned char> all(Most, 0);
  this->Controller->AllReduce(own.data(), all.data(), Most, vtkCommunicator::MIN_OP);
  std::vector<int> common;
  for (int i = 0; i < Most; ++i)
  {
    if (all[i])
    {
      common.push_back(i);
    }
  }
  return common;
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowExchange::IsEverywhere(bool here)
{
  const int own = here ? 1 : 0;
  int all = 0;
  this->Controller->AllReduce(&own, &all, 1, vtkCommunicator::MIN_OP);
  return all != 0;
}

//------------------------------------------------------------------------------
void vtkRelievoShadowExchange::Gather(vtkRelievoShadowScene& scene)
{
  this->NewFrame = true;
  std::vector<double> own = { scene.SameCasters ? 1.0 : 0.0,
    static_cast<double>(scene.Request.Size) };
  Put(own, scene.Casters);
  Put(own, scene.Receivers);
  const int processes = this->Controller->GetNumberOfProcesses();
  const auto ownLength = static_cast<vtkIdType>(own.size());
  std::vector<vtkIdType> lengths(processes);
  this->Controller->Gather(&ownLength, lengths.data(), 1, Root);
  std::vector<vtkIdType> offsets(processes + 1, 0);
  for (int i = 0; i < processes; ++i)
  {
    offsets[i + 1] = offsets[i] + lengths[i];
  }
  std::vector<double> all(this->IsRoot() ? offsets.back() : 1);
  this->Controller->GatherV(
    own.data(), all.data(), ownLength, lengths.data(), offsets.data(), Root);
  if (!this->IsRoot())
  {
    return;
  }
  scene.Casters.clear();
  scene.Receivers.clear();
  for (int i = 0; i < processes; ++i)
  {
    const double* from = all.data() + offsets[i];
    scene.SameCasters = scene.SameCasters && from[0] != 0.0;
    scene.Request.Size = std::min(scene.Request.Size, static_cast<int>(from[1]));
    Take(Take(from + 2, scene.Casters), scene.Receivers);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoShadowExchange::Broadcast(std::vector<double>& numbers)
{
  auto length = static_cast<vtkIdType>(numbers.size());
  this->Controller->Broadcast(&length, 1, Root);
  numbers.resize(length);
  this->Controller->Broadcast(numbers.data(), length, Root);
}

//------------------------------------------------------------------------------
void vtkRelievoShadowExchange::Share(
  vtkRelievoShadowCache& cache, const std::vector<vtkRelievoShadowLight>& casting, int& size)
{
  std::vector<double> numbers;
  if (this->IsRoot())
  {
    const glm::dvec3& center = cache.GetCenter();
    numbers = { static_cast<double>(size), center.x, center.y, center.z,
      static_cast<double>(cache.GetEntries().size()) };
    for (auto& entry : cache.GetEntries())
    {
      numbers.push_back(entry.Cube ? 1.0 : 0.0);
      numbers.push_back(static_cast<double>(entry.Maps.size()));
      for (auto& map : entry.Maps)
      {
        ForEachNumber(map, [&numbers](auto number) { numbers.push_back(number); });
      }
    }
  }
  this->Broadcast(numbers);
  if (this->IsRoot())
  {
    return;
  }
  const double* from = numbers.data();
  size = static_cast<int>(*from++);
  const glm::dvec3 center(from[0], from[1], from[2]);
  from += 3;
  std::vector<vtkRelievoShadowCache::Entry> entries(static_cast<std::size_t>(*from++));
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    if (i < casting.size())
    {
      entries[i].Light = casting[i];
    }
    entries[i].Cube = *from++ != 0.0;
    entries[i].Maps.resize(static_cast<std::size_t>(*from++));
    for (auto& map : entries[i].Maps)
    {
      ForEachNumber(map, [&from](auto& number) {
        number = static_cast<std::remove_reference_t<decltype(number)>>(*from++);
      });
    }
  }
  cache.SetEntries(std::move(entries), center);
}

//------------------------------------------------------------------------------
void vtkRelievoShadowExchange::Agree(vtkRelievoShadowCache& cache)
{
  std::vector<int> drawn;
  for (auto& entry : cache.GetEntries())
  {
    for (auto& map : entry.Maps)
    {
      drawn.push_back(map.Drawn ? 1 : 0);
    }
  }
  std::vector<int> everywhere(drawn.size());
  if (!drawn.empty())
  {
    this->Controller->AllReduce(drawn.data(), everywhere.data(),
      static_cast<vtkIdType>(drawn.size()), vtkCommunicator::MIN_OP);
  }
  auto next = everywhere.begin();
  for (auto& entry : cache.GetEntries())
  {
    for (auto& map : entry.Maps)
    {
      map.Drawn = *next++ != 0;
    }
  }
}

//------------------------------------------------------------------------------
void vtkRelievoShadowExchange::Merge(vtkRelievoShadowMaps& maps, int layer)
{
  maps.Read(this->Own); // waits for the drawing, which must not count as merging
  const double start = vtkTimerLog::GetUniversalTime();
  this->Least.resize(this->Own.size());
  this->Controller->AllReduce(this->Own.data(), this->Least.data(),
    static_cast<vtkIdType>(this->Own.size()), vtkCommunicator::MIN_OP);
  maps.Write(layer, this->Least);
  this->Seconds = (this->NewFrame ? 0.0 : this->Seconds) + vtkTimerLog::GetUniversalTime() - start;
  this->Merged = (this->NewFrame ? 0 : this->Merged) + 1;
  this->NewFrame = false;
}

//------------------------------------------------------------------------------
std::string vtkRelievoShadowExchange::GetReport() const
{
  if (!this->IsOn())
  {
    return {};
  }
  std::ostringstream out;
  out << ", merged over " << this->Controller->GetNumberOfProcesses() << " processes";
  if (this->Merged)
  {
    out << " (" << 1000.0 * this->Seconds << " ms for the last " << this->Merged << ")";
  }
  return out.str();
}
