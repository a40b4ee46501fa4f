// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Whether a fragment shader gets the number of its primitive (gl_PrimitiveID). Mesa's software
// OpenGL 25.3.0 to 26.1.5 reads it from another varying's place where there is no geometry shader
// (Mesa's issue 15660). A few triangles tell.
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
  ThroughGeometryShader = 1, // a geometry shader hands it on
  Unreliable = 2             // neither works: nothing is known of primitives
};

// The route of the window's context, found out once for each; the context must be current.
VTKRELIEVOGBUFFER_EXPORT Route Get(vtkOpenGLRenderWindow* window);

// The route in words, for reports.
VTKRELIEVOGBUFFER_EXPORT const char* ToString(Route route);

// For tests: the route of every context from now on; -1: as it is found out.
VTKRELIEVOGBUFFER_EXPORT void Force(int route);

// The probe draws triangle i over row i. Whether the words read back, row by row, say so.
constexpr int Rows = 8;
constexpr int Columns = 4;
VTKRELIEVOGBUFFER_EXPORT bool Check(const std::vector<std::uint32_t>& words);

// A geometry shader that hands all on that the vertex shader puts out, and the primitive's number.
// Varyings without VTK's ending VSOutput get it in the vertex shader. Empty if the vertex shader
// puts out what cannot be handed on. `corners`: 1 for points, 2 for lines, 3 for triangles.
VTKRELIEVOGBUFFER_EXPORT std::string MakeGeometryShader(std::string& vertex, int corners);

// Corners of the primitives that the mapper draws for the actor now.
int GetCorners(vtkOpenGLPolyDataMapper* mapper, vtkActor* actor);
}

#endif
