// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Converts the texels of layers of volumes (shaders/volumes/layers.glsl) to layers as arrays: the
// nearest volume's, with positions in double.
#ifndef vtkRelievoVolumeReader_h
#define vtkRelievoVolumeReader_h

#include "vtkRelievoFormulas.h" // for GLM
#include "vtkRelievoFrameCamera.h"

#include <memory>
#include <string>
#include <vector>

class vtkDataSet;
class vtkImageData;
class vtkRelievoVolumeTarget;
class vtkVolume;

// A volume in the target, as it was drawn.
struct vtkRelievoDrawnVolume
{
  int Index = -1;         // in vtkRenderer::GetVolumes()
  int Draws = 0;          // blocks that were drawn
  bool HasDepth = true;   // false: only the opacity is right
  glm::dmat4 GridToWorld; // from indices of points; from data coordinates for rectilinear grids
  glm::dmat4 GridToData;  // the space in which VTK's steps have their length
  glm::dvec3 Corners[2];  // of the grid
  glm::dvec3 Points;      // number along each axis

  void Take(vtkVolume* volume, vtkDataSet* data);
};

class vtkRelievoVolumeReader
{
public:
  vtkRelievoVolumeReader(vtkRelievoVolumeTarget& target,
    const std::vector<vtkRelievoDrawnVolume>& volumes, const vtkRelievoFrameCamera& view);
  ~vtkRelievoVolumeReader();
  vtkRelievoVolumeReader(const vtkRelievoVolumeReader&) = delete;
  void operator=(const vtkRelievoVolumeReader&) = delete;

  // Whether a volume was drawn in bricks.
  bool HasBricks() const;

  // Adds the layer to the image's point data.
  void Read(const std::string& layer, vtkImageData* image);

private:
  struct Pixels;

  const std::vector<vtkRelievoDrawnVolume>& Volumes;
  vtkRelievoFrameCamera View;
  std::unique_ptr<Pixels> Internal;
};

#endif
