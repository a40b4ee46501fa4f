// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The range of depths of a glyph's triangle. Rasterisers round corners to parts of a pixel: the
// depth of a triangle narrower than that is extrapolated far beyond its edges at a pixel's centre.

//RELIEVO::Section(VertexDec)
uniform vec4 relievoGlyphBall; // centre and radius, in coordinates of the glyph's source
uniform float relievoGlyphEdge; // the source's longest edge
flat out vec2 relievoGlyphDepthsVSOutput;

//RELIEVO::Section(VertexImpl)
  {
    mat4 glyphToView = MCVCMatrix * GCMCMatrix;
    float stretch = length(vec3(glyphToView[0].z, glyphToView[1].z, glyphToView[2].z));
    // Each corner lies within the longest edge's length of this one, and within the ball.
    float corner = -(glyphToView * vertexMC).z;
    float centre = -(glyphToView * vec4(relievoGlyphBall.xyz, 1.0)).z;
    float edge = relievoGlyphEdge * stretch;
    float radius = relievoGlyphBall.w * stretch;
    // Margin for the float rounding of corners on the ball.
    float slack = 0.001 * edge +
      2.5e-7 * (abs(corner) + abs(glyphToView[3].z) + abs(MCVCMatrix[3].z));
    relievoGlyphDepthsVSOutput = vec2(max(corner - edge, centre - radius) - slack,
      min(corner + edge, centre + radius) + slack);
  }

//RELIEVO::Section(GeometryDec)
flat in vec2 relievoGlyphDepthsVSOutput[];
flat out vec2 relievoGlyphDepthsGSOutput;

//RELIEVO::Section(GeometryImpl)
  relievoGlyphDepthsGSOutput = relievoGlyphDepthsVSOutput[i];

//RELIEVO::Section(FragmentDec)
flat in vec2 relievoGlyphDepthsVSOutput;
