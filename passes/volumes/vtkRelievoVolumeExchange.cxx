// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoVolumeExchange.h"

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"

#include <algorithm>

namespace
{
constexpr int Root = 0;
constexpr int Header = 12; // numbers of an extent before its corners
}

//------------------------------------------------------------------------------
vtkRelievoVolumeExchange::vtkRelievoVolumeExchange(vtkMultiProcessController* controller)
  : Controller(controller)
{
}

//------------------------------------------------------------------------------
vtkRelievoVolumeExchange::~vtkRelievoVolumeExchange() = default;

//------------------------------------------------------------------------------
bool vtkRelievoVolumeExchange::IsOn() const
{
  return this->Controller && this->Controller->GetNumberOfProcesses() > 1;
}

//------------------------------------------------------------------------------
int vtkRelievoVolumeExchange::Reduce(int here, int operation)
{
  int all = here;
  if (this->IsOn())
  {
    this->Controller->AllReduce(&here, &all, 1, operation);
  }
  return all;
}

//------------------------------------------------------------------------------
bool vtkRelievoVolumeExchange::IsAnywhere(bool here)
{
  return this->Reduce(here ? 1 : 0, vtkCommunicator::MAX_OP) != 0;
}

//------------------------------------------------------------------------------
int vtkRelievoVolumeExchange::GetLeast(int here)
{
  return this->Reduce(here, vtkCommunicator::MIN_OP);
}

//------------------------------------------------------------------------------
int vtkRelievoVolumeExchange::GetMost(int here)
{
  return this->Reduce(here, vtkCommunicator::MAX_OP);
}

//------------------------------------------------------------------------------
void vtkRelievoVolumeExchange::TakeFirst(std::vector<double>& numbers)
{
  if (this->IsOn())
  {
    this->Controller->Broadcast(numbers.data(), static_cast<vtkIdType>(numbers.size()), Root);
  }
}

//------------------------------------------------------------------------------
vtkRelievoOpticalDepths::Extent vtkRelievoVolumeExchange::Join(
  const vtkRelievoOpticalDepths::Extent& own, std::vector<glm::dvec3>& others)
{
  others.clear();
  if (!this->IsOn())
  {
    return own;
  }
  std::vector<double> numbers = { static_cast<double>(own.Corners.size()), own.Spacing,
    own.Tinted ? 1.0 : 0.0 };
  for (int i = 0; i < 3; ++i)
  {
    numbers.insert(numbers.end(), { own.Axes[i].x, own.Axes[i].y, own.Axes[i].z });
  }
  for (const glm::dvec3& corner : own.Corners)
  {
    numbers.insert(numbers.end(), { corner.x, corner.y, corner.z });
  }
  const int processes = this->Controller->GetNumberOfProcesses();
  const auto length = static_cast<vtkIdType>(numbers.size());
  std::vector<vtkIdType> lengths(processes);
  this->Controller->AllGather(&length, lengths.data(), 1);
  std::vector<vtkIdType> offsets(processes + 1, 0);
  for (int i = 0; i < processes; ++i)
  {
    offsets[i + 1] = offsets[i] + lengths[i];
  }
  std::vector<double> all(offsets.back());
  this->Controller->AllGatherV(numbers.data(), all.data(), length, lengths.data(), offsets.data());
  vtkRelievoOpticalDepths::Extent joined;
  for (int i = 0; i < processes; ++i)
  {
    const double* from = all.data() + offsets[i];
    const auto corners = static_cast<int>(from[0]);
    if (corners == 0)
    {
      continue;
    }
    if (joined.Corners.empty())
    {
      joined.Spacing = from[1];
      for (int axis = 0; axis < 3; ++axis)
      {
        const double* numbersOfAxis = from + 3 + 3 * axis;
        joined.Axes[axis] = glm::dvec3(numbersOfAxis[0], numbersOfAxis[1], numbersOfAxis[2]);
      }
    }
    joined.Spacing = std::min(joined.Spacing, from[1]);
    joined.Tinted = joined.Tinted || from[2] != 0.0;
    for (int corner = 0; corner < corners; ++corner)
    {
      const double* place = from + Header + 3 * corner;
      joined.Corners.emplace_back(place[0], place[1], place[2]);
      if (i != this->Controller->GetLocalProcessId())
      {
        others.push_back(joined.Corners.back());
      }
    }
  }
  return joined;
}

//------------------------------------------------------------------------------
void vtkRelievoVolumeExchange::Add(float* numbers, std::size_t count)
{
  if (this->IsOn() && count > 0)
  {
    const std::vector<float> own(numbers, numbers + count);
    this->Controller->AllReduce(
      own.data(), numbers, static_cast<vtkIdType>(count), vtkCommunicator::SUM_OP);
  }
}
