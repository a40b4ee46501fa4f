// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Plans a frame: which steps run, and in which order, worked out backwards from its outputs.
//
// Resources are names: `picture`, the window's content; `color`, the linear colour from which the
// picture is made; `translucent`, the geometry that the delegate keeps apart from it; layers; and
// any other output of stages, such as `shadow maps`.
// Users name only layers, and arrays of their data, which may have any name: a stage's output is a
// layer if the stage publishes it.
#ifndef vtkRelievoFramePlan_h
#define vtkRelievoFramePlan_h

#include "vtkRelievoFrameModule.h" // for the export macro

#include <functional>
#include <map>
#include <string>
#include <vector>

// A stage's planned work in a frame.
struct VTKRELIEVOFRAME_EXPORT vtkRelievoDeclaration
{
  // Whether the stage has work to do; if not, ReasonCode and Reason tell why (vtkRelievoStage). A
  // stage that runs only for layers also sets them, for pictures that request none of its layers.
  // The reason of a "refused" stage is an error, which the frame reports once.
  bool Runs = true;
  std::string ReasonCode;
  std::string Reason;

  std::vector<std::string> Reads; // required inputs
  // Required inputs by their name for users: arrays and published layers.
  std::vector<std::string> ReadsLayers;
  std::vector<std::string> OptionalReads; // inputs that are read if they are offered
  std::vector<std::string> Writes; // a writer of `color` changes it, whether it reads it or not
  std::vector<std::string> Layers; // outputs that users can also request by these names
  bool WritesArrays = false;       // and any layer that is in no stage's Layers
  // Subset of Writes: only for users that read them optionally.
  std::vector<std::string> OptionalWrites;
  // Whether the stage changes the colour only in pictures in which an earlier stage does.
  bool OnlyIfColorChanges = false;
  // Whether the stage changes the colour only if translucent geometry is kept apart.
  bool OnlyIfTranslucent = false;
  bool HidesColor = true; // for a writer of `picture`: the colour is certainly hidden

  // Whether the stage takes part in the delegate's drawing: needed whenever the delegate is.
  bool DrawsWithDelegate = false;

  // Whether the stage makes the picture from the colour, by vtkRelievoFrameContext::Present, in
  // place of the sRGB curve. If it does not, the curve is used.
  bool Presents = false;

  // Number of samples, of which each frame draws one (vtkRelievoFrameContext::Sample) while nothing
  // else changes; the frame gathers lights' visibility, and the colour if an OptionalWrites is
  // requested, and shows the mean. AtOnce: every frame draws all samples. OffsetsSamples: samples
  // have different positions within each pixel. Gathered: further outputs that are means of
  // samples: `color`, and layers of one channel.
  int Samples = 1;
  std::vector<std::string> Gathered;
  bool AtOnce = false;
  bool OffsetsSamples = false;
  // Whether the stage also works if all samples are drawn at once, in a raster finer than the
  // pixels (vtkRelievoFrameContext::Lattice): its spliced shader code must not read textures by
  // pixel.
  bool AnyRaster = false;
};

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
    std::function<std::vector<std::string>(const std::vector<std::string>&)> ReadsFor;

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
  void Need(std::vector<Node>& nodes, int node, const std::string& resource);
  void AskFor(std::vector<Node>& nodes, const Name& name, int reader);
  void AskForColor(std::vector<Node>& nodes, int reader);
  void Join(std::vector<Node>& nodes, int reader);
  void Refuse(Node& node, const std::string& words, bool told = false);

  std::vector<int> Order;
  std::vector<std::string> Wrong;
  std::map<std::string, std::string> Missing;
  std::string NoColor;
  bool Refused = false; // in this round of marking
  bool ColorNeeded = false;
  bool ColorSeen = false;
};

#endif
