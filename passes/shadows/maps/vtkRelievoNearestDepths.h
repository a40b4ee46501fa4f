// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How near to the light casters come, around each place of a map: the least depth of the texels
// that rays of a soft sun from a block of texels may pass. Nothing blocks a ray from there on, so
// that it needs no more look-ups.
//
// Known for maps whose depths the processor has; in others 0, and rays are traced to their ends.
#ifndef vtkRelievoNearestDepths_h
#define vtkRelievoNearestDepths_h

#include "vtkRelievoTextureBuffer.h"

#include <cstddef>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

class vtkRelievoNearestDepths
{
public:
  // A block has two to this power texels a side.
  static constexpr int BlockPower = 3;

  // Maps of size x size texels, of which nothing is known.
  void Begin(int size, int layers);

  ///@{
  // The depths of a map, row by row; does nothing unless bound. Forget() is for a map that changes
  // otherwise.
  void Set(int layer, const std::vector<float>& depths);
  void Forget(int layer);
  ///@}

  // Takes a texture unit, in the current context; false if there is none, or no room.
  bool Bind(vtkOpenGLRenderWindow* window);
  void Unbind();

  // Updates the texture for rays that pass at most this number of texels, for each layer.
  void Update(vtkOpenGLRenderWindow* window, const std::vector<double>& reaches);

  void Tell(vtkShaderProgram* program) const;

  vtkIdType GetBytes() const { return this->Texels.GetBytes(); }
  void Release(vtkWindow* window);

private:
  std::size_t CountBlocks() const { return static_cast<std::size_t>(this->Across) * this->Across; }
  void Spread(const float* from, int radius, float* to) const;

  int Size = 0;
  int Across = 0;             // blocks of a map's side
  std::vector<float> Nearest; // of each block of each layer, without its surroundings
  std::vector<double> Reaches;
  bool Changed = true;
  vtkRelievoTextureBuffer Texels;
};

#endif
