//VTK::System::Dec
//RELIEVO::Include(extensions.glsl)
//RELIEVO::Defines
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The least and the greatest finite value in squares of 16 x 16 pixels; 1 and 0 without any.
//RELIEVO::Include(formulas/geometry/unproject.glsl)
#ifndef RELIEVO_SHOW_VOLUME_DEPTH
//RELIEVO::Include(gbuffer/read.glsl)
#endif
in vec2 texCoord;
uniform vec2 relievoSize;    // of the viewport
uniform vec2 relievoSquares; // number of squares
uniform mat4 relievoProjection;
//RELIEVO::Include(display/value.glsl)

void main()
{
  ivec2 first = 16 * ivec2(floor(texCoord * relievoSquares));
  ivec2 end = min(first + 16, ivec2(relievoSize));
  bool any = false;
  vec2 extremes = vec2(1.0, 0.0);
  for (int y = first.y; y < end.y; ++y)
  {
    for (int x = first.x; x < end.x; ++x)
    {
      float value = relievoShownValue(ivec2(x, y));
      if (!isinf(value) && !isnan(value))
      {
        extremes = any ? vec2(min(extremes.x, value), max(extremes.y, value)) : vec2(value);
        any = true;
      }
    }
  }
  gl_FragData[0] = vec4(extremes, 0.0, 1.0);
}
