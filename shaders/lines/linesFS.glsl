//VTK::System::Dec
//RELIEVO::Defines
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The cover of a pixel by lines, from its distance to the nearest side that is a line;
// premultiplied. LINES_HIDDEN: the cover is at least that of the dashes of hidden lines, drawn by
// hiddenFS.glsl.
//RELIEVO::Include(formulas/color/srgb.glsl)
in vec2 texCoord;
uniform vec2 relievoSize;
uniform sampler2D linesSides;
uniform vec3 linesColor; // sRGB, as VTK's colours
uniform float linesHalfWidth;

void main()
{
  ivec2 pixel = ivec2(floor(texCoord * relievoSize));
  float reach = linesHalfWidth + 0.5;
  int around = int(ceil(reach + 0.5));
  float nearest = reach;
  for (int y = -around; y <= around; ++y)
  {
    for (int x = -around; x <= around; ++x)
    {
      ivec2 at = pixel + ivec2(x, y);
      if (any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, ivec2(relievoSize))))
      {
        continue;
      }
      vec2 sides = texelFetch(linesSides, at, 0).xy;
      // A side is one pixel long: the right one runs upwards from (x + 0.5, y - 0.5); the upper one
      // likewise.
      vec2 off = abs(vec2(x, y));
      if (sides.x > 0.0)
      {
        nearest = min(nearest, length(vec2(float(x) + 0.5, max(off.y - 0.5, 0.0))));
      }
      if (sides.y > 0.0)
      {
        nearest = min(nearest, length(vec2(max(off.x - 0.5, 0.0), float(y) + 0.5)));
      }
    }
  }
  float cover = clamp(reach - nearest, 0.0, 1.0);
#ifdef LINES_HIDDEN
  cover = max(cover, texelFetch(linesSides, pixel, 0).z);
#endif
  if (!(cover > 0.0))
  {
    discard;
  }
  gl_FragData[0] = vec4(cover * relievoLinearColorFromSrgb(linesColor), cover);
}
