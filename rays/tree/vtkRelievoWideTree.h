// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A bounding volume hierarchy with eight boxes per node, traversed on the CPU from near to far: in
// floats with a margin for rounding, so that no hit in double is missed.
//
// Coordinates are between -1 and 1 or slightly beyond: rays start where they enter the whole box.
#ifndef vtkRelievoWideTree_h
#define vtkRelievoWideTree_h

#include "vtkRelievoAvx2.h"
#include "vtkRelievoBoxTree.h"
#include "vtkRelievoFour.h"
#include "vtkRelievoRaysModule.h" // for the export macro
#include "vtkRelievoStoredArray.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

class vtkRelievoBoxRecords;
class vtkRelievoRayFileReader;
class vtkRelievoRayFileWriter;

class VTKRELIEVORAYS_EXPORT vtkRelievoWideTree
{
public:
  using Box = vtkRelievoBoxTree::Box;

  // Margin of a box on each side around its content, for rounded rays.
  static constexpr double Room = 2.5e-7;

  // Maximum number of boxes per leaf.
  static constexpr int Most = 4;
  // Usual number of bytes that Build needs for each box: a record, and its share of nodes.
  static constexpr double BytesToBuild = 16.0 + 17.0;

  // The box of an index; called by several threads.
  using GetBox = std::function<Box(int)>;
  void Build(int count, const GetBox& getBox, int leafSize);
  void Build(const std::vector<Box>& boxes, int leafSize);

  // Refits the tree to moved boxes, whose number must be that of the last build. False if they have
  // moved so far that a rebuild pays.
  bool Refit(const std::vector<Box>& boxes);

  // The index of the box at each position in the leaves.
  const std::vector<int>& GetOrder() const { return this->Order; }

  // From now on boxes are given in the order of the leaves.
  std::vector<int> TakeOrder() { return std::exchange(this->Order, {}); }

  // The enlarged box between two positions.
  static Box Around(const glm::dvec3& low, const glm::dvec3& high)
  {
    return { glm::vec3(low - Room), glm::vec3(high + Room) };
  }
  static Box Nowhere();

  std::size_t GetBytes() const
  {
    return this->Nodes.GetBytes() + this->Order.capacity() * sizeof(int);
  }

  void Write(vtkRelievoRayFileWriter& file) const;
  // Reads a tree over so many boxes, given in the order of the leaves. False if none is there.
  bool Read(vtkRelievoRayFileReader& file, std::size_t boxes);

  // Whether rays use AVX2: by default where the processor has it. Results are the same.
  static bool UsesAvx2() { return vtkRelievoWideTree::Avx2; }
  static void SetUsesAvx2(bool uses)
  {
    vtkRelievoWideTree::Avx2 = uses && vtkRelievoAvx2::IsSupported();
  }

  // A ray in floats. The largest coordinate of the direction is 1.
  struct Ray
  {
    float From[3];
    float Inverse[3];
    int Near[3]; // which of a box's six numbers it reaches first
    // `inverse`: reciprocals of the direction's coordinates.
    Ray(const glm::dvec3& from, const glm::dvec3& inverse)
    {
      constexpr double Most = 1e18; // larger values change positions by less than Room
      for (int i = 0; i < 3; ++i)
      {
        this->From[i] = static_cast<float>(from[i]);
        this->Inverse[i] = static_cast<float>(std::min(std::max(inverse[i], -Most), Most));
        this->Near[i] = inverse[i] < 0.0 ? i + 3 : i;
      }
    }
  };

  // Calls visit(first, count) for leaves that the ray hits up to `last`, nearest boxes first;
  // `visit` returns the distance up to which further leaves matter, below 0 to stop. `leaves`, with
  // `bytes` bytes per box, is the data that `visit` reads, for prefetching.
  template <typename Visit>
  void Walk(const Ray& ray, float last, const void* leaves, std::size_t bytes, Visit visit) const;

  // A traversal as by Walk, in steps, so that several rays can take turns while memory is read.
  struct Steps
  {
    struct Entry
    {
      int Child;
      float Near;
    };
    static constexpr int Few = 160; // stack entries without allocation

    Ray Line;
    float Last = 0.f;
    int Next = 0;
    int Size = 0;
    Entry Stack[Few];

    Steps()
      : Line(glm::dvec3(0.0), glm::dvec3(1.0))
    {
    }
    void Start(const Ray& line, float last)
    {
      this->Line = line;
      this->Last = last;
      this->Next = 0;
      this->Size = 0;
    }
  };
  // Whether the stack of Steps suffices.
  bool HasSteps() const { return !this->Nodes.empty() && this->Stack <= Few; }

  // Visits a node or a leaf; false after the last one. The processor must have AVX2 for ByAvx2.
  template <bool ByAvx2, typename Visit>
  bool Step(Steps& steps, const void* leaves, std::size_t bytes, Visit visit) const;

  // Calls visit(first, count) for leaves whose boxes share a point with this one, roughly from the
  // greatest z to the least; `visit` returns whether to continue.
  template <typename Visit>
  void FindOverlaps(const Box& box, Visit visit) const;

  // A half-space: the points with Normal . x >= Least.
  struct HalfSpace
  {
    glm::dvec3 Normal;
    double Least;
  };
  // Calls visit(first, count) for leaves whose boxes, without their margin, reach into each of the
  // half-spaces; `visit` returns whether to continue.
  template <typename Visit>
  void FindWithin(const HalfSpace* spaces, int count, Visit visit) const
  {
    if (UsesAvx2())
    {
      this->FindWithinByAvx2(spaces, count, visit);
    }
    else
    {
      this->FindWithinBy(spaces, count, visit);
    }
  }

private:
  using Four = vtkRelievoFour;
  static constexpr float Rounding = 1.0000008f; // of the products on both sides

  static constexpr int Width = 8; // boxes per node
  struct alignas(32) Node
  {
    float Sides[6][Width]; // least x, y, z, and greatest, of the boxes
    // A node, or -1 - (Most x index of a leaf's first box + number of its boxes - 1).
    int Child[Width];
  };
#if defined(__GNUC__)
  // Always inlined: GCC removes calls of functions that only prefetch.
  static RELIEVO_INLINED void Prefetch(const void* at)
  {
    __builtin_prefetch(at);
    __builtin_prefetch(static_cast<const char*>(at) + 64);
  }
#else
  static void Prefetch(const void*) {}
#endif
  using Entry = Steps::Entry;
  static constexpr int Few = Steps::Few;

  template <bool ByAvx2>
  static unsigned HitBoxes(const Node& node, const Ray& ray, float last, float* t);
  static int Choose(const Node& node, unsigned bits, const float* t, Entry* stack, int& size);
  static bool Pop(const Entry* stack, int& size, float last, int& next);
  static unsigned HitBoxes(const Node& node, const Ray& ray, float last, float* t);
  template <bool ByAvx2, typename Visit>
  void WalkBy(
    const Ray& ray, float last, const void* leaves, std::size_t bytes, Visit& visit) const;
  template <typename Visit>
  RELIEVO_AVX2 void WalkByAvx2(
    const Ray& ray, float last, const void* leaves, std::size_t bytes, Visit& visit) const
  {
    this->WalkBy<true>(ray, last, leaves, bytes, visit);
  }
  static unsigned GetWithin(const Node& node, const HalfSpace* spaces, int count);
  template <typename Visit>
  void FindWithinBy(const HalfSpace* spaces, int count, Visit& visit) const;
  template <typename Visit>
  RELIEVO_AVX2 void FindWithinByAvx2(const HalfSpace* spaces, int count, Visit& visit) const
  {
    this->FindWithinBy(spaces, count, visit);
  }
  struct Task;
  struct Subtree;
  static std::vector<Task> MakeNode(
    vtkRelievoBoxRecords& records, Task task, int leafSize, int index, Node& node);
  static void MakeSubtree(
    vtkRelievoBoxRecords& records, const Task& task, int leafSize, Subtree& subtree);
  static void SetBox(Node& node, int child, const Box& box);
  template <typename GetLeafBox>
  static Box Fit(std::vector<Node>& nodes, GetLeafBox getBox, double& areas);

  static bool Avx2;
  vtkRelievoStoredArray<Node> Nodes;
  std::vector<int> Order;
  int Stack = 0; // largest size of the traversal's stack
  double Cost = 0.0;
  double CostWhenBuilt = 0.0;
};

//------------------------------------------------------------------------------
// Bits of the node's boxes that the ray hits up to `last`, and its distances to them.
inline unsigned vtkRelievoWideTree::HitBoxes(const Node& node, const Ray& ray, float last, float* t)
{
  const int* near = ray.Near;
  const auto getT = [&](int side, int i, int axis) {
    return (Four::Load(node.Sides[side] + i) - Four(ray.From[axis])) * Four(ray.Inverse[axis]);
  };
  unsigned bits = 0;
  for (int i = 0; i < Width; i += 4)
  {
    const Four low = vtkRelievoMax(vtkRelievoMax(getT(near[0], i, 0), getT(near[1], i, 1)),
      vtkRelievoMax(getT(near[2], i, 2), Four(0.f)));
    const Four high = vtkRelievoMin(vtkRelievoMin(getT(3 - near[0], i, 0), getT(5 - near[1], i, 1)),
      vtkRelievoMin(getT(7 - near[2], i, 2), Four(last)));
    low.Store(t + i);
    bits |= vtkRelievoGetBits(low <= high * Four(Rounding)) << i;
  }
  return bits;
}

//------------------------------------------------------------------------------
template <bool ByAvx2>
RELIEVO_INLINED unsigned vtkRelievoWideTree::HitBoxes(
  const Node& node, const Ray& ray, float last, float* t)
{
  return ByAvx2
    ? vtkRelievoAvx2::HitBoxes(node.Sides, ray.Near, ray.From, ray.Inverse, last, Rounding, t)
    : HitBoxes(node, ray, last, t);
}

//------------------------------------------------------------------------------
// The nearest of several boxes; the others are put on the stack.
RELIEVO_INLINED int vtkRelievoWideTree::Choose(
  const Node& node, unsigned bits, const float* t, Entry* stack, int& size)
{
  const unsigned rest = bits & (bits - 1);
  if ((rest & (rest - 1)) == 0) // two
  {
    const int a = vtkRelievoGetLowest(bits);
    const int b = vtkRelievoGetLowest(rest);
    const bool second = t[b] < t[a];
    stack[size++] = { node.Child[second ? a : b], t[second ? a : b] };
    return node.Child[second ? b : a];
  }
  const int before = size;
  for (; bits != 0; bits &= bits - 1)
  {
    const int i = vtkRelievoGetLowest(bits);
    int k = size++;
    for (; k > before && stack[k - 1].Near < t[i]; --k)
    {
      stack[k] = stack[k - 1];
    }
    stack[k] = { node.Child[i], t[i] };
  }
  return stack[--size].Child;
}

//------------------------------------------------------------------------------
RELIEVO_INLINED bool vtkRelievoWideTree::Pop(const Entry* stack, int& size, float last, int& next)
{
  do
  {
    if (size == 0)
    {
      return false;
    }
    --size;
  } while (stack[size].Near > last * Rounding);
  next = stack[size].Child;
  return true;
}

//------------------------------------------------------------------------------
template <typename Visit>
void vtkRelievoWideTree::Walk(
  const Ray& ray, float last, const void* leaves, std::size_t bytes, Visit visit) const
{
  if (UsesAvx2())
  {
    this->WalkByAvx2(ray, last, leaves, bytes, visit);
  }
  else
  {
    this->WalkBy<false>(ray, last, leaves, bytes, visit);
  }
}

//------------------------------------------------------------------------------
template <bool ByAvx2, typename Visit>
RELIEVO_INLINED void vtkRelievoWideTree::WalkBy(
  const Ray& ray, float last, const void* leaves, std::size_t bytes, Visit& visit) const
{
  if (this->Nodes.empty())
  {
    return;
  }
  Entry local[Few];
  std::vector<Entry> large;
  Entry* stack = local;
  if (this->Stack > Few)
  {
    large.resize(static_cast<std::size_t>(this->Stack));
    stack = large.data();
  }
  int size = 0;
  int next = 0;
  for (;;)
  {
    while (next >= 0)
    {
      const Node& node = this->Nodes[static_cast<std::size_t>(next)];
      alignas(32) float t[Width];
      const unsigned bits = HitBoxes<ByAvx2>(node, ray, last, t);
      if (bits == 0)
      {
        break;
      }
      if ((bits & (bits - 1)) == 0) // one
      {
        next = node.Child[vtkRelievoGetLowest(bits)];
        continue;
      }
      for (unsigned each = bits; each != 0; each &= each - 1)
      {
        const int child = node.Child[vtkRelievoGetLowest(each)];
        Prefetch(child >= 0 ? static_cast<const void*>(this->Nodes.data() + child)
                            : static_cast<const char*>(leaves) + bytes * ((-1 - child) / Most));
      }
      next = Choose(node, bits, t, stack, size);
    }
    if (next < 0)
    {
      const int leaf = -1 - next;
      last = visit(leaf / Most, leaf % Most + 1);
      if (last < 0.f)
      {
        return;
      }
    }
    if (!Pop(stack, size, last, next))
    {
      return;
    }
  }
}

//------------------------------------------------------------------------------
template <bool ByAvx2, typename Visit>
RELIEVO_INLINED bool vtkRelievoWideTree::Step(
  Steps& steps, const void* leaves, std::size_t bytes, Visit visit) const
{
  int size = steps.Size;
  int next = steps.Next;
  bool goesOn = false; // to a box within the last node
  if (next >= 0)
  {
    const Node& node = this->Nodes[static_cast<std::size_t>(next)];
    alignas(32) float t[Width];
    const unsigned bits = HitBoxes<ByAvx2>(node, steps.Line, steps.Last, t);
    goesOn = bits != 0;
    if (goesOn)
    {
      next = (bits & (bits - 1)) == 0 ? node.Child[vtkRelievoGetLowest(bits)]
                                      : Choose(node, bits, t, steps.Stack, size);
    }
  }
  else
  {
    const int leaf = -1 - next;
    steps.Last = visit(leaf / Most, leaf % Most + 1);
  }
  if (!goesOn && (steps.Last < 0.f || !Pop(steps.Stack, size, steps.Last, next)))
  {
    return false;
  }
  steps.Next = next;
  steps.Size = size;
  if (next >= 0)
  {
    const char* node = reinterpret_cast<const char*>(this->Nodes.data() + next);
    Prefetch(node);
    Prefetch(node + 128);
  }
  else
  {
    Prefetch(static_cast<const char*>(leaves) + bytes * ((-1 - next) / Most));
  }
  return true;
}

//------------------------------------------------------------------------------
template <typename Visit>
void vtkRelievoWideTree::FindOverlaps(const Box& box, Visit visit) const
{
  if (this->Nodes.empty())
  {
    return;
  }
  int local[Few];
  std::vector<int> large;
  int* stack = local;
  if (this->Stack > Few)
  {
    large.resize(static_cast<std::size_t>(this->Stack));
    stack = large.data();
  }
  const Four low[3] = { Four(box.Min.x), Four(box.Min.y), Four(box.Min.z) };
  const Four high[3] = { Four(box.Max.x), Four(box.Max.y), Four(box.Max.z) };
  int size = 0;
  stack[size++] = 0;
  while (size > 0)
  {
    const Node& node = this->Nodes[static_cast<std::size_t>(stack[--size])];
    unsigned bits = 0;
    for (int i = 0; i < Width; i += 4)
    {
      const auto overlap = [&](int axis) {
        return (Four::Load(node.Sides[axis] + i) <= high[axis]) &
          (low[axis] <= Four::Load(node.Sides[axis + 3] + i));
      };
      bits |= vtkRelievoGetBits(overlap(0) & overlap(1) & overlap(2)) << i;
    }
    const int before = size;
    float reach[Width]; // of the boxes, for the new entries
    for (; bits != 0; bits &= bits - 1)
    {
      const int i = vtkRelievoGetLowest(bits);
      int k = size++;
      for (; k > before && reach[k - before - 1] > node.Sides[5][i]; --k)
      {
        stack[k] = stack[k - 1];
        reach[k - before] = reach[k - before - 1];
      }
      stack[k] = node.Child[i];
      reach[k - before] = node.Sides[5][i];
    }
    while (size > 0 && stack[size - 1] < 0)
    {
      const int leaf = -1 - stack[--size];
      if (!visit(leaf / Most, leaf % Most + 1))
      {
        return;
      }
    }
  }
}

//------------------------------------------------------------------------------
// Bits of the node's boxes that reach into each of the half-spaces.
RELIEVO_INLINED unsigned vtkRelievoWideTree::GetWithin(
  const Node& node, const HalfSpace* spaces, int count)
{
  bool isWithin[Width];
  for (int i = 0; i < Width; ++i)
  {
    isWithin[i] = node.Child[i] != 0;
  }
  for (const HalfSpace* space = spaces; space != spaces + count; ++space)
  {
    const glm::dvec3& normal = space->Normal;
    const float* x = node.Sides[normal.x > 0.0 ? 3 : 0];
    const float* y = node.Sides[normal.y > 0.0 ? 4 : 1];
    const float* z = node.Sides[normal.z > 0.0 ? 5 : 2];
    // A box's corner was rounded by at most half of the difference.
    const double least =
      space->Least + 0.5 * Room * (std::abs(normal.x) + std::abs(normal.y) + std::abs(normal.z));
    for (int i = 0; i < Width; ++i)
    {
      isWithin[i] = isWithin[i] & (normal.x * x[i] + normal.y * y[i] + normal.z * z[i] >= least);
    }
  }
  unsigned bits = 0;
  for (int i = 0; i < Width; ++i)
  {
    bits |= isWithin[i] ? 1u << i : 0u;
  }
  return bits;
}

//------------------------------------------------------------------------------
template <typename Visit>
RELIEVO_INLINED void vtkRelievoWideTree::FindWithinBy(
  const HalfSpace* spaces, int count, Visit& visit) const
{
  if (this->Nodes.empty())
  {
    return;
  }
  int local[Few];
  std::vector<int> large;
  int* stack = local;
  if (this->Stack > Few)
  {
    large.resize(static_cast<std::size_t>(this->Stack));
    stack = large.data();
  }
  int size = 0;
  stack[size++] = 0;
  while (size > 0)
  {
    const int next = stack[--size];
    if (next < 0)
    {
      const int leaf = -1 - next;
      if (!visit(leaf / Most, leaf % Most + 1))
      {
        return;
      }
      continue;
    }
    const Node& node = this->Nodes[static_cast<std::size_t>(next)];
    for (unsigned bits = GetWithin(node, spaces, count); bits != 0; bits &= bits - 1)
    {
      stack[size++] = node.Child[vtkRelievoGetLowest(bits)];
    }
  }
}

#endif
