// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoMeshExchange.h"

#include "vtkCommunicator.h"
#include "vtkPolyData.h"
#include "vtkTimerLog.h"

#include <algorithm>
#include <sstream>

namespace
{
constexpr vtkIdType MostAtOnce = vtkIdType(1) << 28; // bytes: MPI counts them in an int
}

//------------------------------------------------------------------------------
void vtkRelievoMeshExchange::SetController(vtkMultiProcessController* controller)
{
  if (this->Controller != controller)
  {
    this->Controller = controller;
    this->Clear();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoMeshExchange::Clear()
{
  this->Sender.Clear();
  this->Others.clear();
  this->Whole = vtkRelievoMeshPart();
  this->Lost = true;
  this->Changed = false;
}

//------------------------------------------------------------------------------
vtkRelievoMeshExchange::Answer vtkRelievoMeshExchange::Ask(Voice voice, bool changed)
{
  const int own[4] = { voice, -voice, changed ? 0 : 1, this->Lost ? 0 : 1 };
  int all[4] = { Never, Never, 0, 0 };
  this->Controller->AllReduce(own, all, 4, vtkCommunicator::MIN_OP);
  return { all[0], -all[1], all[2] == 0, all[3] == 0 };
}

//------------------------------------------------------------------------------
bool vtkRelievoMeshExchange::Decline(bool refused)
{
  this->Clear();
  const Answer answer = this->Ask(refused ? Refused : Never, true);
  return answer.Least == Refused && answer.Most == Ready;
}

//------------------------------------------------------------------------------
std::string vtkRelievoMeshExchange::Share(const vtkRelievoMeshPart& own, bool ready)
{
  const bool changed = !ready || this->Lost || this->Sender.IsNews(own);
  Answer answer = this->Ask(Ready, changed);
  if (answer.Least == Refused)
  {
    // Retried by processes that refused before, since the scene has changed.
    answer = this->Ask(Ready, changed);
  }
  this->Declined = answer.Least != Ready;
  if (this->Declined)
  {
    this->Clear();
    return "not all processes that draw together are set to trace rays";
  }
  this->Changed = answer.Changed;
  if (!this->Changed)
  {
    return {};
  }
  const double start = vtkTimerLog::GetUniversalTime();
  if (answer.Lost)
  {
    this->Clear();
    this->Changed = true;
  }
  vtkRelievoMeshPart part = own;
  const std::vector<vtkRelievoBytes> all = this->Gather(this->Sender.Write(part));
  this->Others.resize(all.size());
  this->Bytes = 0.0;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    this->Others[i].Read(all[i]);
    this->Bytes += static_cast<double>(all[i].size());
  }
  this->MakeWhole(part);
  this->Lost = false;
  this->Seconds = vtkTimerLog::GetUniversalTime() - start;
  return {};
}

//------------------------------------------------------------------------------
void vtkRelievoMeshExchange::MakeWhole(const vtkRelievoMeshPart& own)
{
  const auto here = static_cast<std::size_t>(this->Controller->GetLocalProcessId());
  this->Whole = vtkRelievoMeshPart();
  for (std::size_t i = 0; i < this->Others.size(); ++i)
  {
    const vtkRelievoMeshPart& part = i == here ? own : this->Others[i].GetPart();
    this->Whole.Meshes.insert(this->Whole.Meshes.end(), part.Meshes.begin(), part.Meshes.end());
    for (const vtkRelievoBox& box : part.Receivers)
    {
      vtkRelievoBox::Join(box, this->Whole.Receivers);
    }
    if (i != here)
    {
      this->Whole.InMaps.insert(this->Whole.InMaps.end(), part.InMaps.begin(), part.InMaps.end());
    }
  }
}

//------------------------------------------------------------------------------
// The bytes of every other process.
std::vector<vtkRelievoBytes> vtkRelievoMeshExchange::Gather(const vtkRelievoBytes& own)
{
  const int processes = this->Controller->GetNumberOfProcesses();
  const int here = this->Controller->GetLocalProcessId();
  const auto length = static_cast<vtkIdType>(own.size());
  std::vector<vtkIdType> lengths(processes);
  this->Controller->AllGather(&length, lengths.data(), 1);
  const vtkIdType longest = *std::max_element(lengths.begin(), lengths.end());
  const vtkIdType step = MostAtOnce / processes;
  std::vector<vtkRelievoBytes> all(processes);
  std::vector<vtkIdType> counts(processes);
  std::vector<vtkIdType> offsets(processes + 1, 0);
  for (vtkIdType from = 0; from < longest; from += step)
  {
    for (int i = 0; i < processes; ++i)
    {
      counts[i] = std::min(std::max<vtkIdType>(lengths[i] - from, 0), step);
      offsets[i + 1] = offsets[i] + counts[i];
    }
    vtkRelievoBytes part(static_cast<std::size_t>(offsets[processes]));
    const unsigned char nothing = 0;
    this->Controller->AllGatherV(counts[here] > 0 ? own.data() + from : &nothing, part.data(),
      counts[here], counts.data(), offsets.data());
    for (int i = 0; i < processes; ++i)
    {
      if (i != here)
      {
        all[i].insert(all[i].end(), part.begin() + offsets[i], part.begin() + offsets[i + 1]);
      }
    }
  }
  return all;
}

//------------------------------------------------------------------------------
std::string vtkRelievoMeshExchange::Confirm(const std::string& fault)
{
  if (!this->Changed)
  {
    return fault; // no error: nothing has changed since all processes agreed
  }
  const int own = fault.empty() ? 1 : 0;
  int all = 0;
  this->Controller->AllReduce(&own, &all, 1, vtkCommunicator::MIN_OP);
  if (all != 0)
  {
    return {};
  }
  std::string words = fault;
  const std::vector<vtkRelievoBytes> others =
    this->Gather(vtkRelievoBytes(fault.begin(), fault.end()));
  for (std::size_t i = 0; i < others.size() && words.empty(); ++i)
  {
    words.assign(others[i].begin(), others[i].end());
  }
  this->Clear();
  return words;
}

//------------------------------------------------------------------------------
std::vector<vtkRelievoPlacedMesh> vtkRelievoMeshExchange::GetOthers() const
{
  std::vector<vtkRelievoPlacedMesh> meshes;
  for (const vtkRelievoMeshReceiver& other : this->Others)
  {
    const std::vector<vtkRelievoPlacedMesh>& part = other.GetPart().Meshes;
    meshes.insert(meshes.end(), part.begin(), part.end());
  }
  return meshes;
}

//------------------------------------------------------------------------------
std::string vtkRelievoMeshExchange::GetReport() const
{
  if (this->Others.empty())
  {
    return {};
  }
  vtkIdType triangles = 0;
  for (const vtkRelievoMeshReceiver& other : this->Others)
  {
    triangles += other.GetNumberOfTriangles();
  }
  std::ostringstream out;
  out << ", " << triangles << " of them from other processes (" << 1000.0 * this->Seconds
      << " ms for the last " << this->Bytes << " bytes)";
  return out.str();
}
