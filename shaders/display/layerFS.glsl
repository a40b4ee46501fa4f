//VTK::System::Dec
//RELIEVO::Include(extensions.glsl)
//RELIEVO::Defines
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Shows a layer as the picture. RELIEVO_SHOW_COLORS: colours made by the CPU; otherwise the layer's
// shader word in the catalogue: RELIEVO_SHOW_DEPTH ...
//RELIEVO::Include(formulas/geometry/unproject.glsl)
#if !defined(RELIEVO_SHOW_COLORS) && !defined(RELIEVO_SHOW_VOLUME_DEPTH)
//RELIEVO::Include(gbuffer/read.glsl)
#endif
in vec2 texCoord;
uniform vec2 relievoSize;    // of the viewport
uniform vec2 relievoShown;     // values of the first and the last colour
uniform vec4 relievoBackground; // with its opacity, by which processes composite their pictures
uniform int relievoGrey;
uniform int relievoWorldNormals;
uniform mat4 relievoProjection;
uniform mat4 relievoViewToWorld;
#ifdef RELIEVO_SHOW_COLORS
uniform sampler2D relievoColors;
#endif

#if defined(RELIEVO_SHOW_NORMAL) || defined(RELIEVO_SHOW_GEOMETRIC_NORMAL)
vec4 relievoVectorColor(vec3 normalVC)
{
  vec3 n = relievoWorldNormals != 0 ? mat3(relievoViewToWorld) * normalVC : normalVC;
  return dot(n, n) > 0.0 ? vec4(0.5 * normalize(n) + 0.5, 1.0) : relievoBackground;
}
#endif

#if defined(RELIEVO_SHOW_DEPTH) || defined(RELIEVO_SHOW_RANGE) || \
  defined(RELIEVO_SHOW_VOLUME_DEPTH)
//RELIEVO::Include(display/value.glsl)
uniform sampler2D relievoMap; // the colours as one row
vec4 relievoScalarColor(float value)
{
  if (isinf(value))
  {
    // A grey picture shows the background as farther than everything.
    return relievoGrey != 0 ? vec4(1.0) : relievoBackground;
  }
  float t = (value - relievoShown.x) / (relievoShown.y - relievoShown.x);
  if (relievoGrey != 0)
  {
    return vec4(vec3(t), 1.0);
  }
  // From the middle of the first texel to the middle of the last one.
  vec2 size = vec2(textureSize(relievoMap, 0));
  return vec4(
    texture(relievoMap, vec2((clamp(t, 0.0, 1.0) * (size.x - 1.0) + 0.5) / size.x, 0.5)).rgb, 1.0);
}
#endif

void main()
{
  ivec2 pixel = ivec2(floor(texCoord * relievoSize));
#if defined(RELIEVO_SHOW_COLORS)
  vec4 color = texelFetch(relievoColors, pixel, 0);
  gl_FragData[0] = color.a > 0.0 ? vec4(color.rgb, 1.0) : relievoBackground;
#elif defined(RELIEVO_SHOW_DEPTH) || defined(RELIEVO_SHOW_RANGE) || \
  defined(RELIEVO_SHOW_VOLUME_DEPTH)
  gl_FragData[0] = relievoScalarColor(relievoShownValue(pixel));
#elif defined(RELIEVO_SHOW_NORMAL)
  gl_FragData[0] = relievoVectorColor(relievoFetchNormal(pixel));
#elif defined(RELIEVO_SHOW_GEOMETRIC_NORMAL)
  gl_FragData[0] = relievoVectorColor(relievoFetchNormalAt(pixel, RELIEVO_GEOMETRIC_NORMAL_WORD));
#elif defined(RELIEVO_SHOW_ALBEDO)
  vec4 albedo = relievoFetchAlbedo(pixel);
  gl_FragData[0] = albedo.a > 0.0 ? vec4(albedo.rgb, 1.0) : relievoBackground;
#endif
}
