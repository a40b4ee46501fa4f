// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which steps of a frame run, and in which order: worked out backwards from what is asked of it.
//
// Resources are names: `picture`, what the window shows; `color`, the linear colour that the
// picture is made of; `translucent`, what the delegate keeps apart from it; layers; and whatever
// else stages write and read, such as `shadow maps`.
// Users name layers only, and arrays of their data among them, which may be called as they like:
// what a stage writes is a layer if the stage publishes it.
#ifndef vtkRelievoFramePlan_h
#define vtkRelievoFramePlan_h

#include "vtkRelievoFrameModule.h" // for the export macro

#include <functional>
#include <map>
#include <string>
#include <vector>

// What a stage would do in a frame.
struct VTKRELIEVOFRAME_EXPORT vtkRelievoDeclaration
{
  // Whether there is anything to do; if not, ReasonCode and Reason say why (vtkRelievoStage). What
  // runs, but for layers alone, has them for pictures that ask for none of these.
  // The words of what is "refused" are an error, which the frame says once.
  bool Runs = true;
  std::string ReasonCode;
  std::string Reason;

  std::vector<std::string> Reads;         // without which it cannot run
  std::vector<std::string> ReadsLayers;   // as users name them: arrays, and what is published
  std::vector<std::string> OptionalReads; // reads what of it is offered
  std::vector<std::string> Writes; // what writes `color` changes it, whether it reads it or not
  std::vector<std::string> Layers; // writes as well, for users to request by these names
  bool WritesArrays = false;       // any layer that is not among anybody's Layers
  std::vector<std::string> OptionalWrites; // of Writes: to those that merely use it
  // Whether it changes the colour only in pictures in which another stage before it does.
  bool OnlyIfColorChanges = false;
  // Whether it changes the colour only where something translucent is kept apart.
  bool OnlyIfTranslucent = false;
  bool HidesColor = true; // of one that writes `picture`: the colour is surely not seen beneath

  // Whether it finishes what the delegate draws, while it draws: needed whenever that is.
  bool DrawsWithDelegate = false;

  // Whether it makes the picture of the colour, by vtkRelievoFrameContext::Present, in the place of
  // the sRGB curve alone. If it does not, the curve does.
  bool Presents = false;

  // Samples of what it draws, of which each frame has one (vtkRelievoFrameContext::Sample) as long
  // as nothing else changes; the frame gathers lights' visibility, the colour if an OptionalWrites
  // is asked for, and shows the mean. AtOnce: all of them in every frame.
  // OffsetsSamples: they lie at different places within each pixel.
  // Gathered: what else of its writes is a mean of them: `color`, and layers of one channel.
  int Samples = 1;
  std::vector<std::string> Gathered;
  bool AtOnce = false;
  bool OffsetsSamples = false;
  // Whether what it does holds as well where all samples are drawn at once, in a raster that is
  // finer than the pixels (vtkRelievoFrameContext::Lattice): shader code that it splices reads no
  // texture by the pixel.
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
    bool Delegate = false; // VTK's own drawing: makes the picture, and the colour
    vtkRelievoDeclaration Declaration;
    std::function<std::vector<std::string>(const std::vector<std::string>&)> ReadsFor;

    // Set by Make.
    bool Needed = false;
    std::vector<std::string> Asked; // of what it writes; sorted
    std::string ReasonCode;         // why it is not needed, as vtkRelievoStage::GetReason
    std::string Reason;

    bool ChangesColor() const;
    bool IsBefore(const Node& other) const; // by slot, order and name
  };

  // What is read: a layer by the name that users give it, or any resource.
  struct Name
  {
    std::string Resource;
    bool Layer;
  };

  // Why there can be no linear colour, in words; "": there can. What reads or writes it is refused.
  void SetNoColor(const std::string& words) { this->NoColor = words; }

  // Works out which of the nodes are needed for the layers, and for the picture. Returns which
  // cannot run for what they read, in words that name the stages: these do not run, nor what needs
  // them. A layer that cannot be made is left out.
  std::vector<std::string> Make(
    std::vector<Node>& nodes, const std::vector<std::string>& layers, bool picture);

  // Layers that are left out, and why, in words that go on after the layer's name.
  const std::map<std::string, std::string>& GetMissing() const { return this->Missing; }

  // Places of the needed nodes, in the order in which they run.
  const std::vector<int>& GetOrder() const { return this->Order; }

  // Whether the linear colour is needed: somebody other than the delegate reads or writes it.
  bool NeedsColor() const { return this->ColorNeeded; }

  // All that a node reads, for what is asked of it.
  static std::vector<Name> GetReads(const Node& node);

  // The node that writes it, or -1.
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
