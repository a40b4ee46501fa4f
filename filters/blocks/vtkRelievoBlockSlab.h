// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoBlockSlab.h
 * @brief Writes the vertices and faces of successive slices of blocks.
 */
#ifndef vtkRelievoBlockSlab_h
#define vtkRelievoBlockSlab_h

#include "vtkRelievoBlockSurface.h"

namespace relievo
{
class BlockSlab
{
public:
  BlockSlab(const BlockLabels& labels, const BlockSettings& settings, const BlockRule& rule,
    BlockSurface& surface);

  /** Prepares for slice `first`; `starts` holds the first vertex number of each slice. */
  void Begin(int first, const std::vector<vtkIdType>& starts);

  /** Writes the faces of slice k, those to the slice below, and the vertices between them. */
  void Make(int k, const std::vector<vtkIdType>& starts, vtkIdType firstFace);

  std::vector<BlockSeam> Seams;
  vtkIdType NullNormals = 0;

private:
  struct Plane // of vertices
  {
    VertexSlice Vertices;
    std::vector<BlockRule::Offset> Offsets;
    std::vector<std::array<double, 3>> Areas; // sums over the faces
    vtkIdType Start = 0;
  };

  void MakePlane(int k, const FaceSlice& lower, const FaceSlice& upper, Plane& plane) const;
  BlockRule::Offset OffsetOf(
    int i, int j, int k, const FaceSlice& lower, const FaceSlice& upper) const;
  void MakeFaces(int k, bool write, vtkIdType firstFace);
  void MakeFace(int axis, int i, int j, int k, bool low, bool write, vtkIdType& face);
  void MakeSeams(int k);
  void AddSeam(int axis, int i, int j, int k, int uses);
  void WritePlane(int k);

  const BlockLabels& Labels;
  const BlockSettings& Settings;
  const BlockRule& Rule;
  BlockSurface& Surface;
  bool NeedsLabels;
  bool Mirrored;           // the axes of the image are left-handed
  double Metric[3];        // squared lengths of the axes
  double NormalAxes[3][3]; // turns area vectors of blocks into normals
  FaceSlice Faces[3];      // k - 1, k, k + 1
  Plane Planes[2];         // below and above slice k
};
}

#endif
