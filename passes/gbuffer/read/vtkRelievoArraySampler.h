// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The value of a point or cell array at a pixel, from the mesh itself: the ids say which cell, the
// pixel's ray says where in it. So an array costs no GPU memory, keeps its own precision, and is
// interpolated in double. The id words as the only record of visibility: Burns and Hunt, The
// Visibility Buffer, JCGT 2(2), 2013.
#ifndef vtkRelievoArraySampler_h
#define vtkRelievoArraySampler_h

#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkRelievoCellGeometry.h"
#include "vtkRelievoDrawTable.h"
#include "vtkRelievoFrameCamera.h"

#include <map>
#include <string>
#include <utility>

class vtkDataArray;
class vtkDataSet;
class vtkRenderer;

class vtkRelievoArraySampler
{
public:
  static constexpr int MaximumComponents = 16;

  // The layer is an array's name, or point:NAME or cell:NAME.
  vtkRelievoArraySampler(
    const std::string& layer, const vtkRelievoDrawTable& draws, const vtkRelievoFrameCamera& view);

  // Looks the array up in what was drawn, else in all that the renderer has, which may be hidden or
  // translucent; returns VTK_FLOAT or VTK_DOUBLE and says what is wrong.
  int Prepare(vtkRenderer* renderer, int& components, std::string& wrong);

  struct Source
  {
    vtkDataArray* Array = nullptr;
    bool OfPoints = false;
  };

  // What a thread's pixel shows. Kept from pixel to pixel: neighbours mostly show the same.
  struct Place
  {
    std::uint32_t Word = vtkRelievoDrawTable::Nothing;
    vtkRelievoDrawTable::Hit Hit;
    Source Values;
    vtkRelievoCellGeometry Geometry;
    vtkNew<vtkIdList> Scratch;
  };
  void Enter(std::uint32_t word, Place& place) const;

  // The values at the pixel, which shows the place; NaN where nothing is or the array is missing.
  // `eye`: where it is in eye space, if that does not follow from the pixel.
  void Sample(const Place& place, int x, int y, const glm::dvec3* eye, double* values) const;

private:
  // A mesh may be drawn by several actors.
  using Key = std::pair<const void*, const void*>;

  Source Find(vtkDataSet* data, bool cells) const;
  bool Take(vtkDataArray* array); // false for none
  bool FindHidden(vtkRenderer* renderer);
  void SampleInCell(const Place& place, int x, int y, const glm::dvec3* eye, double* values) const;

  std::string Name;
  bool AllowPoints = true;
  bool AllowCells = true;
  const vtkRelievoDrawTable& Draws;
  const vtkRelievoFrameCamera& View;
  int Components = 0;
  bool Wide = false; // integers of four bytes and more, and doubles, do not fit into a float
  std::map<Key, Source> Sources;
};

#endif
