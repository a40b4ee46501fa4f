// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A hierarchy over boxes that a shader walks without a stack: nodes in the order in which a walk
// meets them, each with the node to go on with where its box is not met.
//
// All leaves but the last hold as many boxes as a leaf may: the number of nodes follows from the
// number of boxes, and subtrees are made in threads without waiting for each other.
#ifndef vtkRelievoBoxTree_h
#define vtkRelievoBoxTree_h

#include "vtkRelievoFormulas.h"   // for GLM
#include "vtkRelievoRaysModule.h" // for the export macro

#include <vector>

class VTKRELIEVORAYS_EXPORT vtkRelievoBoxTree
{
public:
  struct Box
  {
    glm::vec3 Min;
    glm::vec3 Max;
  };

  // Two texels of shaders/shadow/exact.glsl: the box's corners, and beside the least one the node
  // behind the subtree (an inner node) or -1 - the first place of its boxes (a leaf), beside the
  // greatest how many boxes the leaf holds, or 0.
  struct Node
  {
    glm::vec4 Low;
    glm::vec4 High;
  };

  void Build(const std::vector<Box>& boxes, int leafSize);

  // The boxes have moved: the tree keeps its shape around them. There must be as many boxes as it
  // was built of.
  void Refit(const std::vector<Box>& boxes);

  const std::vector<Node>& GetNodes() const { return this->Nodes; }

  // Which box is at each place of the leaves.
  const std::vector<int>& GetOrder() const { return this->Order; }

  // Expected visits of a ray that meets the root: areas of all nodes over the root's.
  double GetCost() const;

  static int GetNumberOfNodes(int boxes, int leafSize);

private:
  struct Task
  {
    int Node;
    int First;
    int Count;
  };
  struct Split;

  Task MakeNode(const std::vector<Box>& boxes, const Task& task, Task& right);
  void MakeSubtree(const std::vector<Box>& boxes, const Task& task);
  void FitNodes(const std::vector<Box>& boxes);

  std::vector<Node> Nodes;
  std::vector<int> Order;
  int LeafSize = 1;
};

#endif
