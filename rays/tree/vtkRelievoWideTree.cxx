// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoWideTree.h"

#include "vtkRelievoRayFile.h"

#include <limits>
#include <optional>

namespace
{
using Box = vtkRelievoBoxTree::Box;

constexpr double WornBy = 1.5; // relative to the tree's cost when it was built

void Join(Box& box, const Box& other)
{
  box.Min = glm::min(box.Min, other.Min);
  box.Max = glm::max(box.Max, other.Max);
}

double GetHalfArea(const Box& box)
{
  const glm::dvec3 size = glm::max(glm::dvec3(box.Max) - glm::dvec3(box.Min), 0.0);
  return size.x * size.y + size.y * size.z + size.z * size.x;
}

// Positions and sizes of nodes in the binary tree.
class Pairs
{
public:
  explicit Pairs(const vtkRelievoBoxTree& tree)
    : Nodes(tree.GetNodes())
  {
  }
  bool IsLeaf(int node) const { return this->Nodes[node].Count > 0; }
  int GetFirst(int leaf) const { return -1 - this->Nodes[leaf].Next; }
  int GetCount(int leaf) const { return this->Nodes[leaf].Count; }
  int GetRight(int node) const
  {
    return this->IsLeaf(node + 1) ? node + 2 : this->Nodes[node + 1].Next;
  }
  double GetSize(int node) const
  {
    return GetHalfArea({ this->Nodes[node].Low, this->Nodes[node].High });
  }

private:
  const std::vector<vtkRelievoBoxTree::Node>& Nodes;
};
}

bool vtkRelievoWideTree::Avx2 = vtkRelievoAvx2::IsSupported();

//------------------------------------------------------------------------------
vtkRelievoWideTree::Box vtkRelievoWideTree::Nowhere()
{
  return { glm::vec3(std::numeric_limits<float>::max()),
    glm::vec3(-std::numeric_limits<float>::max()) };
}

//------------------------------------------------------------------------------
void vtkRelievoWideTree::Build(const std::vector<Box>& boxes, int leafSize)
{
  std::vector<Node> nodes = this->Nodes.Release();
  nodes.clear();
  this->Stack = 0;
  std::optional<vtkRelievoBoxTree> tree(std::in_place);
  tree->Build(boxes, leafSize);
  this->Order = tree->TakeOrder();
  if (boxes.empty())
  {
    return;
  }
  const Pairs pairs(*tree);
  // Usually enough: growing would copy all nodes, and pages that stay empty take no memory.
  nodes.reserve(tree->GetNodes().size() / 4 + 1);
  struct Task
  {
    int Pair; // the binary node to convert
    int From; // the parent node, and the slot in it
    int Child;
    int Depth;
  };
  std::vector<Task> open(1, Task{ 0, -1, 0, 1 });
  while (!open.empty())
  {
    const Task task = open.back();
    open.pop_back();
    const int index = static_cast<int>(nodes.size());
    if (task.From >= 0)
    {
      nodes[task.From].Child[task.Child] = index;
    }
    this->Stack = std::max(this->Stack, (Width - 1) * task.Depth + Width);
    int children[Width] = { task.Pair };
    int count = 1;
    for (bool opened = true; opened && count < Width;)
    {
      int largest = -1;
      for (int i = 0; i < count; ++i)
      {
        if (!pairs.IsLeaf(children[i]) &&
          (largest < 0 || pairs.GetSize(children[i]) > pairs.GetSize(children[largest])))
        {
          largest = i;
        }
      }
      opened = largest >= 0;
      if (opened)
      {
        const int pair = children[largest];
        children[largest] = pair + 1;
        children[count++] = pairs.GetRight(pair);
      }
    }
    Node node{};
    for (int i = 0; i < count; ++i)
    {
      if (pairs.IsLeaf(children[i]))
      {
        node.Child[i] = -1 - (Most * pairs.GetFirst(children[i]) + pairs.GetCount(children[i]) - 1);
      }
      else
      {
        open.push_back({ children[i], index, i, task.Depth + 1 });
      }
    }
    for (int i = count; i < Width; ++i)
    {
      node.Child[i] = 0; // no box: never hit
    }
    nodes.push_back(node);
  }
  tree.reset(); // before nodes are copied
  nodes.shrink_to_fit();
  this->Nodes.Set(std::move(nodes));
  this->Fit(boxes);
  this->CostWhenBuilt = this->Cost;
}

//------------------------------------------------------------------------------
bool vtkRelievoWideTree::Refit(const std::vector<Box>& boxes)
{
  this->Fit(boxes);
  return this->Cost <= WornBy * this->CostWhenBuilt;
}

//------------------------------------------------------------------------------
// Nodes come after their parents.
void vtkRelievoWideTree::Fit(const std::vector<Box>& boxes)
{
  std::vector<Node> nodes = this->Nodes.Release();
  std::vector<Box> whole(nodes.size());
  double sum = 0.0;
  for (std::size_t n = nodes.size(); n-- > 0;)
  {
    Node& node = nodes[n];
    whole[n] = Nowhere();
    for (int i = 0; i < Width; ++i)
    {
      Box box = Nowhere();
      if (node.Child[i] < 0)
      {
        const int leaf = -1 - node.Child[i];
        for (int k = leaf / Most; k <= leaf / Most + leaf % Most; ++k)
        {
          Join(box, boxes[this->Order.empty() ? k : this->Order[k]]);
        }
      }
      else if (node.Child[i] > 0)
      {
        box = whole[node.Child[i]];
      }
      for (int axis = 0; axis < 3; ++axis)
      {
        node.Sides[axis][i] = box.Min[axis];
        node.Sides[axis + 3][i] = box.Max[axis];
      }
      Join(whole[n], box);
      sum += node.Child[i] == 0 ? 0.0 : GetHalfArea(box);
    }
  }
  const double root = nodes.empty() ? 0.0 : GetHalfArea(whole[0]);
  this->Nodes.Set(std::move(nodes));
  this->Cost = root > 0.0 ? sum / root : 0.0;
}

//------------------------------------------------------------------------------
void vtkRelievoWideTree::Write(vtkRelievoRayFileWriter& file) const
{
  file.Put(&this->CostWhenBuilt, 1);
  file.Put(this->Nodes);
}

//------------------------------------------------------------------------------
// Each node but the first has one parent, before it, so that traversals end.
bool vtkRelievoWideTree::Read(vtkRelievoRayFileReader& file, std::size_t boxes)
{
  std::vector<double> cost;
  if (!file.Take(cost) || cost.size() != 1 || !file.Take(this->Nodes))
  {
    return false;
  }
  this->CostWhenBuilt = cost[0];
  this->Order.clear();
  this->Stack = 0;
  const std::size_t count = this->Nodes.size();
  std::vector<std::uint16_t> depths(count, 0); // 0: no parent yet
  const Box nowhere = Nowhere();
  for (std::size_t n = 0; n < count; ++n)
  {
    depths[n] = n == 0 ? 1 : depths[n];
    if (depths[n] == 0 || depths[n] == std::numeric_limits<std::uint16_t>::max())
    {
      return false;
    }
    this->Stack = std::max(this->Stack, (Width - 1) * depths[n] + Width);
    const Node& node = this->Nodes[n];
    for (int i = 0; i < Width; ++i)
    {
      const int child = node.Child[i];
      if (child == 0) // none: a ray that hit its box would return to the first node
      {
        for (int side = 0; side < 6; ++side)
        {
          if (node.Sides[side][i] != (side < 3 ? nowhere.Min.x : nowhere.Max.x))
          {
            return false;
          }
        }
      }
      else if (child > 0)
      {
        const auto next = static_cast<std::size_t>(child);
        if (next <= n || next >= count || depths[next] != 0)
        {
          return false;
        }
        depths[next] = static_cast<std::uint16_t>(depths[n] + 1);
      }
      else
      {
        const int leaf = -1 - child;
        if (static_cast<std::size_t>(leaf / Most + leaf % Most) >= boxes)
        {
          return false;
        }
      }
    }
  }
  return (count == 0) == (boxes == 0);
}
