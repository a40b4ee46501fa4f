// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoFramePlan.h"

#include "vtkRelievoFrameOrder.h"

#include <algorithm>
#include <tuple>

namespace
{
using Node = vtkRelievoFramePlan::Node;

const std::string& Picture = vtkRelievoResources::Picture.Get();
const std::string& Color = vtkRelievoResources::Color.Get();
const std::string& Translucent = vtkRelievoResources::Translucent.Get();

bool Has(const std::vector<std::string>& names, const std::string& name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool Has(const std::vector<vtkRelievoResourceName>& names, const std::string& name)
{
  return std::any_of(names.begin(), names.end(),
    [&name](const vtkRelievoResourceName& other) { return other.Get() == name; });
}

bool Writes(const Node& node, const std::string& resource, bool layer)
{
  return Has(node.Declaration.Layers, resource) ||
    (!layer && Has(node.Declaration.Writes, resource));
}

// The nodes that make the picture in addition to the delegate, the last one first.
std::vector<int> FindPictureMakers(const std::vector<Node>& nodes)
{
  std::vector<int> makers;
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    if (nodes[i].Declaration.Runs && Has(nodes[i].Declaration.Writes, Picture) &&
      !nodes[i].Delegate)
    {
      makers.push_back(static_cast<int>(i));
    }
  }
  std::sort(
    makers.begin(), makers.end(), [&nodes](int a, int b) { return nodes[b].IsBefore(nodes[a]); });
  return makers;
}

int FindDelegate(const std::vector<Node>& nodes)
{
  const auto found =
    std::find_if(nodes.begin(), nodes.end(), [](const Node& node) { return node.Delegate; });
  return found == nodes.end() ? -1 : static_cast<int>(found - nodes.begin());
}
}

//------------------------------------------------------------------------------
bool vtkRelievoFramePlan::Node::ChangesColor() const
{
  return !this->Delegate && Has(this->Declaration.Writes, Color);
}

//------------------------------------------------------------------------------
bool vtkRelievoFramePlan::Node::IsBefore(const Node& other) const
{
  return std::tie(this->Slot, this->Order, this->Name) <
    std::tie(other.Slot, other.Order, other.Name);
}

//------------------------------------------------------------------------------
std::vector<vtkRelievoFramePlan::Name> vtkRelievoFramePlan::GetReads(const Node& node)
{
  std::vector<Name> reads;
  for (const vtkRelievoResourceName& name : node.Declaration.Reads)
  {
    reads.push_back({ name.Get(), false });
  }
  for (const std::string& name : node.Declaration.ReadsLayers)
  {
    reads.push_back({ name, true });
  }
  for (const vtkRelievoResourceName& name :
    node.ReadsFor ? node.ReadsFor(node.Asked) : std::vector<vtkRelievoResourceName>())
  {
    reads.push_back({ name.Get(), false });
  }
  return reads;
}

//------------------------------------------------------------------------------
int vtkRelievoFramePlan::FindWriter(const std::vector<Node>& nodes, const Name& name)
{
  int writer = -1;
  int arrays = -1;
  bool idle = false; // the outputs of an idle stage are no arrays
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    const vtkRelievoDeclaration& declaration = nodes[i].Declaration;
    if (Writes(nodes[i], name.Resource, name.Layer))
    {
      idle = true;
      if (declaration.Runs && (writer < 0 || nodes[i].IsBefore(nodes[writer])))
      {
        writer = static_cast<int>(i);
      }
    }
    if (name.Layer && declaration.Runs && declaration.WritesArrays)
    {
      arrays = static_cast<int>(i);
    }
  }
  return idle ? writer : arrays;
}

//------------------------------------------------------------------------------
// The reason why no stage writes it; "" if one does.
std::string vtkRelievoFramePlan::ExplainMissing(const std::vector<Node>& nodes, const Name& name)
{
  const int writer = FindWriter(nodes, name);
  if (writer < 0)
  {
    const auto find = [&](auto would) { return std::find_if(nodes.begin(), nodes.end(), would); };
    auto idle = find([&name](const Node& node) { return Writes(node, name.Resource, name.Layer); });
    if (idle == nodes.end() && name.Layer)
    {
      idle = find([](const Node& node) { return node.Declaration.WritesArrays; });
    }
    return idle == nodes.end() ? "which no stage writes"
                               : "which the stage " + idle->Name +
        " would write, but does not run: " + idle->Declaration.Reason;
  }
  const Node& node = nodes[writer];
  for (const vtkRelievoResourceName& more :
    node.ReadsFor ? node.ReadsFor({ name.Resource }) : std::vector<vtkRelievoResourceName>())
  {
    if (more != vtkRelievoResources::Color && FindWriter(nodes, { more.Get(), false }) < 0)
    {
      return "for which the stage " + node.Name + " needs '" + more.Get() + "', " +
        ExplainMissing(nodes, { more.Get(), false });
    }
  }
  return std::string();
}

//------------------------------------------------------------------------------
// `told`: the report contains the reason, so that no error is needed.
void vtkRelievoFramePlan::Refuse(Node& node, const std::string& words, bool told)
{
  node.Declaration.Runs = false;
  node.Declaration.ReasonCode = "refused";
  node.Declaration.Reason = words;
  if (!told)
  {
    this->Errors.push_back("The stage " + node.Name + " does not run: " + words);
  }
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
  if (node.Delegate && resource == Translucent)
  {
    this->ColorNeeded = this->ColorSeen = true; // the colour from which it is kept apart
  }
  if (!asked)
  {
    node.Asked.insert(std::upper_bound(node.Asked.begin(), node.Asked.end(), resource), resource);
  }
  for (const Name& read : GetReads(node))
  {
    if (node.Declaration.Runs)
    {
      this->AskFor(nodes, read, place);
    }
  }
}

//------------------------------------------------------------------------------
void vtkRelievoFramePlan::AskForColor(std::vector<Node>& nodes, int reader)
{
  if (!this->NoColor.empty())
  {
    const std::string words = "there is no linear colour here: " + this->NoColor;
    if (reader >= 0)
    {
      this->Refuse(nodes[reader], words, true);
    }
    else
    {
      this->Missing[Color] = "since " + words;
    }
    return;
  }
  this->ColorNeeded = true;
  this->ColorSeen = true;
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    const bool before = reader < 0 || nodes[i].IsBefore(nodes[reader]);
    if (nodes[i].Declaration.Runs && !nodes[i].Declaration.OnlyIfColorChanges &&
      (nodes[i].Delegate || (nodes[i].ChangesColor() && before)))
    {
      this->Need(nodes, static_cast<int>(i), Color);
    }
  }
  this->Join(nodes, reader);
}

//------------------------------------------------------------------------------
// Adds the stages that change the colour only if an earlier one does; only those before the reader,
// if any.
void vtkRelievoFramePlan::Join(std::vector<Node>& nodes, int reader)
{
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    const Node& node = nodes[i];
    const bool joins = node.Declaration.Runs && node.Declaration.OnlyIfColorChanges &&
      node.ChangesColor() && (reader < 0 || node.IsBefore(nodes[reader])) &&
      std::any_of(nodes.begin(), nodes.end(), [&node](const Node& other) {
        return other.Needed && !other.Declaration.OnlyIfColorChanges && other.ChangesColor() &&
          Has(other.Asked, Color) && other.IsBefore(node);
      });
    if (joins)
    {
      this->Need(nodes, static_cast<int>(i), Color);
    }
  }
}

//------------------------------------------------------------------------------
void vtkRelievoFramePlan::AskFor(std::vector<Node>& nodes, const Name& name, int reader)
{
  if (name.Resource == Color)
  {
    this->AskForColor(nodes, reader);
    return;
  }
  const std::string error = ExplainMissing(nodes, name);
  if (error.empty())
  {
    this->Need(nodes, FindWriter(nodes, name), name.Resource);
  }
  else if (reader < 0)
  {
    this->Missing[name.Resource] = error;
  }
  else
  {
    this->Refuse(nodes[reader], "it reads '" + name.Resource + "', " + error);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoFramePlan::MarkPicture(std::vector<Node>& nodes)
{
  const int delegate = FindDelegate(nodes);
  if (delegate >= 0)
  {
    this->Need(nodes, delegate, Picture);
  }
  std::string cover; // the node that certainly hides earlier drawing
  for (const int maker : FindPictureMakers(nodes))
  {
    Node& node = nodes[maker];
    if (cover.empty())
    {
      this->Need(nodes, maker, Picture);
      cover = node.Declaration.HidesColor ? node.Name : "";
    }
    else
    {
      node.ReasonCode = "hidden";
      node.Reason = cover + " shows something else as the picture";
    }
  }
  const bool covered = !cover.empty();
  this->ColorSeen = this->ColorSeen || !covered;
  for (Node& node : nodes)
  {
    if (!node.Declaration.Runs || !node.ChangesColor() ||
      (node.Declaration.OnlyIfColorChanges && !covered))
    {
      continue;
    }
    if (covered)
    {
      node.ReasonCode = "hidden";
      node.Reason = cover + " shows something else as the picture";
    }
    else
    {
      this->AskForColor(nodes, -1);
      break;
    }
  }
}

//------------------------------------------------------------------------------
void vtkRelievoFramePlan::AskForOptional(std::vector<Node>& nodes)
{
  for (const std::string& layer : this->OptionalLayers)
  {
    const int writer = FindWriter(nodes, { layer, true });
    if (writer >= 0 && nodes[writer].Needed && ExplainMissing(nodes, { layer, true }).empty())
    {
      this->Need(nodes, writer, layer);
    }
  }
}

//------------------------------------------------------------------------------
void vtkRelievoFramePlan::Mark(
  std::vector<Node>& nodes, const std::vector<std::string>& layers, bool picture)
{
  this->ColorNeeded = this->ColorSeen = false;
  this->Missing.clear();
  for (Node& node : nodes)
  {
    if (!this->NoColor.empty() && node.Declaration.Runs && node.ChangesColor())
    {
      this->Refuse(node, "there is no linear colour here: " + this->NoColor, true);
    }
    node.Needed = false;
    node.Asked.clear();
    // A stage that runs only for a layer has already declared why it does not affect the picture.
    const bool told = !node.Declaration.Runs || !node.Declaration.ReasonCode.empty();
    node.ReasonCode = told ? node.Declaration.ReasonCode : "not_asked";
    node.Reason = told ? node.Declaration.Reason : "no output asks for it";
  }
  for (const std::string& layer : layers)
  {
    this->AskFor(nodes, { layer, true }, -1);
  }
  if (picture)
  {
    this->MarkPicture(nodes);
  }
  this->AskForOptional(nodes);
  for (std::size_t i = 0; i < nodes.size() && this->ColorSeen; ++i)
  {
    for (const vtkRelievoResourceName& use : nodes[i].Declaration.OptionalReads)
    {
      const int writer = FindWriter(nodes, { use.Get(), false });
      if (nodes[i].Needed && writer >= 0 &&
        Has(nodes[writer].Declaration.OptionalWrites, use.Get()))
      {
        this->Need(nodes, writer, use.Get());
      }
    }
  }
  // Means are computed from the linear colour.
  const bool gathers = std::any_of(nodes.begin(), nodes.end(),
    [](const Node& node) { return node.Needed && node.Declaration.Samples > 1; });
  this->ColorNeeded = this->ColorNeeded || (picture && gathers && this->NoColor.empty());
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkRelievoFramePlan::Make(
  std::vector<Node>& nodes, const std::vector<std::string>& layers, bool picture)
{
  this->Errors.clear();
  for (const Node& node : nodes)
  {
    if (!node.Declaration.Runs && node.Declaration.ReasonCode == "refused")
    {
      this->Errors.push_back(
        "The stage " + node.Name + " does not run: " + node.Declaration.Reason);
    }
  }
  do
  {
    this->Refused = false;
    this->Mark(nodes, layers, picture);
    if (!this->Refused)
    {
      vtkRelievoFrameOrder order(nodes);
      for (const auto& refused : order.GetRefused())
      {
        this->Refuse(nodes[refused.first], refused.second);
      }
      this->Order = order.Get();
    }
  } while (this->Refused);
  return this->Errors;
}
