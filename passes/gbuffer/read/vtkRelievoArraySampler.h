// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Interpolates a point or cell array at a pixel, on the mesh itself: the ids give the cell, the
// pixel's ray the position in it. An array so costs no GPU memory, keeps its own precision, and is
// interpolated in double. Id words as the only record of visibility: Burns and Hunt, The Visibility
// Buffer, JCGT 2(2), 2013.
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

  // `layer` is an array's name, point:NAME or cell:NAME.
  vtkRelievoArraySampler(
    const std::string& layer, const vtkRelievoDrawTable& draws, const vtkRelievoFrameCamera& view);

  // Looks the array up in the drawn meshes, else in all of the renderer's data, which may be hidden
  // or translucent; returns VTK_FLOAT or VTK_DOUBLE, and sets an error message.
  int Prepare(vtkRenderer* renderer, int& components, std::string& error);

  struct Source
  {
    vtkDataArray* Array = nullptr;
    bool OfPoints = false;
  };

  // The mesh and cell shown at a thread's pixel, cached because neighbours mostly show the same
  // one.
  struct Place
  {
    std::uint32_t Word = vtkRelievoDrawTable::Nothing;
    vtkRelievoDrawTable::Hit Hit;
    Source Values;
    vtkRelievoCellGeometry Geometry;
    vtkNew<vtkIdList> Scratch;
  };
  void Enter(std::uint32_t word, Place& place) const;

  // The values at the pixel, on the given place; NaN in the background or if the array is missing.
  // `eye`: the position in eye space, if it does not follow from the pixel.
  void Sample(const Place& place, int x, int y, const glm::dvec3* eye, double* values) const;

private:
  // A mesh may be drawn by several actors.
  using Key = std::pair<const void*, const void*>;

  Source Find(vtkDataSet* data, bool cells) const;
  bool Take(vtkDataArray* array); // false for nullptr
  bool FindHidden(vtkRenderer* renderer);
  void SampleInCell(const Place& place, int x, int y, const glm::dvec3* eye, double* values) const;

  std::string Name;
  bool AllowPoints = true;
  bool AllowCells = true;
  const vtkRelievoDrawTable& Draws;
  const vtkRelievoFrameCamera& View;
  int Components = 0;
  bool Wide = false; // doubles, and integers of four bytes and more, do not fit into a float
  std::map<Key, Source> Sources;
};

#endif
