// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The blocks of an image in which every sample of VTK's march is transparent, as a texture of each
// block's distance to the next one that is not (shaders/volumes/skip.glsl).
//
// A block's values, with those of the voxels next to it, have a least and a greatest one, between
// which all interpolated values lie; it is empty if VTK's table of opacities is 0 from the one to
// the other.
#ifndef vtkRelievoEmptyBlocks_h
#define vtkRelievoEmptyBlocks_h

#include "vtkRelievoFormulas.h" // for GLM
#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <string>
#include <vector>

class vtkDataArray;
class vtkOpenGLGPUVolumeRayCastMapper;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkVolume;

class vtkRelievoEmptyBlocks
{
public:
  vtkRelievoEmptyBlocks() = default;
  ~vtkRelievoEmptyBlocks();
  vtkRelievoEmptyBlocks(const vtkRelievoEmptyBlocks&) = delete;
  void operator=(const vtkRelievoEmptyBlocks&) = delete;

  // Brings the blocks up to date with the mapper's image and the volume's opacities. Returns the
  // reason why no sample can be left out, or an empty string. leastShare: share of the blocks that
  // have to be empty.
  std::string Update(vtkOpenGLGPUVolumeRayCastMapper* mapper, vtkVolume* volume, double leastShare,
    vtkOpenGLRenderWindow* window);

  // Sets the uniforms for the last Update(), with the texture in this unit.
  void SetUniforms(vtkShaderProgram* program, vtkOpenGLRenderWindow* window, int unit) const;

  // Numbers of blocks, and of those that are empty.
  vtkIdType GetNumber() const { return static_cast<vtkIdType>(this->Lows.size()); }
  vtkIdType GetNumberEmpty() const { return this->Empty; }

  vtkIdType GetBytes() const { return this->Texture ? this->GetNumber() : 0; }

  // Frees the texture, with its window's context current.
  void Release();

private:
  template <typename Value>
  void FindRanges(const Value* values);
  template <typename Value>
  void FindRangesOfSlab(const Value* values, int slab);
  void FindEmpty();
  std::string Upload(vtkOpenGLRenderWindow* window);

  vtkWeakPointer<vtkDataArray> Values; // of which the ranges were found
  vtkMTimeType Time = 0;               // of them and of their image
  glm::ivec3 Size = glm::ivec3(0);     // voxels along each axis
  int Side = 0;                        // of a block, in voxels
  glm::ivec3 Blocks = glm::ivec3(0);   // along each axis
  std::vector<double> Lows;            // of each block
  std::vector<double> Highs;
  double Range[2] = { 0.0, 1.0 };       // of VTK's table
  std::vector<double> Opacities;        // VTK's table, of a unit distance
  std::vector<unsigned char> Distances; // of each block, in blocks; 0: not empty
  vtkIdType Empty = 0;
  unsigned int Texture = 0;
};

#endif
