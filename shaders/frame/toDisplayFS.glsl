//VTK::System::Dec
//RELIEVO::Defines
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// From linear light to the display, or, with RELIEVO_AS_DRAWN, what is made for it already; and
// with RELIEVO_DEPTH_LEFT the depth as the delegate left it.
//RELIEVO::Include(frame/drawn.glsl)
#ifndef RELIEVO_AS_DRAWN
//RELIEVO::Include(formulas/srgb.glsl)
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
