// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Puts shaders/gbuffer into the shaders that VTK's mappers build, in VTK's two replacement steps.
#ifndef vtkRelievoGBufferSplice_h
#define vtkRelievoGBufferSplice_h

#include "codes.glsl"

#include <string>

class vtkActor;
class vtkOpenGLPolyDataMapper;
struct vtkRelievoGBufferLayout;

namespace vtkRelievoGBufferSplice
{
// Where a fragment's primitive word comes from.
enum PrimitiveSource
{
  PrimitiveOfMesh = RELIEVO_PRIMITIVE_OF_MESH,
  InstanceOfGlyphs = RELIEVO_PRIMITIVE_OF_GLYPHS,
  NoPrimitive = RELIEVO_PRIMITIVE_NONE,
  PointOfMesh = RELIEVO_PRIMITIVE_OF_POINTS // a sphere or a stick at every point
};

// The source of a mapper that draws for an actor now, and the one that its shader was made with.
int GetPrimitiveSource(vtkOpenGLPolyDataMapper* mapper, vtkActor* actor);
int GetPrimitiveSource(const std::string& fragment);

// Marks the places, before VTK fills its own tags.
void Mark(std::string& vertex, std::string& geometry, std::string& fragment);

// How the layers are drawn, beside what they are.
struct Mode
{
  bool LayersOnly = false;       // nobody sees the colour
  bool LinearVisibility = false; // the depth buffer holds depth / far
  int PrimitiveIds = 0;          // a vtkRelievoPrimitiveIds::Route
  bool Deferred = false;         // VTK's lights are left out where that can be

  bool operator!=(const Mode& other) const
  {
    return this->LayersOnly != other.LayersOnly ||
      this->LinearVisibility != other.LinearVisibility ||
      this->PrimitiveIds != other.PrimitiveIds || this->Deferred != other.Deferred;
  }
};

// Fills the places. Returns what is missing, in words, and leaves the shaders as they are then.
std::string Fill(std::string& vertex, std::string& geometry, std::string& fragment,
  vtkOpenGLPolyDataMapper* mapper, vtkActor* actor, const vtkRelievoGBufferLayout& layout,
  const Mode& mode);
}

#endif
