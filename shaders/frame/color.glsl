// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The linear colour of the frame, premultiplied; pixel (0, 0) is the viewport's lower left one.
// Colours that no stage has changed are decoded here from the delegate's drawing: everywhere with
// RELIEVO_COLOR_DRAWN, outside a rectangle with RELIEVO_COLOR_PART.
//RELIEVO::Include(frame/linear.glsl)
uniform sampler2D relievoColor;
#ifdef RELIEVO_COLOR_PART
uniform ivec2 relievoColorFrom;
uniform ivec2 relievoColorTo; // after the last pixel
#endif

vec4 relievoFetchColor(ivec2 pixel)
{
#if defined(RELIEVO_COLOR_DRAWN)
  return relievoFetchLinear(pixel);
#elif defined(RELIEVO_COLOR_PART)
  bool changed = all(greaterThanEqual(pixel, relievoColorFrom)) &&
    all(lessThan(pixel, relievoColorTo));
  return changed ? texelFetch(relievoColor, pixel, 0) : relievoFetchLinear(pixel);
#else
  return texelFetch(relievoColor, pixel, 0);
#endif
}

// The picture of a linear colour, for shaders that also read `drawn`. Unchanged colours are shown
// as drawn, since the curve and its inverse may round to the neighbouring byte. Framebuffers of
// floats also have colours above 1.
vec4 relievoShownColor(ivec2 pixel, vec4 color)
{
  vec4 drawn = texelFetch(relievoDrawn, pixel + relievoDrawnOffset, 0);
  vec4 shown = vec4(relievoApproximateSrgbColorFromLinear(color.rgb), color.a);
  vec4 rounding = 5.0e-6 * max(vec4(1.0), abs(drawn));
  return all(lessThan(abs(shown - drawn), rounding)) ? drawn : shown;
}
