// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoFrameOrder.h"

#include "vtkRelievoStageDescription.h"

#include <algorithm>

//------------------------------------------------------------------------------
vtkRelievoFrameOrder::vtkRelievoFrameOrder(const std::vector<Node>& nodes)
  : Nodes(nodes)
  , Waits(nodes.size())
{
  this->WaitForReads();
  this->RefuseLate();
  if (this->Refused.empty())
  {
    this->Sort();
  }
}

//------------------------------------------------------------------------------
// The nodes that make and change the colour, in order.
std::vector<int> vtkRelievoFrameOrder::GetColorChain() const
{
  std::vector<int> chain;
  for (std::size_t i = 0; i < this->Nodes.size(); ++i)
  {
    const Node& node = this->Nodes[i];
    if (node.Needed && (node.Delegate || node.ChangesColor()))
    {
      chain.push_back(static_cast<int>(i));
    }
  }
  std::sort(chain.begin(), chain.end(), [this](int a, int b) {
    const Node& one = this->Nodes[a];
    const Node& other = this->Nodes[b];
    return one.Delegate != other.Delegate ? one.Delegate : one.IsBefore(other);
  });
  return chain;
}

//------------------------------------------------------------------------------
void vtkRelievoFrameOrder::WaitForReads()
{
  const std::string& color = vtkRelievoResources::Color.Get();
  const std::vector<int> chain = this->GetColorChain();
  for (std::size_t i = 1; i < chain.size(); ++i)
  {
    this->Waits[chain[i]].emplace_back(chain[i - 1], color);
  }
  for (std::size_t i = 0; i < this->Nodes.size(); ++i)
  {
    const Node& node = this->Nodes[i];
    if (!node.Needed)
    {
      continue;
    }
    std::vector<vtkRelievoFramePlan::Name> reads = vtkRelievoFramePlan::GetReads(node);
    for (const vtkRelievoResourceName& use : node.Declaration.OptionalReads)
    {
      reads.push_back({ use.Get(), false });
    }
    for (const vtkRelievoFramePlan::Name& read : reads)
    {
      if (read.Resource != color)
      {
        const int writer = vtkRelievoFramePlan::FindWriter(this->Nodes, read);
        if (writer >= 0 && this->Nodes[writer].Needed && writer != static_cast<int>(i))
        {
          this->Waits[i].emplace_back(writer, read.Resource);
        }
        continue;
      }
      // A node that only reads sees the colour at its place in the chain.
      for (const int link : chain)
      {
        if (node.ChangesColor() || link == static_cast<int>(i))
        {
          break;
        }
        if (this->Nodes[link].Delegate || this->Nodes[link].IsBefore(node))
        {
          this->Waits[i].emplace_back(link, color);
        }
        else
        {
          this->Waits[link].emplace_back(static_cast<int>(i), color);
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
void vtkRelievoFrameOrder::RefuseLate()
{
  using Description = vtkRelievoStageDescription;
  for (std::size_t i = 0; i < this->Nodes.size(); ++i)
  {
    const Node& node = this->Nodes[i];
    for (const Wait& wait : this->Waits[i])
    {
      const Node& writer = this->Nodes[wait.first];
      if (writer.Slot > node.Slot)
      {
        this->Refused.emplace_back(static_cast<int>(i),
          std::string("it runs in the slot '") + Description::GetSlotName(node.Slot) +
            "' and needs '" + wait.second + "', which the stage " + writer.Name +
            " writes later, in '" + Description::GetSlotName(writer.Slot) + "'");
        return;
      }
    }
  }
}

//------------------------------------------------------------------------------
void vtkRelievoFrameOrder::Sort()
{
  const std::size_t count = this->Nodes.size();
  std::vector<bool> done(count, false);
  const auto isReady = [&](std::size_t i) {
    return this->Nodes[i].Needed && !done[i] &&
      std::all_of(this->Waits[i].begin(), this->Waits[i].end(),
        [&done](const Wait& wait) { return done[wait.first]; });
  };
  for (int next = 0; next >= 0;)
  {
    next = -1;
    for (std::size_t i = 0; i < count; ++i)
    {
      if (isReady(i) && (next < 0 || this->Nodes[i].IsBefore(this->Nodes[next])))
      {
        next = static_cast<int>(i);
      }
    }
    if (next >= 0)
    {
      done[next] = true;
      this->Order.push_back(next);
    }
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    done[i] = done[i] || !this->Nodes[i].Needed;
  }
  if (std::find(done.begin(), done.end(), false) != done.end())
  {
    this->RefuseCircle(done);
  }
}

//------------------------------------------------------------------------------
// Every remaining node waits for another one: walks back until a node repeats.
void vtkRelievoFrameOrder::RefuseCircle(const std::vector<bool>& done)
{
  const auto getWait = [&](int place) {
    return *std::find_if(this->Waits[place].begin(), this->Waits[place].end(),
      [&done](const Wait& wait) { return !done[wait.first]; });
  };
  std::vector<int> walk;
  int at = static_cast<int>(std::find(done.begin(), done.end(), false) - done.begin());
  while (std::find(walk.begin(), walk.end(), at) == walk.end())
  {
    walk.push_back(at);
    at = getWait(at).first;
  }
  walk.erase(walk.begin(), std::find(walk.begin(), walk.end(), at));
  std::string words;
  for (const int place : walk)
  {
    const Wait wait = getWait(place);
    words += (words.empty() ? "" : ", ") + this->Nodes[place].Name + " reads '" + wait.second +
      "' of " + this->Nodes[wait.first].Name;
  }
  for (const int place : walk)
  {
    this->Refused.emplace_back(place, "it waits for itself (" + words + ")");
  }
}
