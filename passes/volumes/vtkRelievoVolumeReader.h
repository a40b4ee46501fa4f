// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Converts the texels of layers of volumes (shaders/volumes/layers.glsl) to layers as arrays: the
// nearest volume's, with positions in double.
#ifndef vtkRelievoVolumeReader_h
#define vtkRelievoVolumeReader_h

#include "vtkRelievoFormulas.h" // for GLM
#include "vtkRelievoFrameCamera.h"
#include "vtkRelievoVolumeMarch.h"

#include <memory>
#include <string>
#include <vector>

class vtkGPUVolumeRayCastMapper;
class vtkImageData;
class vtkRelievoVolumeTarget;
class vtkVolume;

// A volume in the target, as it was drawn.
struct vtkRelievoDrawnVolume
{
  int Index = -1;         // in vtkRenderer::GetVolumes()
  int Draws = 0;          // blocks that were drawn
  bool HasDepth = true;   // false: only the opacity is right
  bool IsExtreme = false; // drawn as maximum or minimum intensity
  bool IsWhole = false;   // values are those of points, and whole numbers
  glm::dmat4 GridToWorld; // from indices of points; from data coordinates for rectilinear grids
  glm::dmat4 GridToData;  // the space in which VTK's steps have their length
  glm::dvec3 Corners[2];  // of the grid
  glm::dvec3 Points;      // number along each axis

  bool HasMarch = false; // March is known
  vtkRelievoVolumeMarch March;

  // `longest`: see vtkRelievoVolumeMarch::Take.
  void Take(vtkGPUVolumeRayCastMapper* mapper, vtkVolume* volume, int longest);
};

class vtkRelievoVolumeReader
{
public:
  // Reads the target. The rule and its threshold are those by which the volumes were drawn.
  // `refines`: whether to find places in double; otherwise they are those of the GPU.
  vtkRelievoVolumeReader(vtkRelievoVolumeTarget& target,
    std::vector<vtkRelievoDrawnVolume>& volumes, const vtkRelievoFrameCamera& view, int rule,
    double threshold, bool refines);
  ~vtkRelievoVolumeReader();
  vtkRelievoVolumeReader(const vtkRelievoVolumeReader&) = delete;
  void operator=(const vtkRelievoVolumeReader&) = delete;

  // Whether a volume was drawn in bricks, whose places cannot be combined.
  bool HasLostBricks() const;

  // Adds the layer to the image's point data. The first that is not the opacity marches in double,
  // once for all.
  void Read(const std::string& layer, vtkImageData* image);

  // Puts volumes into a layer of surfaces: depth, range or position.
  void Amend(const std::string& layer, vtkImageData* image);

private:
  struct Pixels;

  void FindAll();
  void Find(int volume);

  std::vector<vtkRelievoDrawnVolume>& Volumes;
  vtkRelievoFrameCamera View;
  int Rule;
  double Threshold;
  bool Refines;
  std::unique_ptr<Pixels> Internal;
};

#endif
