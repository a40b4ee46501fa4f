//VTK::System::Dec
//RELIEVO::Include(extensions.glsl)
//RELIEVO::Defines
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The fog of a pixel, premultiplied, to be blended over the linear colour; RELIEVO_TO_DISPLAY:
// composited over it and encoded as the picture.
//RELIEVO::Include(formulas/light/fog.glsl)
#ifdef RELIEVO_TO_DISPLAY
#define RELIEVO_APPROXIMATE_SRGB
//RELIEVO::Include(frame/color.glsl)
#endif
in vec2 texCoord;
uniform vec2 relievoSize;
uniform sampler2D fogDepth; // colour times optical depth, optical depth

void main()
{
  ivec2 pixel = ivec2(floor(texCoord * relievoSize));
  vec4 fog = texelFetch(fogDepth, pixel, 0);
#ifdef RELIEVO_TO_DISPLAY
  vec4 over = fog.a > 0.0 ? relievoFogShare(fog.a) * fog : vec4(0.0);
  vec4 color = over + (1.0 - over.a) * relievoFetchColor(pixel);
  gl_FragData[0] = relievoShownColor(pixel, color);
#else
  if (!(fog.a > 0.0))
  {
    discard;
  }
  gl_FragData[0] = relievoFogShare(fog.a) * fog;
#endif
}
