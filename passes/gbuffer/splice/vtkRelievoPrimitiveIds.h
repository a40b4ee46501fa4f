// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Tests whether a fragment shader gets the number of its primitive (gl_PrimitiveID), by drawing a
// few triangles. Mesa's software OpenGL 25.3.0 to 26.1.5 reads another varying's value without a
// geometry shader (Mesa's issue 15660).
#ifndef vtkRelievoPrimitiveIds_h
#define vtkRelievoPrimitiveIds_h

#include "vtkRelievoGBufferModule.h" // for the export macro

#include <cstdint>
#include <string>
#include <vector>

class vtkActor;
class vtkOpenGLPolyDataMapper;
class vtkOpenGLRenderWindow;

namespace vtkRelievoPrimitiveIds
{
enum Route
{
  AsWritten = 0,             // the fragment shader reads it
  ThroughGeometryShader = 1, // a geometry shader passes it on
  Unreliable = 2             // neither works: primitives are unknown
};

// The route in the window's context, determined once for each; the context must be current.
VTKRELIEVOGBUFFER_EXPORT Route Get(vtkOpenGLRenderWindow* window);

// The route in words, for reports.
VTKRELIEVOGBUFFER_EXPORT const char* ToString(Route route);

// For tests: the route of every context from now on; -1: determined as usual.
VTKRELIEVOGBUFFER_EXPORT void Force(int route);

// The probe draws triangle i over row i. Whether the words read back, row by row, confirm this.
constexpr int Rows = 8;
constexpr int Columns = 4;
VTKRELIEVOGBUFFER_EXPORT bool Check(const std::vector<std::uint32_t>& words);

// Makes a geometry shader that passes on all outputs of the vertex shader, and the primitive's
// number. Appends VSOutput, VTK's ending, to the vertex shader's varyings that lack it. Empty if an
// output cannot be passed on. `corners`: 1 for points, 2 for lines, 3 for triangles.
VTKRELIEVOGBUFFER_EXPORT std::string MakeGeometryShader(std::string& vertex, int corners);

// Number of corners of the primitives in the mapper's present draw of the actor.
int GetCorners(vtkOpenGLPolyDataMapper* mapper, vtkActor* actor);
}

#endif
