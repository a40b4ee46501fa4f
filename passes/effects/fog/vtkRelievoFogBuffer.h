// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Optical depth and colour of fog by pixels: each sphere draws its rectangle, and the depths add up
// or the greatest is kept.
#ifndef vtkRelievoFogBuffer_h
#define vtkRelievoFogBuffer_h

#include "vtkRelievoInstancedQuads.h"
#include "vtkRelievoScreenTarget.h"
#include "vtkRelievoTextureBuffer.h"

#include <string>
#include <vector>

class vtkRelievoSphereRays;
class vtkRelievoFogSpheres;
class vtkRelievoFrameContext;
class vtkWindow;

class vtkRelievoFogBuffer
{
public:
  vtkRelievoFogBuffer();
  ~vtkRelievoFogBuffer();

  // Forgets the spheres, and adds those of which anything is in view. `chord` is the stage's mode.
  void Clear();
  void Add(const vtkRelievoSphereRays& rays, vtkRelievoFogSpheres* fog, bool chord);

  int GetNumberOfSpheres() const { return static_cast<int>(this->Texels.size() / 32); }

  // The pixels of the viewport with spheres: x, y, width, height.
  const int* GetPart() const { return this->Part; }

  // Draws them before what is opaque, and only before what is translucent if that is given. Pixels
  // without spheres have no fog if `everywhere`, else anything. Returns what is wrong, in words.
  std::string Draw(vtkRelievoFrameContext& context, const vtkRelievoSphereRays& rays, bool chord,
    bool dominant, bool everywhere, vtkRelievoResource* translucent = nullptr);

  // Whether fog ends at the z that is drawn, rather than at the layer `depth`.
  bool BeforeDrawn = false;

  // Colour times optical depth, and optical depth; `fogDepth` in shaders.
  vtkRelievoScreenTarget Target;

  vtkIdType GetBytes() const { return this->Target.GetBytes() + this->Spheres.GetBytes(); }
  void Release(vtkWindow* window);

private:
  std::vector<float> Texels;
  int Part[4] = { 0, 0, 0, 0 };
  vtkRelievoTextureBuffer Spheres;
  vtkRelievoInstancedQuads Quads[2]; // before opaque, and translucent
};

#endif
