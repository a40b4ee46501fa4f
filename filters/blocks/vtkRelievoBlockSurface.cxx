// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoBlockSurface.h"

#include "vtkRelievoBlockSlab.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkRelievoThreads.h"

#include <algorithm>
#include <atomic>
#include <numeric>

namespace relievo
{
namespace
{
constexpr int SlabSize = 16;  // slices
constexpr int BatchSize = 16; // slabs between two reports of progress

// Runs work(first, end) for slabs of the slices 1 to count; false if stopped.
template <typename Work>
bool ForSlabs(int count, const BlockSettings& settings, double from, double to, Work&& work)
{
  const int slabs = (count + SlabSize - 1) / SlabSize;
  for (int batch = 0; batch < slabs; batch += BatchSize)
  {
    const int end = std::min(batch + BatchSize, slabs);
    vtkRelievoWithThreads([&]() {
      vtkSMPTools::For(batch, end, 1, [&](vtkIdType begin, vtkIdType last) {
        for (auto slab = static_cast<int>(begin); slab < last; ++slab)
        {
          const int first = 1 + slab * SlabSize;
          work(slab, first, std::min(first + SlabSize, count + 1));
        }
      });
    });
    if (settings.GoOn && !settings.GoOn(from + (to - from) * end / slabs))
    {
      return false;
    }
  }
  return true;
}

vtkIdType AddUp(std::vector<vtkIdType>& counts)
{
  vtkIdType sum = 0;
  for (vtkIdType& count : counts)
  {
    const vtkIdType before = sum;
    sum += count;
    count = before;
  }
  return sum;
}
}

//------------------------------------------------------------------------------
Made MakeBlockSurface(
  const BlockLabels& labels, const BlockSettings& settings, BlockSurface& surface)
{
  const BlockBox& box = labels.GetBox();
  // Slice k has the faces of its blocks, those to slice k - 1, and the vertices between the two.
  const int slices = box.Size[2] + 1;
  std::vector<vtkIdType> vertices(slices + 1, 0);
  std::vector<vtkIdType> faces(slices + 1, 0);
  std::atomic<vtkIdType> seamCount{ 0 };
  bool goOn = ForSlabs(slices, settings, 0., 0.3, [&](int, int first, int end) {
    FaceSlice lower;
    FaceSlice upper;
    VertexSlice used;
    vtkIdType edges = 0;
    lower.Make(labels, settings.Faces, first - 1, nullptr);
    for (int k = first; k < end; ++k)
    {
      upper.Make(labels, settings.Faces, k, &lower);
      used.Make(box, lower, upper);
      vertices[k] = used.Count;
      faces[k] = upper.Count();
      if (settings.Seams)
      {
        ForEachEdges(
          lower, upper, box.Size[1], [&](int, int, int, const std::array<BitSlice::Word, 4>& of) {
            edges += static_cast<vtkIdType>(VertexSlice::CountBits(SeamsOf(of)));
          });
      }
      std::swap(lower, upper);
    }
    seamCount += edges;
  });
  const vtkIdType vertexCount = AddUp(vertices);
  const vtkIdType faceCount = AddUp(faces);
  if (!goOn || vertexCount > VTK_TYPE_UINT32_MAX)
  {
    return goOn ? Made::TooLarge : Made::Stopped;
  }
  if (settings.HasRoom && !settings.HasRoom(vertexCount, faceCount, seamCount))
  {
    return Made::Stopped;
  }
  if (settings.DoublePoints)
  {
    surface.Points = vtkSmartPointer<vtkDoubleArray>::New();
  }
  else
  {
    surface.Points = vtkSmartPointer<vtkFloatArray>::New();
  }
  surface.Points->SetNumberOfComponents(3);
  surface.Points->SetNumberOfTuples(vertexCount);
  if (settings.Normals)
  {
    surface.Normals = vtkSmartPointer<vtkFloatArray>::New();
    surface.Normals->SetName("Normals");
    surface.Normals->SetNumberOfComponents(3);
    surface.Normals->SetNumberOfTuples(vertexCount);
  }
  surface.Faces.Allocate(faceCount);

  const BlockRule rule(settings.Strength);
  const int slabs = (slices + SlabSize - 1) / SlabSize;
  std::vector<std::vector<BlockSeam>> seams(slabs);
  std::vector<vtkIdType> nulls(slabs, 0);
  if (settings.KeepOffsets)
  {
    surface.Offsets.Allocate(vertexCount);
  }
  goOn = ForSlabs(slices, settings, 0.3, 0.8, [&](int number, int first, int end) {
    BlockSlab slab(labels, settings, rule, surface);
    slab.Begin(first, vertices);
    for (int k = first; k < end; ++k)
    {
      slab.Make(k, vertices, faces[k]);
    }
    seams[number] = std::move(slab.Seams);
    nulls[number] = slab.NullNormals;
  });
  surface.NullNormals = std::accumulate(nulls.begin(), nulls.end(), vtkIdType(0));
  surface.Seams.reserve(static_cast<std::size_t>(seamCount.load()));
  for (std::vector<BlockSeam>& slab : seams)
  {
    surface.Seams.insert(surface.Seams.end(), slab.begin(), slab.end());
    std::vector<BlockSeam>().swap(slab);
  }
  return goOn ? Made::Done : Made::Stopped;
}
}
