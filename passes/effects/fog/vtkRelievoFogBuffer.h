// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Optical depth and colour of fog at each pixel: each sphere draws its rectangle, and either the
// depths add up or the greatest one remains.
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

  // Removes all spheres; Add() appends the spheres in view. `chord` is the stage's mode.
  void Clear();
  void Add(const vtkRelievoSphereRays& rays, vtkRelievoFogSpheres* fog, bool chord);

  int GetNumberOfSpheres() const { return static_cast<int>(this->Texels.size() / 32); }

  // The viewport's rectangle with spheres: x, y, width, height.
  const int* GetPart() const { return this->Part; }

  // The stage's mode and overlap, and whether pixels without spheres have no fog instead of
  // undefined values.
  struct Options
  {
    bool Chord = false;
    bool Dominant = false;
    bool Everywhere = false;
  };

  // Draws the fog in front of opaque surfaces, or, if depths of translucent surfaces and volumes
  // are given, the fog in front of the nearest of all. Returns an error message, or an empty
  // string.
  std::string Draw(vtkRelievoFrameContext& context, const vtkRelievoSphereRays& rays,
    const Options& options, const std::vector<vtkRelievoResource*>& nearer = {});

  // Whether fog ends at the drawn depth instead of the layer `depth`.
  bool BeforeDrawn = false;

  // Colour times optical depth, and optical depth; `fogDepth` in shaders.
  vtkRelievoScreenTarget Target;

  vtkIdType GetBytes() const { return this->Target.GetBytes() + this->Spheres.GetBytes(); }
  void Release(vtkWindow* window);

private:
  std::vector<float> Texels;
  int Part[4] = { 0, 0, 0, 0 };
  vtkRelievoTextureBuffer Spheres;
  vtkRelievoInstancedQuads Quads[2]; // in front of opaque, and of translucent surfaces
};

#endif
