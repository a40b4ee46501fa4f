// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoFramePlan.h"

#include "vtkRelievoStageDescription.h"

#include <algorithm>
#include <tuple>

namespace
{
using Node = vtkRelievoFramePlan::Node;

const std::string Picture = "picture";
const std::string Color = "color";

bool Has(const std::vector<std::string>& names, const std::string& name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::tuple<int, int, const std::string&> GetKey(const Node& node)
{
  return std::tuple<int, int, const std::string&>(node.Slot, node.Order, node.Name);
}

bool MakesColor(const Node& node)
{
  return Has(node.Declaration.Writes, Color) && !Has(node.Declaration.Reads, Color);
}

bool ChangesColor(const Node& node)
{
  return Has(node.Declaration.Writes, Color) && Has(node.Declaration.Reads, Color);
}

// All that a needed node reads: what it lists, what it needs for what is asked of it, and what is
// offered to it.
std::vector<std::string> GetReads(const Node& node)
{
  std::vector<std::string> reads = node.Declaration.Reads;
  if (node.ReadsFor)
  {
    const std::vector<std::string> more = node.ReadsFor(node.Asked);
    reads.insert(reads.end(), more.begin(), more.end());
  }
  return reads;
}

// The node that makes the picture of something else than what the delegate drew, or -1.
int FindPictureMaker(const std::vector<Node>& nodes)
{
  int maker = -1;
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    if (nodes[i].Declaration.Runs && Has(nodes[i].Declaration.Writes, Picture) &&
      !MakesColor(nodes[i]) && (maker < 0 || GetKey(nodes[maker]) < GetKey(nodes[i])))
    {
      maker = static_cast<int>(i);
    }
  }
  return maker;
}

int FindDelegate(const std::vector<Node>& nodes)
{
  const auto found = std::find_if(nodes.begin(), nodes.end(), MakesColor);
  return found == nodes.end() ? -1 : static_cast<int>(found - nodes.begin());
}

// Those that make and change the colour, in their order.
std::vector<int> GetColorChain(const std::vector<Node>& nodes)
{
  std::vector<int> chain;
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    if (nodes[i].Needed && (MakesColor(nodes[i]) || ChangesColor(nodes[i])))
    {
      chain.push_back(static_cast<int>(i));
    }
  }
  std::sort(chain.begin(), chain.end(), [&nodes](int a, int b) {
    return std::make_tuple(!MakesColor(nodes[a]), GetKey(nodes[a])) <
      std::make_tuple(!MakesColor(nodes[b]), GetKey(nodes[b]));
  });
  return chain;
}
}

//------------------------------------------------------------------------------
int vtkRelievoFramePlan::FindWriter(
  const std::vector<Node>& nodes, const std::string& resource) const
{
  int layers = -1;
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    if (nodes[i].Declaration.Runs && Has(nodes[i].Declaration.Writes, resource))
    {
      return static_cast<int>(i);
    }
    // A resource of a stage that does not run is nobody's layer.
    const bool listed = Has(nodes[i].Declaration.Writes, resource);
    layers = listed ? -2
      : layers == -1 && nodes[i].Declaration.Runs && nodes[i].Declaration.WritesLayers
      ? static_cast<int>(i)
      : layers;
  }
  return std::max(layers, -1);
}

//------------------------------------------------------------------------------
void vtkRelievoFramePlan::Refuse(Node& node, const std::string& words)
{
  node.Declaration.Runs = false;
  node.Declaration.Code = "refused";
  node.Declaration.Words = words;
  this->Wrong.push_back("The stage " + node.Name + " does not run: " + words);
  this->Refused = true;
}

//------------------------------------------------------------------------------
void vtkRelievoFramePlan::Need(std::vector<Node>& nodes, int place, const std::string& resource)
{
  Node& node = nodes[place];
  const bool asked = Has(node.Asked, resource);
  if (node.Needed && asked)
  {
    return;
  }
  node.Needed = true;
  if (!asked)
  {
    node.Asked.insert(std::upper_bound(node.Asked.begin(), node.Asked.end(), resource), resource);
  }
  for (const std::string& read : GetReads(node))
  {
    this->AskFor(nodes, read, place);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoFramePlan::AskForColor(std::vector<Node>& nodes, int reader)
{
  this->ColorNeeded = true;
  this->ColorSeen = true;
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    const bool before = reader < 0 || GetKey(nodes[i]) < GetKey(nodes[reader]);
    if (nodes[i].Declaration.Runs && (MakesColor(nodes[i]) || (ChangesColor(nodes[i]) && before)))
    {
      this->Need(nodes, static_cast<int>(i), Color);
    }
  }
}

//------------------------------------------------------------------------------
void vtkRelievoFramePlan::AskFor(std::vector<Node>& nodes, const std::string& resource, int reader)
{
  if (resource == Color)
  {
    this->AskForColor(nodes, reader);
    return;
  }
  const int writer = this->FindWriter(nodes, resource);
  if (writer >= 0)
  {
    this->Need(nodes, writer, resource);
    return;
  }
  if (reader < 0)
  {
    return; // reading the output says so
  }
  const auto idle = std::find_if(nodes.begin(), nodes.end(),
    [&resource](const Node& node) { return Has(node.Declaration.Writes, resource); });
  this->Refuse(nodes[reader],
    "it reads '" + resource + "', " +
      (idle == nodes.end() ? "which no stage writes"
                           : "which the stage " + idle->Name +
            " would write, but does not run: " + idle->Declaration.Words));
}

//------------------------------------------------------------------------------
void vtkRelievoFramePlan::Mark(std::vector<Node>& nodes, const std::vector<std::string>& outputs)
{
  this->ColorNeeded = this->ColorSeen = false;
  for (Node& node : nodes)
  {
    node.Needed = false;
    node.Asked.clear();
    node.Code = node.Declaration.Runs ? "not_asked" : node.Declaration.Code;
    node.Words = node.Declaration.Runs ? "no output asks for it" : node.Declaration.Words;
  }
  for (const std::string& output : outputs)
  {
    if (output != Picture)
    {
      this->AskFor(nodes, output, -1);
      continue;
    }
    const int maker = FindPictureMaker(nodes);
    const int delegate = FindDelegate(nodes);
    if (delegate >= 0)
    {
      this->Need(nodes, delegate, Picture);
    }
    if (maker >= 0)
    {
      this->Need(nodes, maker, Picture);
    }
    const bool covered = maker >= 0 && nodes[maker].Declaration.Covers;
    if (!covered)
    {
      const bool changed = std::any_of(nodes.begin(), nodes.end(),
        [](const Node& node) { return node.Declaration.Runs && ChangesColor(node); });
      this->ColorSeen = true;
      if (changed)
      {
        this->AskForColor(nodes, -1);
      }
    }
    for (Node& node : nodes)
    {
      if (covered && node.Declaration.Runs && ChangesColor(node))
      {
        node.Code = "hidden";
        node.Words = nodes[maker].Name + " shows something else as the picture";
      }
    }
  }
  if (!this->ColorSeen)
  {
    return;
  }
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    for (const std::string& use : nodes[i].Declaration.Uses)
    {
      const int writer = this->FindWriter(nodes, use);
      if (nodes[i].Needed && writer >= 0 && nodes[writer].Declaration.Offers &&
        Has(nodes[writer].Declaration.Writes, use))
      {
        this->Need(nodes, writer, use);
      }
    }
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoFramePlan::Sort(std::vector<Node>& nodes)
{
  const std::size_t count = nodes.size();
  // What each node waits for, and by which resource.
  std::vector<std::vector<std::pair<int, std::string>>> waits(count);
  const std::vector<int> chain = GetColorChain(nodes);
  for (std::size_t i = 1; i < chain.size(); ++i)
  {
    waits[chain[i]].emplace_back(chain[i - 1], Color);
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    if (!nodes[i].Needed)
    {
      continue;
    }
    std::vector<std::string> reads = GetReads(nodes[i]);
    reads.insert(reads.end(), nodes[i].Declaration.Uses.begin(), nodes[i].Declaration.Uses.end());
    for (const std::string& read : reads)
    {
      if (read != Color)
      {
        const int writer = this->FindWriter(nodes, read);
        if (writer >= 0 && nodes[writer].Needed && writer != static_cast<int>(i))
        {
          waits[i].emplace_back(writer, read);
        }
        continue;
      }
      // A mere reader sees the colour as it is at its place in the chain.
      for (const int link : chain)
      {
        if (ChangesColor(nodes[i]) || link == static_cast<int>(i))
        {
          break;
        }
        if (MakesColor(nodes[link]) || GetKey(nodes[link]) < GetKey(nodes[i]))
        {
          waits[i].emplace_back(link, Color);
        }
        else
        {
          waits[link].emplace_back(static_cast<int>(i), Color);
        }
      }
    }
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    for (const auto& wait : waits[i])
    {
      if (nodes[wait.first].Slot > nodes[i].Slot)
      {
        using Description = vtkRelievoStageDescription;
        this->Refuse(nodes[i],
          std::string("it runs in the slot '") + Description::GetSlotName(nodes[i].Slot) +
            "' and reads '" + wait.second + "', which the stage " + nodes[wait.first].Name +
            " writes later, in '" + Description::GetSlotName(nodes[wait.first].Slot) + "'");
        return false;
      }
    }
  }
  std::vector<bool> done(count, false);
  this->Order.clear();
  auto isReady = [&](std::size_t i) {
    return nodes[i].Needed && !done[i] &&
      std::all_of(waits[i].begin(), waits[i].end(), [&](const auto& w) { return done[w.first]; });
  };
  for (;;)
  {
    int next = -1;
    for (std::size_t i = 0; i < count; ++i)
    {
      if (isReady(i) && (next < 0 || GetKey(nodes[i]) < GetKey(nodes[next])))
      {
        next = static_cast<int>(i);
      }
    }
    if (next < 0)
    {
      break;
    }
    done[next] = true;
    this->Order.push_back(next);
  }
  // What is left waits for itself: walk back until a node comes again.
  std::size_t left = 0;
  while (left < count && (!nodes[left].Needed || done[left]))
  {
    ++left;
  }
  if (left == count)
  {
    return true;
  }
  std::vector<int> walk;
  std::string words;
  int at = static_cast<int>(left);
  while (std::find(walk.begin(), walk.end(), at) == walk.end())
  {
    walk.push_back(at);
    const auto wait = std::find_if(
      waits[at].begin(), waits[at].end(), [&done](const auto& w) { return !done[w.first]; });
    at = wait->first;
  }
  walk.erase(walk.begin(), std::find(walk.begin(), walk.end(), at));
  for (const int place : walk)
  {
    const auto wait = std::find_if(
      waits[place].begin(), waits[place].end(), [&done](const auto& w) { return !done[w.first]; });
    words += (words.empty() ? "" : ", ") + nodes[place].Name + " reads '" + wait->second + "' of " +
      nodes[wait->first].Name;
  }
  for (const int place : walk)
  {
    this->Refuse(nodes[place], "it waits for itself (" + words + ")");
  }
  return false;
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkRelievoFramePlan::Make(
  std::vector<Node>& nodes, const std::vector<std::string>& outputs)
{
  this->Wrong.clear();
  do
  {
    this->Refused = false;
    this->Mark(nodes, outputs);
  } while (this->Refused || !this->Sort(nodes));
  return this->Wrong;
}
