//VTK::System::Dec
//RELIEVO::Include(extensions.glsl)
//RELIEVO::Include(exact.glsl)
//RELIEVO::Defines
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Optical depth of one sphere at a pixel, and its colour times the depth. RELIEVO_FOG_DRAWN_DEPTH:
// fog ends at the drawn depth instead of the layer.
//RELIEVO::Include(frame/drawn_depth.glsl)
#ifndef RELIEVO_FOG_DRAWN_DEPTH
//RELIEVO::Include(gbuffer/read.glsl)
#endif
//RELIEVO::Include(frame/translucent_depth.glsl)
//RELIEVO::Include(frame/volume_depth.glsl)
//RELIEVO::Include(formulas/light/fog.glsl)
flat in vec4 fogLinear;
flat in vec4 fogLinearLacks;
flat in vec4 fogSquare;
flat in vec4 fogSquareLacks;
flat in vec4 fogOrigin;
flat in vec4 fogOffset;
flat in vec3 fogColor;
uniform vec2 fogDirection;     // x and y of the ray of pixel (0, 0), per unit of depth
uniform vec4 fogDirectionStep; // its change per pixel in x, and in y
uniform float fogBegin;        // depth at which rays begin

void main()
{
  vec2 direction = fogDirection + fogDirectionStep.xy * gl_FragCoord.x +
    fogDirectionStep.zw * gl_FragCoord.y;
#ifdef RELIEVO_FOG_DRAWN_DEPTH
  float end = relievoFetchDrawnDepth(ivec2(gl_FragCoord.xy));
#else
  float end = relievoFetchDepth(ivec2(gl_FragCoord.xy));
#endif
#ifdef RELIEVO_TRANSLUCENT_DEPTH
  end = min(end, relievoFetchTranslucentDepth(ivec2(gl_FragCoord.xy)));
#endif
#ifdef RELIEVO_VOLUME_DEPTH
  end = min(end, relievoFetchVolumeDepth(ivec2(gl_FragCoord.xy)));
#endif
  end -= fogBegin;
  float chord = relievoFogChordAt(gl_FragCoord.xy - fogOrigin.zw, fogLinear, fogLinearLacks,
    fogSquare, fogSquareLacks, fogOrigin.xy, fogOffset, direction, end);
#ifdef RELIEVO_FOG_CHORD
  float depth = relievoFogLinear(chord, fogSquareLacks.w);
#else
  float depth = relievoFogBeer(chord, fogSquareLacks.w);
#endif
  if (!(depth > 0.0))
  {
    discard;
  }
  gl_FragData[0] = vec4(fogColor * depth, depth);
#ifdef RELIEVO_FOG_DOMINANT
  gl_FragDepth = depth / (1.0 + depth);
#endif
}
