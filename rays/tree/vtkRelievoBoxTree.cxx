// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoBoxTree.h"

#include "vtkRelievoAvx2.h" // for RELIEVO_INLINED
#include "vtkRelievoThreads.h"

#include <algorithm>
#include <limits>

namespace
{
using Box = vtkRelievoBoxTree::Box;
using Node = vtkRelievoBoxTree::Node;

constexpr int Bins = 16;
constexpr int Few = 32;          // up to this number of boxes all splits are tried, without bins
constexpr int ForAThread = 8192; // boxes of a subtree built by one thread

const Box Nothing = { glm::vec3(std::numeric_limits<float>::max()),
  glm::vec3(-std::numeric_limits<float>::max()) };

// Inlined by force: calls take a sixth of a build.
RELIEVO_INLINED void Add(Box& box, const Box& other)
{
  box.Min = glm::min(box.Min, other.Min);
  box.Max = glm::max(box.Max, other.Max);
}

RELIEVO_INLINED float GetArea(const Box& box)
{
  const glm::vec3 size = glm::max(box.Max - box.Min, glm::vec3(0.f));
  return size.x * size.y + size.y * size.z + size.z * size.x;
}

RELIEVO_INLINED glm::vec3 GetMiddle(const Box& box)
{
  return 0.5f * box.Min + 0.5f * box.Max;
}

int RoundUp(int count, int leafSize)
{
  return (count + leafSize - 1) / leafSize * leafSize;
}
}

// The split of a range of boxes: their number on the left, sorted along an axis. By the surface
// area heuristic.
struct vtkRelievoBoxTree::Split
{
  int Axis = 0;
  int Left = 0;
  float Cost = std::numeric_limits<float>::max();

  void Offer(int axis, int left, float cost)
  {
    if (cost < this->Cost)
    {
      *this = { axis, left, cost };
    }
  }

  // Tries every split.
  void TryAll(const std::vector<Box>& boxes, std::vector<int>& sorted, int leafSize)
  {
    const int count = static_cast<int>(sorted.size());
    std::vector<float> after(count);
    for (int axis = 0; axis < 3; ++axis)
    {
      std::sort(sorted.begin(), sorted.end(), [&](int a, int b) {
        const float x = GetMiddle(boxes[a])[axis];
        const float y = GetMiddle(boxes[b])[axis];
        return x < y || (x == y && a < b);
      });
      Box box = Nothing;
      for (int i = count - 1; i > 0; --i)
      {
        Add(box, boxes[sorted[i]]);
        after[i] = GetArea(box);
      }
      box = Nothing;
      for (int i = 0; i < count - 1; ++i)
      {
        Add(box, boxes[sorted[i]]);
        const int left = i + 1;
        if (left % leafSize == 0)
        {
          this->Offer(axis, left,
            GetArea(box) * static_cast<float>(left) +
              after[left] * static_cast<float>(count - left));
        }
      }
    }
  }

  // Splits between a few bins, moved so that leaves are full.
  void TryBins(const std::vector<Box>& boxes, const int* order, int count, int leafSize)
  {
    Box middles = Nothing;
    for (int i = 0; i < count; ++i)
    {
      const glm::vec3 middle = GetMiddle(boxes[order[i]]);
      Add(middles, { middle, middle });
    }
    const glm::vec3 widths = middles.Max - middles.Min;
    Box bins[3][Bins];
    int counts[3][Bins] = {};
    std::fill_n(bins[0], 3 * Bins, Nothing);
    for (int i = 0; i < count; ++i)
    {
      const Box& box = boxes[order[i]];
      const glm::vec3 shares = (GetMiddle(box) - middles.Min) / widths;
      for (int axis = 0; axis < 3; ++axis)
      {
        if (widths[axis] > 0.f)
        {
          const int bin = std::min(Bins - 1, static_cast<int>(shares[axis] * Bins));
          Add(bins[axis][bin], box);
          ++counts[axis][bin];
        }
      }
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      if (!(widths[axis] > 0.f))
      {
        continue;
      }
      float after[Bins];
      Box box = Nothing;
      for (int bin = Bins - 1; bin > 0; --bin)
      {
        Add(box, bins[axis][bin]);
        after[bin] = GetArea(box);
      }
      box = Nothing;
      int left = 0;
      for (int bin = 0; bin < Bins - 1; ++bin)
      {
        Add(box, bins[axis][bin]);
        left += counts[axis][bin];
        if (left > 0 && left < count)
        {
          const int whole = std::min(RoundUp(left, leafSize), RoundUp(count, leafSize) - leafSize);
          this->Offer(axis, whole,
            GetArea(box) * static_cast<float>(left) +
              after[bin + 1] * static_cast<float>(count - left));
        }
      }
    }
  }
};

//------------------------------------------------------------------------------
// A node with n leaves below it is followed by 2 n - 2 others.
std::array<glm::vec4, 2> vtkRelievoBoxTree::Node::GetTexels(int index, int leafSize) const
{
  const int leaves =
    this->Next < 0 ? -1 - (-1 - this->Next) / leafSize : (this->Next - index + 1) / 2;
  return { glm::vec4(this->Low, static_cast<float>(leaves)),
    glm::vec4(this->High, static_cast<float>(this->Count)) };
}

//------------------------------------------------------------------------------
int vtkRelievoBoxTree::GetNumberOfNodes(int boxes, int leafSize)
{
  return boxes > 0 ? 2 * (RoundUp(boxes, leafSize) / leafSize) - 1 : 0;
}

//------------------------------------------------------------------------------
vtkRelievoBoxTree::Task vtkRelievoBoxTree::MakeNode(
  const std::vector<Box>& boxes, const Task& task, Task& right)
{
  Node& node = this->Nodes[task.Node];
  right.Count = 0;
  if (task.Count <= this->LeafSize)
  {
    node.Next = -1 - task.First;
    node.Count = task.Count;
    return { task.Node, task.First, 0 };
  }
  int* const order = this->Order.data() + task.First;
  Split split;
  if (task.Count <= Few)
  {
    std::vector<int> sorted(order, order + task.Count);
    split.TryAll(boxes, sorted, this->LeafSize);
  }
  else
  {
    split.TryBins(boxes, order, task.Count, this->LeafSize);
  }
  if (split.Left <= 0 || split.Left >= task.Count) // all boxes have one position
  {
    split = { 0, RoundUp(task.Count / 2, this->LeafSize), 0.f };
  }
  std::vector<std::pair<float, int>> sorted(static_cast<std::size_t>(task.Count));
  std::transform(order, order + task.Count, sorted.begin(), [&](int box) {
    return std::make_pair(
      0.5f * boxes[box].Min[split.Axis] + 0.5f * boxes[box].Max[split.Axis], box);
  });
  std::nth_element(sorted.begin(), sorted.begin() + split.Left, sorted.end());
  std::transform(sorted.begin(), sorted.end(), order, [](const auto& each) { return each.second; });
  node.Next = task.Node + GetNumberOfNodes(task.Count, this->LeafSize);
  node.Count = 0;
  const Task left = { task.Node + 1, task.First, split.Left };
  right = { left.Node + GetNumberOfNodes(split.Left, this->LeafSize), task.First + split.Left,
    task.Count - split.Left };
  return left;
}

//------------------------------------------------------------------------------
void vtkRelievoBoxTree::MakeSubtree(const std::vector<Box>& boxes, const Task& task)
{
  std::vector<Task> open(1, task);
  while (!open.empty())
  {
    const Task next = open.back();
    open.pop_back();
    Task right{};
    const Task left = this->MakeNode(boxes, next, right);
    if (right.Count > 0)
    {
      open.push_back(right);
      open.push_back(left);
    }
  }
}

//------------------------------------------------------------------------------
void vtkRelievoBoxTree::Build(const std::vector<Box>& boxes, int leafSize)
{
  this->LeafSize = leafSize;
  const int count = static_cast<int>(boxes.size());
  this->Nodes.assign(GetNumberOfNodes(count, leafSize), Node());
  this->Order.resize(count);
  for (int i = 0; i < count; ++i)
  {
    this->Order[i] = i;
  }
  std::vector<Task> large(count > 0 ? 1 : 0, Task{ 0, 0, count });
  std::vector<Task> small;
  while (!large.empty())
  {
    const std::vector<Task> now = std::move(large);
    std::vector<Task> next(2 * now.size());
    const auto make = [&](vtkIdType i) {
      next[2 * i] = now[i];
      if (now[i].Count > ForAThread)
      {
        next[2 * i] = this->MakeNode(boxes, now[i], next[2 * i + 1]);
      }
    };
    vtkRelievoForAll(static_cast<vtkIdType>(now.size()), make, 1);
    large.clear();
    for (const Task& task : next)
    {
      if (task.Count > 0)
      {
        (task.Count > ForAThread ? large : small).push_back(task);
      }
    }
  }
  const auto makeBelow = [&](vtkIdType i) { this->MakeSubtree(boxes, small[i]); };
  vtkRelievoForAll(static_cast<vtkIdType>(small.size()), makeBelow, 1);
  this->FitNodes(boxes);
}

//------------------------------------------------------------------------------
void vtkRelievoBoxTree::Refit(const std::vector<Box>& boxes)
{
  this->FitNodes(boxes);
}

//------------------------------------------------------------------------------
void vtkRelievoBoxTree::FitNodes(const std::vector<Box>& boxes)
{
  // Children come after their parents.
  for (int i = static_cast<int>(this->Nodes.size()) - 1; i >= 0; --i)
  {
    Node& node = this->Nodes[i];
    Box box = Nothing;
    if (node.Count > 0)
    {
      const int first = -1 - node.Next;
      for (int k = first; k < first + node.Count; ++k)
      {
        Add(box, boxes[this->Order[k]]);
      }
    }
    else
    {
      const Node& left = this->Nodes[i + 1];
      const Node& right = this->Nodes[left.Count > 0 ? i + 2 : left.Next];
      Add(box, { left.Low, left.High });
      Add(box, { right.Low, right.High });
    }
    node.Low = box.Min;
    node.High = box.Max;
  }
}

//------------------------------------------------------------------------------
double vtkRelievoBoxTree::GetCost() const
{
  double sum = 0.0;
  for (const Node& node : this->Nodes)
  {
    sum += GetArea({ node.Low, node.High });
  }
  const double root =
    this->Nodes.empty() ? 0.0 : GetArea({ this->Nodes[0].Low, this->Nodes[0].High });
  return root > 0.0 ? sum / root : 0.0;
}
