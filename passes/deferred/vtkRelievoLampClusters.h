// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lists the lamps that may reach each part of the view: the view is cut into tiles of pixels and
// slices of depth, and each cell lists its lamps in their order (O. Olsson, M. Billeter, U.
// Assarsson, Clustered Deferred and Forward Shading, 2012).
//
// Lists are counted, then filled, so that no lamp is dropped, whatever their number. Slices grow
// with the distance in perspective, and are equal in parallel projection.
#ifndef vtkRelievoLampClusters_h
#define vtkRelievoLampClusters_h

#include "vtkRelievoDeferredModule.h"
#include "vtkRelievoLampList.h"

#include <string>
#include <vector>

class vtkShaderProgram;

class VTKRELIEVODEFERRED_EXPORT vtkRelievoLampClusters
{
public:
  void Build(const vtkRelievoFrameCamera& view, const vtkRelievoLampList& list);

  // Number of cells: columns, rows and slices of the view; and the width of a tile in pixels.
  int GetColumns() const { return this->Columns; }
  int GetRows() const { return this->Rows; }
  int GetSlices() const { return this->Slices; }
  int GetTile() const { return this->Tile; }

  // The slice at a depth is floor(scale * f(depth) + offset), where f is log2 in perspective, and
  // the identity in parallel projection.
  float GetSliceScale() const { return this->SliceScale; }
  float GetSliceOffset() const { return this->SliceOffset; }

  // Sets the uniforms of shaders/deferred/clusters.glsl, except the lists.
  void SetUniforms(vtkShaderProgram* program) const;

  // Start of each cell's list, columns first, then rows; at the end, the end of the last list.
  const std::vector<float>& GetCells() const { return this->Cells; }

  // Lamps by their index in vtkRelievoLampList.
  const std::vector<float>& GetLists() const { return this->Lists; }

private:
  struct Span
  {
    int Lamp;
    short Row;
    short First; // column
    short Last;
  };
  struct Sheet // all cells of a slice
  {
    std::vector<std::vector<Span>> Pieces; // in the lamps' order
    std::vector<int> Starts;
    std::vector<float> Lists;
  };

  void Divide(const vtkRelievoFrameCamera& view, const vtkRelievoLampList& list);
  void AddSpans(
    const vtkRelievoLampList& list, int lamp, std::vector<std::vector<Span>>& slices) const;
  void FillSlice(int slice);

  int Columns = 0;
  int Rows = 0;
  int Slices = 0;
  int Tile = 16;
  int Width = 0;
  int Height = 0;
  bool Parallel = false;
  double From = 0.0; // range of depths covered by slices
  double To = 1.0;
  float SliceScale = 0.0f;
  float SliceOffset = 0.0f;
  vtkRelievoSphereBounds Bounds{ glm::dmat4(1.0) };
  std::vector<double> SliceStarts;   // depths
  std::vector<glm::dvec4> RowPlanes; // between rows of tiles
  std::vector<Sheet> Sheets;
  std::vector<float> Cells;
  std::vector<float> Lists;
};

#endif
