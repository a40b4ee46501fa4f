//VTK::System::Dec
//RELIEVO::Defines
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Encodes linear light for the display; with RELIEVO_AS_DRAWN, copies the display colours; with
// RELIEVO_DEPTH_LEFT, also writes the delegate's depth.
//RELIEVO::Include(frame/drawn.glsl)
#ifndef RELIEVO_AS_DRAWN
#define RELIEVO_APPROXIMATE_SRGB
//RELIEVO::Include(formulas/color/srgb.glsl)
//RELIEVO::Include(frame/color.glsl)
#endif
in vec2 texCoord;
uniform vec2 relievoSize;

void main()
{
  ivec2 pixel = ivec2(floor(texCoord * relievoSize));
#ifdef RELIEVO_AS_DRAWN
  gl_FragData[0] = texelFetch(relievoDrawn, pixel + relievoDrawnOffset, 0);
#else
  gl_FragData[0] = relievoShownColor(pixel, relievoFetchColor(pixel));
#endif
#ifdef RELIEVO_DEPTH_LEFT
  gl_FragDepth = texelFetch(relievoDrawnZ, pixel + relievoDrawnOffset, 0).r;
#endif
}
