// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Plans a frame: which steps run, and in which order, worked out backwards from its outputs.
//
// Users name only layers, and arrays of their data, which may have any name: a stage's output is a
// layer if the stage publishes it.
#ifndef vtkRelievoFramePlan_h
#define vtkRelievoFramePlan_h

#include "vtkRelievoDeclaration.h"
#include "vtkRelievoFrameModule.h" // for the export macro

#include <functional>
#include <map>
#include <string>
#include <vector>

class VTKRELIEVOFRAME_EXPORT vtkRelievoFramePlan
{
public:
  struct Node
  {
    std::string Name;
    int Slot = 0;
    int Order = 0;
    bool Delegate = false; // VTK's own drawing: makes the picture and the colour
    vtkRelievoDeclaration Declaration;
    std::function<std::vector<vtkRelievoResourceName>(const std::vector<std::string>&)> ReadsFor;

    // Set by Make().
    bool Needed = false;
    std::vector<std::string> Asked; // its requested outputs, sorted
    std::string ReasonCode;         // why it is not needed, see vtkRelievoStage::GetReason
    std::string Reason;

    bool ChangesColor() const;
    bool IsBefore(const Node& other) const; // by slot, order and name
  };

  // An input: a layer by its name for users, or any resource.
  struct Name
  {
    std::string Resource;
    bool Layer;
  };

  // The reason why there is no linear colour; "" if there is one. Its readers and writers are
  // refused.
  void SetNoColor(const std::string& words) { this->NoColor = words; }

  // Layers to make if the other outputs need the nodes that write them. Default: none.
  void SetOptionalLayers(const std::vector<std::string>& layers) { this->OptionalLayers = layers; }

  // Determines the nodes needed for the layers and the picture. Returns a message for each stage
  // that lacks an input; these do not run, nor do the stages that need them. Layers that cannot be
  // made are left out.
  std::vector<std::string> Make(
    std::vector<Node>& nodes, const std::vector<std::string>& layers, bool picture);

  // Layers that are left out, and the reasons, in words that follow the layer's name.
  const std::map<std::string, std::string>& GetMissing() const { return this->Missing; }

  // Indices of the needed nodes, in the order of execution.
  const std::vector<int>& GetOrder() const { return this->Order; }

  // Whether the linear colour is needed: a node other than the delegate reads or writes it.
  bool NeedsColor() const { return this->ColorNeeded; }

  // All inputs of a node, for its requested outputs.
  static std::vector<Name> GetReads(const Node& node);

  // The node that writes the resource, or -1.
  static int FindWriter(const std::vector<Node>& nodes, const Name& name);

private:
  static std::string ExplainMissing(const std::vector<Node>& nodes, const Name& name);
  void Mark(std::vector<Node>& nodes, const std::vector<std::string>& layers, bool picture);
  void MarkPicture(std::vector<Node>& nodes);
  void AskForOptional(std::vector<Node>& nodes);
  void Need(std::vector<Node>& nodes, int node, const std::string& resource);
  void AskFor(std::vector<Node>& nodes, const Name& name, int reader);
  void AskForColor(std::vector<Node>& nodes, int reader);
  void Join(std::vector<Node>& nodes, int reader);
  void Refuse(Node& node, const std::string& words, bool told = false);

  std::vector<int> Order;
  std::vector<std::string> Errors;
  std::map<std::string, std::string> Missing;
  std::vector<std::string> OptionalLayers;
  std::string NoColor;
  bool Refused = false; // in this round of marking
  bool ColorNeeded = false;
  bool ColorSeen = false;
};

#endif
