// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A bounding volume hierarchy that shaders traverse without a stack: nodes in traversal order, each
// with the node to continue with if its box is missed.
//
// All leaves but the last are full: the number of nodes follows from the number of boxes, and
// threads build subtrees without waiting for each other.
#ifndef vtkRelievoBoxTree_h
#define vtkRelievoBoxTree_h

#include "vtkRelievoFormulas.h"   // for GLM
#include "vtkRelievoRaysModule.h" // for the export macro

#include <array>
#include <vector>

class vtkRelievoBoxRecords;

class VTKRELIEVORAYS_EXPORT vtkRelievoBoxTree
{
public:
  struct Box
  {
    glm::vec3 Min;
    glm::vec3 Max;
  };

  struct Node
  {
    glm::vec3 Low;
    int Next; // the node after the subtree (inner node), or -1 - the index of the leaf's first box
    glm::vec3 High;
    int Count; // the leaf's number of boxes, or 0

    // Two texels of shaders/rays/tree.glsl for the node with this index.
    std::array<glm::vec4, 2> GetTexels(int index, int leafSize) const;
  };

  // Maximum number of leaves of a tree in texels, where floats count them.
  static constexpr int MostLeaves = 1 << 24;

  void Build(const std::vector<Box>& boxes, int leafSize);

  // Refits the tree to moved boxes, whose number must be that of the last build.
  void Refit(const std::vector<Box>& boxes);

  const std::vector<Node>& GetNodes() const { return this->Nodes; }

  // The index of the box at each position in the leaves.
  const std::vector<int>& GetOrder() const { return this->Order; }

  // Expected node visits of a ray through the root: the sum of all nodes' areas over the root's.
  double GetCost() const;

  static int GetNumberOfNodes(int boxes, int leafSize);

private:
  struct Task; // a node to be made

  bool MakeNode(vtkRelievoBoxRecords& records, const Task& task, Task& left, Task& right);
  void MakeSubtree(vtkRelievoBoxRecords& records, const Task& task);
  void FitNodes(const std::vector<Box>& boxes);

  std::vector<Node> Nodes;
  std::vector<int> Order;
  int LeafSize = 1;
};

#endif
