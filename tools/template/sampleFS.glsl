//VTK::System::Dec
//RELIEVO::Include(extensions.glsl)
//RELIEVO::Defines
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Fades distant surfaces towards a colour, in linear light.
//RELIEVO::Include(gbuffer/read.glsl)
//RELIEVO::Include(frame/color.glsl)
//RELIEVO::Include(formulas/color/srgb.glsl)
in vec2 texCoord;
uniform vec2 relievoSize;
uniform vec3 sampleColor; // sRGB, as VTK's colours
uniform float sampleStrength;

void main()
{
  ivec2 pixel = ivec2(floor(texCoord * relievoSize));
  vec4 color = relievoFetchColor(pixel);
  float depth = relievoFetchDepth(pixel);
  float far = clamp((depth - relievoNear) / (relievoFar - relievoNear), 0.0, 1.0);
  float share = isinf(depth) ? 0.0 : sampleStrength * far;
  // The colour is premultiplied: what covers a part of the pixel fades as that part.
  vec3 faded = color.a * relievoLinearColorFromSrgb(sampleColor);
  gl_FragData[0] = vec4(mix(color.rgb, faded, share), color.a);
}
