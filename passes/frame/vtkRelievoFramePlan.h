// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which steps of a frame run, and in which order: worked out backwards from what is asked of it.
//
// Resources are names: `picture`, what the window shows; `color`, the linear colour that the
// picture is made of; layers; and whatever else stages write and read, such as `shadow maps`.
#ifndef vtkRelievoFramePlan_h
#define vtkRelievoFramePlan_h

#include "vtkRelievoFrameModule.h" // for the export macro

#include <functional>
#include <string>
#include <vector>

// What a stage would do in a frame.
struct VTKRELIEVOFRAME_EXPORT vtkRelievoDeclaration
{
  // Whether there is anything to do; if not, Code and Words say why, as vtkRelievoStage::GetReason.
  bool Runs = true;
  std::string Code;
  std::string Words;

  std::vector<std::string> Reads;  // without which it cannot run
  std::vector<std::string> Uses;   // reads if they are offered
  std::vector<std::string> Writes; // what reads `color` and writes it changes it
  bool WritesLayers = false;       // any name that no other stage writes
  bool Offers = true;              // what it writes, to those that merely use it
  bool Covers = true; // of one that writes `picture`: the colour is surely not seen beneath
};

class VTKRELIEVOFRAME_EXPORT vtkRelievoFramePlan
{
public:
  struct Node
  {
    std::string Name;
    int Slot = 0;
    int Order = 0;
    vtkRelievoDeclaration Declaration;
    std::function<std::vector<std::string>(const std::vector<std::string>&)> ReadsFor;

    // Set by Make.
    bool Needed = false;
    std::vector<std::string> Asked; // of what it writes; sorted
    std::string Code;               // why it is not needed, as vtkRelievoStage::GetReason
    std::string Words;
  };

  // Works out which of the nodes are needed for the outputs. Returns which cannot run for what they
  // read, in words that name the stages: these do not run, nor what needs them. An output that
  // nobody writes is left out.
  std::vector<std::string> Make(std::vector<Node>& nodes, const std::vector<std::string>& outputs);

  // Places of the needed nodes, in the order in which they run.
  const std::vector<int>& GetOrder() const { return this->Order; }

  // Whether the linear colour is needed: somebody other than the delegate reads or writes it.
  bool NeedsColor() const { return this->ColorNeeded; }

  // The node that writes the resource, or -1.
  int FindWriter(const std::vector<Node>& nodes, const std::string& resource) const;

private:
  void Mark(std::vector<Node>& nodes, const std::vector<std::string>& outputs);
  void Need(std::vector<Node>& nodes, int node, const std::string& resource);
  void AskFor(std::vector<Node>& nodes, const std::string& resource, int reader);
  void AskForColor(std::vector<Node>& nodes, int reader);
  void Refuse(Node& node, const std::string& words);
  bool Sort(std::vector<Node>& nodes);

  std::vector<int> Order;
  std::vector<std::string> Wrong;
  bool Refused = false; // in this round of marking
  bool ColorNeeded = false;
  bool ColorSeen = false;
};

#endif
