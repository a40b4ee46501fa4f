// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoWideTree.h"

#include "vtkRelievoBoxRecords.h"
#include "vtkRelievoRayFile.h"
#include "vtkRelievoThreads.h"

#include <limits>

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
constexpr int InASubtree = 8192;   // boxes of a subtree built by one thread
constexpr std::size_t AtOnce = 64; // subtrees built before their nodes are stored
constexpr std::size_t OfAll = 16;  // parts in which nodes are stored, at most
}

bool vtkRelievoWideTree::Avx2 = vtkRelievoAvx2::IsSupported();

//------------------------------------------------------------------------------
vtkRelievoWideTree::Box vtkRelievoWideTree::Nowhere()
{
  return { glm::vec3(std::numeric_limits<float>::max()),
    glm::vec3(-std::numeric_limits<float>::max()) };
}

// A node to be made, over a range of records.
struct vtkRelievoWideTree::Task
{
  vtkRelievoBoxRecords::Range Range;
  vtkRelievoBoxRecords::Grid Grid;
  int Parent = -1;
  int Child = 0; // the slot in the parent
  int Depth = 1;
};

// The nodes of a subtree, with indices among themselves.
struct vtkRelievoWideTree::Subtree
{
  std::vector<Node> Nodes;
  Box Whole = Nowhere();
  int Depth = 0;
  double Areas = 0.0;
};

//------------------------------------------------------------------------------
// Makes the node `index`: divides the range, always its largest part, until the node is full.
// Returns the tasks of the children that are nodes.
std::vector<vtkRelievoWideTree::Task> vtkRelievoWideTree::MakeNode(
  vtkRelievoBoxRecords& records, Task task, int leafSize, int index, Node& node)
{
  records.Refine(task.Range, task.Grid);
  vtkRelievoBoxRecords::Range children[Width];
  float areas[Width];
  children[0] = task.Range;
  areas[0] = vtkRelievoBoxRecords::GetArea(task.Range);
  int count = 1;
  while (count < Width)
  {
    int largest = -1;
    for (int i = 0; i < count; ++i)
    {
      if (children[i].Count > leafSize && (largest < 0 || areas[i] > areas[largest]))
      {
        largest = i;
      }
    }
    if (largest < 0)
    {
      break;
    }
    const vtkRelievoBoxRecords::Range divided = children[largest];
    records.Split(divided, children[largest], children[count]);
    areas[largest] = vtkRelievoBoxRecords::GetArea(children[largest]);
    areas[count] = vtkRelievoBoxRecords::GetArea(children[count]);
    ++count;
  }
  std::vector<Task> tasks;
  for (int i = 0; i < Width; ++i)
  {
    node.Child[i] = 0; // no box, or not made yet
    if (i < count && children[i].Count > leafSize)
    {
      tasks.push_back({ children[i], task.Grid, index, i, task.Depth + 1 });
    }
    else if (i < count)
    {
      node.Child[i] = -1 - (Most * children[i].First + children[i].Count - 1);
    }
  }
  return tasks;
}

//------------------------------------------------------------------------------
void vtkRelievoWideTree::MakeSubtree(
  vtkRelievoBoxRecords& records, const Task& task, int leafSize, Subtree& subtree)
{
  std::vector<Node>& nodes = subtree.Nodes;
  std::vector<Task> open(1, task);
  open[0].Parent = -1;
  while (!open.empty())
  {
    const Task next = open.back();
    open.pop_back();
    const int index = static_cast<int>(nodes.size());
    if (next.Parent >= 0)
    {
      nodes[next.Parent].Child[next.Child] = index;
    }
    subtree.Depth = std::max(subtree.Depth, next.Depth);
    nodes.emplace_back();
    const std::vector<Task> children = MakeNode(records, next, leafSize, index, nodes.back());
    open.insert(open.end(), children.begin(), children.end());
  }
  subtree.Whole = Fit(
    nodes, [&](int position) { return records.GetBox(position); }, subtree.Areas);
}

//------------------------------------------------------------------------------
void vtkRelievoWideTree::Build(int count, const GetBox& getBox, int leafSize)
{
  this->Nodes.Set({});
  this->Order.clear();
  this->Stack = 0;
  this->Cost = 0.0;
  this->CostWhenBuilt = 0.0;
  if (count == 0)
  {
    return;
  }
  vtkRelievoBoxRecords records(count, getBox, leafSize);
  // The nodes of large ranges come first; subtrees below them follow.
  std::vector<Node> top;
  std::vector<Task> below;
  std::vector<Task> open(1, Task{ records.GetAll(), vtkRelievoBoxRecords::GetFirstGrid() });
  while (!open.empty())
  {
    std::vector<Task> large;
    for (const Task& task : open)
    {
      (task.Range.Count > InASubtree ? large : below).push_back(task);
    }
    const std::size_t first = top.size();
    top.resize(first + large.size());
    std::vector<std::vector<Task>> children(large.size());
    const auto make = [&](vtkIdType i) {
      const std::size_t index = first + static_cast<std::size_t>(i);
      children[i] = MakeNode(records, large[i], leafSize, static_cast<int>(index), top[index]);
    };
    vtkRelievoForAll(static_cast<vtkIdType>(large.size()), make, 1);
    open.clear();
    for (std::size_t i = 0; i < large.size(); ++i)
    {
      if (large[i].Parent >= 0)
      {
        top[large[i].Parent].Child[large[i].Child] = static_cast<int>(first + i);
      }
      open.insert(open.end(), children[i].begin(), children[i].end());
    }
  }
  // Nodes are kept in parts: one array would be copied whenever it grows.
  std::vector<std::vector<Node>> parts;
  std::size_t made = top.size();
  double areas = 0.0;
  int depth = 0;
  Box whole = Nowhere();
  // Enough for any subtree, whose nodes have two leaves or seven further nodes at least.
  const std::size_t most = static_cast<std::size_t>(
    std::max(std::min(count, InASubtree), count / static_cast<int>(OfAll)) / leafSize + 1);
  for (std::size_t begin = 0; begin < below.size(); begin += AtOnce)
  {
    std::vector<Subtree> subtrees(std::min(AtOnce, below.size() - begin));
    const auto make = [&](vtkIdType i) {
      MakeSubtree(records, below[begin + static_cast<std::size_t>(i)], leafSize, subtrees[i]);
    };
    vtkRelievoForAll(static_cast<vtkIdType>(subtrees.size()), make, 1);
    for (std::size_t i = 0; i < subtrees.size(); ++i)
    {
      const Task& task = below[begin + i];
      const Subtree& subtree = subtrees[i];
      if (task.Parent >= 0)
      {
        top[task.Parent].Child[task.Child] = static_cast<int>(made);
        SetBox(top[task.Parent], task.Child, subtree.Whole);
      }
      if (parts.empty() || parts.back().size() + subtree.Nodes.size() > parts.back().capacity())
      {
        parts.emplace_back();
        parts.back().reserve(most);
      }
      for (Node node : subtree.Nodes)
      {
        for (int& child : node.Child)
        {
          child += child > 0 ? static_cast<int>(made) : 0;
        }
        parts.back().push_back(node);
      }
      made += subtree.Nodes.size();
      areas += subtree.Areas;
      depth = std::max(depth, subtree.Depth);
      whole = subtree.Whole;
    }
  }
  if (!top.empty())
  {
    double ofTop = 0.0;
    whole = Fit(
      top, [&](int position) { return records.GetBox(position); }, ofTop);
    areas += ofTop;
  }
  this->Stack = (Width - 1) * depth + Width;
  this->Order = records.TakeIndices();
  std::vector<Node> nodes;
  nodes.reserve(made);
  nodes.insert(nodes.end(), top.begin(), top.end());
  for (std::vector<Node>& part : parts)
  {
    nodes.insert(nodes.end(), part.begin(), part.end());
    std::vector<Node>().swap(part);
  }
  this->Nodes.Set(std::move(nodes));
  const double root = GetHalfArea(whole);
  this->Cost = root > 0.0 ? areas / root : 0.0;
  this->CostWhenBuilt = this->Cost;
}

//------------------------------------------------------------------------------
void vtkRelievoWideTree::Build(const std::vector<Box>& boxes, int leafSize)
{
  this->Build(
    static_cast<int>(boxes.size()), [&boxes](int i) { return boxes[i]; }, leafSize);
}

//------------------------------------------------------------------------------
bool vtkRelievoWideTree::Refit(const std::vector<Box>& boxes)
{
  std::vector<Node> nodes = this->Nodes.Release();
  double areas = 0.0;
  const double root = GetHalfArea(Fit(
    nodes,
    [&](int position) { return boxes[this->Order.empty() ? position : this->Order[position]]; },
    areas));
  this->Nodes.Set(std::move(nodes));
  this->Cost = root > 0.0 ? areas / root : 0.0;
  return this->Cost <= WornBy * this->CostWhenBuilt;
}

//------------------------------------------------------------------------------
void vtkRelievoWideTree::SetBox(Node& node, int child, const Box& box)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    node.Sides[axis][child] = box.Min[axis];
    node.Sides[axis + 3][child] = box.Max[axis];
  }
}

//------------------------------------------------------------------------------
// Sets the boxes of nodes; those of children that are not among them are kept. Returns the box of
// all, and the sum of their areas. Nodes come after their parents.
template <typename GetLeafBox>
vtkRelievoWideTree::Box vtkRelievoWideTree::Fit(
  std::vector<Node>& nodes, GetLeafBox getBox, double& areas)
{
  std::vector<Box> whole(nodes.size(), Nowhere());
  areas = 0.0;
  for (std::size_t n = nodes.size(); n-- > 0;)
  {
    Node& node = nodes[n];
    for (int i = 0; i < Width; ++i)
    {
      const int child = node.Child[i];
      Box box = Nowhere();
      if (child < 0)
      {
        const int leaf = -1 - child;
        for (int k = leaf / Most; k <= leaf / Most + leaf % Most; ++k)
        {
          Join(box, getBox(k));
        }
      }
      else if (static_cast<std::size_t>(child) >= nodes.size())
      {
        for (int axis = 0; axis < 3; ++axis)
        {
          box.Min[axis] = node.Sides[axis][i];
          box.Max[axis] = node.Sides[axis + 3][i];
        }
      }
      else if (child > 0)
      {
        box = whole[child];
      }
      SetBox(node, i, box);
      Join(whole[n], box);
      areas += child == 0 ? 0.0 : GetHalfArea(box);
    }
  }
  return nodes.empty() ? Nowhere() : whole[0];
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
