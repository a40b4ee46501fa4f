//VTK::System::Dec
//RELIEVO::Include(extensions.glsl)
//RELIEVO::Defines
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#ifdef RELIEVO_LAMP_SHADOWS
#extension GL_ARB_texture_gather : enable
#endif
//VTK::Output::Dec
// The light of lamps at each pixel's point. RELIEVO_LAMPS_IN_CLUSTERS: lamps of the pixel's
// cluster; RELIEVO_LAMP_IN_QUAD: the lamp whose rectangle is drawn; RELIEVO_ONE_LAMP: the only
// lamp; otherwise all lamps.
// RELIEVO_COUNT_LAMPS: the numbers of computed lamps and of lamps in reach of the point instead.
// RELIEVO_GLOSS: the linear reflection in addition to the light times the surface's colour instead:
// Phong's highlights; for PBR its highlights minus the diffuse light that they replace.
// RELIEVO_LAMPS_ON_COLOR: the linear colour with the lamps' addition instead, with RELIEVO_GLOSS
// including the gloss; RELIEVO_TO_DISPLAY: encoded as the picture.
// RELIEVO_HALVES: the sum is stored in half floats.
// RELIEVO_LAMP_SHADOWS: with RELIEVO_LAMP_IN_QUAD, the lamp casts shadows.
//RELIEVO::Include(gbuffer/read.glsl)
//RELIEVO::Include(formulas/formats/half.glsl)
//RELIEVO::Include(formulas/color/srgb.glsl)
//RELIEVO::Include(formulas/geometry/unproject.glsl)
//RELIEVO::Include(deferred/lamp.glsl)
#ifdef RELIEVO_LAMP_SHADOWS
//RELIEVO::Include(shadow/lamp.glsl)
vec3 relievoFaceVC = vec3(0.0); // the triangle's normal
#endif
#ifdef RELIEVO_LAMPS_ON_COLOR
#ifdef RELIEVO_TO_DISPLAY
#define RELIEVO_APPROXIMATE_SRGB
#endif
//RELIEVO::Include(frame/color.glsl)
//RELIEVO::Include(deferred/matte.glsl)
#endif
uniform mat4 relievoProjection;
#ifdef RELIEVO_LAMP_IN_QUAD
flat in int relievoLamp;
uniform vec2 relievoSize;
#else
in vec2 texCoord;
uniform vec2 relievoSize; // of the viewport
uniform int relievoLampCount;
#endif
#ifdef RELIEVO_LAMPS_IN_CLUSTERS
//RELIEVO::Include(deferred/clusters.glsl)
#endif

struct relievoLampSum
{
  vec3 light;
  vec3 gloss;
  float computed;
  float reaching;
};

#ifdef RELIEVO_GLOSS
//RELIEVO::Include(deferred/gloss.glsl)
#endif

void relievoAddLamp(int i, int end, vec3 positionVC, vec3 normalVC, inout relievoLampSum sum)
{
  if (i < end)
  {
#ifdef RELIEVO_LAMPS_IN_CLUSTERS
    int lamp = relievoListedLamp(i);
#else
    int lamp = i;
#endif
    relievoLampRay ray = relievoSeeLamp(lamp, positionVC);
    float cosine = relievoLampCosine(normalVC, ray.toLamp, ray.range);
#ifdef RELIEVO_LAMP_SHADOWS
    if (ray.reaches && cosine > 0.0)
    {
      ray.light *= relievoLampUnshadowed(-ray.toLamp, relievoFaceVC);
    }
#endif
#ifdef RELIEVO_GLOSS
    if (ray.reaches && cosine > 0.0 && relievoIsGlossy(relievoLit))
    {
      sum.gloss += ray.light *
        relievoGloss(relievoLit, normalVC, ray.toLamp / ray.range, normalize(-positionVC));
    }
#endif
    sum.light += ray.light * cosine;
    sum.computed += 1.0;
    sum.reaching += ray.reaches ? 1.0 : 0.0;
  }
}

void main()
{
#ifdef RELIEVO_LAMP_IN_QUAD
  ivec2 pixel = ivec2(floor(gl_FragCoord.xy));
#else
  ivec2 pixel = ivec2(floor(texCoord * relievoSize));
#endif
  float depth = relievoFetchDepth(pixel);
  vec3 normalVC = relievoFetchNormal(pixel);
  relievoLampSum sum = relievoLampSum(vec3(0.0), vec3(0.0), 0.0, 0.0);
#ifdef RELIEVO_GLOSS
  relievoLit = relievoFetchSurface(pixel);
#endif
  if (!isinf(depth))
  {
    vec3 positionVC =
      relievoEyePosition(relievoNdcFromPixel(vec2(pixel), relievoSize), depth, relievoProjection);
#ifdef RELIEVO_LAMP_SHADOWS
    relievoFaceVC = relievoFetchGeometricNormal(pixel);
    relievoFaceVC = relievoFaceVC == vec3(0.0) ? normalVC : relievoFaceVC;
#endif
#if defined(RELIEVO_LAMP_IN_QUAD)
    relievoAddLamp(relievoLamp, relievoLamp + 1, positionVC, normalVC, sum);
#elif defined(RELIEVO_LAMPS_IN_CLUSTERS)
    ivec2 list = relievoFindLamps(pixel, depth);
    int from = list.x;
    int to = list.y;
#else
    int from = 0;
    int to = relievoLampCount;
#endif
#ifdef RELIEVO_ONE_LAMP
    relievoAddLamp(0, 1, positionVC, normalVC, sum);
#elif !defined(RELIEVO_LAMP_IN_QUAD)
    // Four lamps per turn: in Mesa's software OpenGL the turns of a shader end after 65535 in all.
    for (; from < to; from += 4)
    {
      relievoAddLamp(from, to, positionVC, normalVC, sum);
      relievoAddLamp(from + 1, to, positionVC, normalVC, sum);
      relievoAddLamp(from + 2, to, positionVC, normalVC, sum);
      relievoAddLamp(from + 3, to, positionVC, normalVC, sum);
    }
#endif
  }
#ifdef RELIEVO_COUNT_LAMPS
  gl_FragData[0] = vec4(sum.computed, sum.reaching, 0.0, 0.0);
#elif defined(RELIEVO_LAMPS_ON_COLOR)
  vec4 color = relievoFetchColor(pixel);
  color.rgb += relievoMatte(relievoFetchSurface(pixel)) * sum.light + sum.gloss;
#ifdef RELIEVO_TO_DISPLAY
  color = relievoShownColor(pixel, color);
#endif
  gl_FragData[0] = color;
#else
#ifdef RELIEVO_GLOSS
  vec3 given = sum.gloss;
#else
  vec3 given = sum.light;
#endif
#ifdef RELIEVO_HALVES
  // Mesa's software OpenGL truncates to half floats instead of rounding.
  given = vec3(relievoRoundToHalf(given.x), relievoRoundToHalf(given.y),
    relievoRoundToHalf(given.z));
#endif
  gl_FragData[0] = vec4(given, 0.0);
#endif
}
