//VTK::System::Dec
//RELIEVO::Include(extensions.glsl)
//RELIEVO::Defines
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Marks a pixel if a few samples of it and of its neighbours are not the values of a plane: see
// vtkRelievoSampleMarks.
//RELIEVO::Include(frame/raster.glsl)
// Three levels of 255; fewer for dark colours, which may be exposed.
#define RELIEVO_MARKS_STEP 0.012
in vec2 texCoord;
uniform vec2 relievoSize;

vec4 sampleAt(ivec2 cell)
{
  ivec2 last = textureSize(relievoRasterColor, 0) - 1;
  return texelFetch(relievoRasterColor, clamp(cell, ivec2(0), last), 0);
}

void main()
{
  ivec2 cell = relievoRasterCenter(ivec2(floor(texCoord * relievoSize)));
  vec4 own = 2.0 * sampleAt(cell);
  vec4 most = vec4(0.0);
  for (int y = 0; y <= 2; ++y)
  {
    for (int x = (y == 0 ? 1 : -2); x <= 2; ++x)
    {
      ivec2 off = ivec2(x, y);
      most = max(most, abs(sampleAt(cell + off) + sampleAt(cell - off) - own));
    }
  }
  float step = max(max(most.r, most.g), max(most.b, most.a));
  float bright = clamp(max(own.r, max(own.g, own.b)), 0.25, 1.0); // own is twice the value
  gl_FragData[0] = vec4(step > bright * RELIEVO_MARKS_STEP ? 1.0 : 0.0);
}
