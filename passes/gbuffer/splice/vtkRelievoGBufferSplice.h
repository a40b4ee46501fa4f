// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Splices shaders/gbuffer into the shaders of VTK's mappers, in VTK's two replacement steps.
#ifndef vtkRelievoGBufferSplice_h
#define vtkRelievoGBufferSplice_h

#include "codes.glsl"

#include <string>

class vtkActor;
class vtkOpenGLPolyDataMapper;
struct vtkRelievoGBufferLayout;

namespace vtkRelievoGBufferSplice
{
// Source of a fragment's primitive word.
enum PrimitiveSource
{
  PrimitiveOfMesh = RELIEVO_PRIMITIVE_OF_MESH,
  InstanceOfGlyphs = RELIEVO_PRIMITIVE_OF_GLYPHS,
  NoPrimitive = RELIEVO_PRIMITIVE_NONE,
  PointOfMesh = RELIEVO_PRIMITIVE_OF_POINTS // a sphere or a stick at every point
};

// The source for the mapper's present draw of the actor, and the source that a shader was built
// with.
int GetPrimitiveSource(vtkOpenGLPolyDataMapper* mapper, vtkActor* actor);
int GetPrimitiveSource(const std::string& fragment);

// Inserts marks before VTK replaces its own tags.
void Mark(std::string& vertex, std::string& geometry, std::string& fragment);

// Settings of the drawing, independent of the layout.
struct Mode
{
  bool LayersOnly = false;       // the colour is not shown
  bool LinearVisibility = false; // the depth buffer holds depth / far
  int PrimitiveIds = 0;          // a vtkRelievoPrimitiveIds::Route
  bool Deferred = false;         // VTK's lights are left out where possible

  bool operator!=(const Mode& other) const
  {
    return this->LayersOnly != other.LayersOnly ||
      this->LinearVisibility != other.LinearVisibility ||
      this->PrimitiveIds != other.PrimitiveIds || this->Deferred != other.Deferred;
  }
};

// Fills the marks. On failure returns a message and leaves the shaders unchanged.
std::string Fill(std::string& vertex, std::string& geometry, std::string& fragment,
  vtkOpenGLPolyDataMapper* mapper, vtkActor* actor, const vtkRelievoGBufferLayout& layout,
  const Mode& mode);
}

#endif
