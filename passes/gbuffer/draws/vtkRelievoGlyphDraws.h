// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Maps the instances of a vtkGlyph3DMapper's draw calls to input points: masks leave points out,
// and every source has its own draw calls. Also the extent of a glyph's triangles.
#ifndef vtkRelievoGlyphDraws_h
#define vtkRelievoGlyphDraws_h

#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <map>
#include <vector>

class vtkDataSet;
class vtkGlyph3DMapper;
class vtkOpenGLPolyDataMapper;
class vtkPolyData;
class vtkShaderProgram;

struct vtkRelievoGlyphDraw
{
  int Block = 0;                // flat index of the points in composite input, else 0
  vtkDataSet* Points = nullptr; // the input
  std::vector<vtkIdType> Ids;   // of the input's points, by instance
};

// In the mapper's drawing order. Culling, which reorders instances, is not modelled.
std::vector<vtkRelievoGlyphDraw> vtkRelievoGetGlyphDraws(vtkGlyph3DMapper* mapper);

// The extent of the sources in use, for shaders/gbuffer/glyph_depth.glsl.
class vtkRelievoGlyphReach
{
public:
  // Sets the uniforms of a mapper that draws glyphs; does nothing for others.
  void SetUniforms(vtkShaderProgram* program, vtkOpenGLPolyDataMapper* mapper);

private:
  struct Reach
  {
    vtkWeakPointer<vtkPolyData> Source;
    vtkMTimeType Time = 0;
    float Ball[4] = { 0.0f, 0.0f, 0.0f, 0.0f }; // centre and radius
    float Edge = 0.0f;                          // the longest edge

    void Measure();
  };
  std::map<vtkPolyData*, Reach> Reaches;
};

#endif
