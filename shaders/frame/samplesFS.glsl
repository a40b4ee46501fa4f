//VTK::System::Dec
//RELIEVO::Include(extensions.glsl)
//RELIEVO::Defines
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The mean, in linear light, of a pixel's samples in a raster, which are premultiplied and
// composited over the earlier drawing; with RELIEVO_MARKED: only for marked pixels. With
// RELIEVO_DEPTH: the z of the sample nearest to the pixel's centre.
//RELIEVO::Include(formulas/formats/half.glsl)
//RELIEVO::Include(frame/raster.glsl)
#ifndef RELIEVO_DEPTH
//RELIEVO::Include(formulas/color/blend.glsl)
//RELIEVO::Include(formulas/color/srgb.glsl)
//RELIEVO::Include(frame/drawn.glsl)
#endif
in vec2 texCoord;
uniform vec2 relievoSize;
#ifdef RELIEVO_MARKED
uniform sampler2D relievoMarks;
#endif

void main()
{
  ivec2 pixel = ivec2(floor(texCoord * relievoSize));
#ifdef RELIEVO_DEPTH
  gl_FragData[0] = vec4(0.0);
  gl_FragDepth = texelFetch(relievoRasterZ, relievoRasterCenter(pixel), 0).r;
#else
#ifdef RELIEVO_MARKED
  if (texelFetch(relievoMarks, pixel, 0).r == 0.0)
  {
    discard;
  }
#endif
  ivec2 first = relievoRasterFirst + pixel.x * relievoRasterRight + pixel.y * relievoRasterUp;
  vec4 behind = texelFetch(relievoDrawn, pixel + relievoDrawnOffset, 0);
  vec4 sum = vec4(0.0);
  vec4 least = vec4(1e30);
  vec4 most = vec4(-1e30);
  for (int i = 0; i < RELIEVO_SAMPLES; ++i)
  {
    vec4 drawn = texelFetch(relievoRasterColor, first + ivec2(relievoRasterCells[i]), 0);
    sum += drawn;
    least = min(least, drawn);
    most = max(most, drawn);
  }
  vec4 shown = relievoOver(sum / float(RELIEVO_SAMPLES), behind);
  vec4 mean = vec4(relievoLinearColorFromSrgb(shown.rgb), shown.a);
  // Averaging display values with this or a smaller difference causes an error below 0.00016 in
  // linear light: half the curve's second derivative times the square of half the difference.
  bool alike = all(lessThan(most - least, vec4(0.02)));
  vec4 linear = vec4(0.0);
  for (int i = 0; i < (alike ? 0 : RELIEVO_SAMPLES); ++i)
  {
    vec4 each =
      relievoOver(texelFetch(relievoRasterColor, first + ivec2(relievoRasterCells[i]), 0), behind);
    linear += vec4(relievoLinearColorFromSrgb(each.rgb), each.a);
  }
  mean = alike ? mean : linear / float(RELIEVO_SAMPLES);
  gl_FragData[0] = vec4(relievoRoundToHalf(mean.r), relievoRoundToHalf(mean.g),
    relievoRoundToHalf(mean.b), relievoRoundToHalf(mean.a));
#endif
}
