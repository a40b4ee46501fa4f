// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoBoxTree.h"

#include "vtkRelievoAvx2.h" // for RELIEVO_INLINED
#include "vtkRelievoBoxRecords.h"
#include "vtkRelievoThreads.h"

#include <algorithm>
#include <limits>

namespace
{
using Box = vtkRelievoBoxTree::Box;
using Node = vtkRelievoBoxTree::Node;

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

int RoundUp(int count, int leafSize)
{
  return (count + leafSize - 1) / leafSize * leafSize;
}
}

struct vtkRelievoBoxTree::Task
{
  int Node = 0;
  vtkRelievoBoxRecords::Range Range;
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
// Returns whether it has children: false for a leaf.
bool vtkRelievoBoxTree::MakeNode(
  vtkRelievoBoxRecords& records, const Task& task, Task& left, Task& right)
{
  Node& node = this->Nodes[task.Node];
  vtkRelievoBoxRecords::Range range = task.Range;
  if (range.Count <= this->LeafSize)
  {
    node.Next = -1 - range.First;
    node.Count = range.Count;
    return false;
  }
  vtkRelievoBoxRecords::Grid grid; // needed for no areas
  records.Refine(range, grid);
  node.Next = task.Node + GetNumberOfNodes(range.Count, this->LeafSize);
  node.Count = 0;
  records.Split(range, left.Range, right.Range);
  left.Node = task.Node + 1;
  right.Node = left.Node + GetNumberOfNodes(left.Range.Count, this->LeafSize);
  return true;
}

//------------------------------------------------------------------------------
void vtkRelievoBoxTree::MakeSubtree(vtkRelievoBoxRecords& records, const Task& task)
{
  std::vector<Task> open(1, task);
  while (!open.empty())
  {
    const Task next = open.back();
    open.pop_back();
    Task left, right;
    if (this->MakeNode(records, next, left, right))
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
  this->Order.clear();
  if (count == 0)
  {
    return;
  }
  Box whole = Nothing;
  for (const Box& box : boxes)
  {
    Add(whole, box);
  }
  const glm::vec3 middle = 0.5f * whole.Max + 0.5f * whole.Min;
  const glm::vec3 half = 0.5f * whole.Max - 0.5f * whole.Min;
  const float reach = std::max({ half.x, half.y, half.z });
  const float scale = reach > 0.f ? 1.f / reach : 0.f;
  // Between -1 and 1; NaN becomes -1. Boxes far smaller than the whole may fall on one point: they
  // are then split by index, which is correct and slower to ask.
  const auto fit = [&](const glm::vec3& corner) {
    return glm::min(glm::vec3(1.f), glm::max(glm::vec3(-1.f), (corner - middle) * scale));
  };
  vtkRelievoBoxRecords records(
    count,
    [&](int i) {
      return Box{ fit(boxes[i].Min), fit(boxes[i].Max) };
    },
    leafSize);
  std::vector<Task> large(1, Task{ 0, records.GetAll() });
  std::vector<Task> small;
  while (!large.empty())
  {
    std::vector<Task> now;
    for (const Task& task : large)
    {
      (task.Range.Count > ForAThread ? now : small).push_back(task);
    }
    large.resize(2 * now.size());
    const auto make = [&](vtkIdType i) {
      this->MakeNode(records, now[i], large[2 * i], large[2 * i + 1]);
    };
    vtkRelievoForAll(static_cast<vtkIdType>(now.size()), make, 1);
  }
  const auto makeBelow = [&](vtkIdType i) { this->MakeSubtree(records, small[i]); };
  vtkRelievoForAll(static_cast<vtkIdType>(small.size()), makeBelow, 1);
  this->Order = records.TakeIndices();
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
