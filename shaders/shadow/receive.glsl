// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Spliced into VTK's fragment shaders: how much of each casting light reaches the fragment, and the
// light's colour taken down by it wherever VTK's own code reads it.
//
// Defines, by vtkRelievoShadowSplice: RELIEVO_SHADOW_LIGHTS (casting lights), RELIEVO_SHADOW_FACES
// (room for their maps), RELIEVO_SHADOW_NUMBERS (lights of the renderer), and of the mapper's
// shader: RELIEVO_SHADOW_FACE_NORMAL (a surface: its plane comes from derivatives),
// RELIEVO_SHADOW_IMPOSTOR (VTK moved vertexVC to the impostor, normalVCVSOutput is exact).

//RELIEVO::Section(FragmentDec)
//RELIEVO::Include(formulas/shadow.glsl)
uniform sampler2DArray relievoShadowMaps;
uniform mat4 relievoShadowMatrix[RELIEVO_SHADOW_FACES]; // eye space to map space
uniform float relievoShadowTexel[RELIEVO_SHADOW_FACES]; // depth of a texel's width, at w = 1
uniform int relievoShadowLayer[RELIEVO_SHADOW_FACES];
uniform int relievoShadowFirst[RELIEVO_SHADOW_LIGHTS + 1]; // first face of each light
uniform vec4 relievoShadowSource[RELIEVO_SHADOW_LIGHTS]; // eye space; w = 0: direction to the light
uniform float relievoShadowStrength[RELIEVO_SHADOW_LIGHTS];
uniform int relievoShadowSlot[RELIEVO_SHADOW_NUMBERS]; // of light N of the renderer; -1: casts none
uniform float relievoShadowSize;  // of a map, in texels
uniform int relievoShadowRadius;  // of the filter, in texels; 0: the nearest texel alone
uniform float relievoShadowBias;  // in texels
uniform float relievoShadowLift;  // in texels: of points and lines, which have no plane
uniform int relievoShadowReceives;
float relievoVisibility[RELIEVO_SHADOW_LIGHTS];

float relievoVisibilityOf(int number)
{
  int slot = relievoShadowSlot[number];
  return slot < 0 ? 1.0 : relievoVisibility[slot];
}

// Whether light passes a texel, seen from a receiver of that depth. Nothing is drawn at depth 1.
float relievoShadowTap(ivec2 texel, int layer, float receiver)
{
  int last = int(relievoShadowSize) - 1;
  float caster =
    texelFetch(relievoShadowMaps, ivec3(clamp(texel, ivec2(0), ivec2(last)), layer), 0).r;
  return receiver <= caster || caster >= 1.0 ? 1.0 : 0.0;
}

float relievoShadowFilter(int layer, vec3 map, vec2 slope, float bias)
{
  vec2 place = map.xy * relievoShadowSize - 0.5;
  vec2 corner = floor(place);
  vec2 part = place - corner;
  vec2 perTexel = slope / relievoShadowSize;
  // The receiver's own depth at each texel's centre, a little towards the light.
  float depth = map.z - bias;
  if (relievoShadowRadius == 0)
  {
    vec2 nearest = floor(place + 0.5);
    return relievoShadowTap(ivec2(nearest), layer, depth + dot(perTexel, nearest - place));
  }
  float lit = 0.0;
  for (int j = 1 - relievoShadowRadius; j <= relievoShadowRadius; ++j)
  {
    float row = 0.0;
    for (int i = 1 - relievoShadowRadius; i <= relievoShadowRadius; ++i)
    {
      vec2 tap = corner + vec2(i, j);
      row += relievoFilterWeight(i, relievoShadowRadius, part.x) *
        relievoShadowTap(ivec2(tap), layer, depth + dot(perTexel, tap - place));
    }
    lit += relievoFilterWeight(j, relievoShadowRadius, part.y) * row;
  }
  float across = float(2 * relievoShadowRadius - 1);
  return lit / (across * across);
}

// normalVC: of the receiver's plane, towards the eye; zero if there is no plane.
float relievoShadowLookUp(int light, vec3 positionVC, vec3 normalVC)
{
  vec4 source = relievoShadowSource[light];
  bool plane = dot(normalVC, normalVC) > 0.0;
  // The side that is seen is turned away from the light: the surface itself is in between.
  if (plane && dot(normalVC, source.xyz - source.w * positionVC) <= 0.0)
  {
    return 0.0;
  }
  float border = float(relievoShadowRadius) / relievoShadowSize;
  for (int face = relievoShadowFirst[light]; face < relievoShadowFirst[light + 1]; ++face)
  {
    vec4 map = relievoShadowMatrix[face] * vec4(positionVC, 1.0);
    vec3 place = map.xyz / map.w;
    if (map.w > 0.0 && all(greaterThanEqual(place.xy, vec2(border))) &&
      all(lessThanEqual(place.xy, vec2(1.0 - border))))
    {
      float texel = relievoShadowTexel[face] / map.w;
      vec2 slope = vec2(0.0);
      float bias = (relievoShadowBias + (plane ? 0.0 : relievoShadowLift)) * texel;
      if (plane)
      {
        slope = relievoReceiverSlope(
          relievoShadowMatrix[face], map, normalVC, 64.0 * texel * relievoShadowSize);
      }
      return relievoShadowFilter(
        relievoShadowLayer[face], vec3(place.xy, min(place.z, 1.0)), slope, bias);
    }
  }
  return 1.0;
}

//RELIEVO::Section(LightDec)
vec3 relievoShadowedColorRELIEVO_NUMBER;
vec3 relievoUnshadowedColorRELIEVO_NUMBER()
{
  return lightColorRELIEVO_NUMBER;
}
// VTK's code below reads the light's colour by this name.
#define lightColorRELIEVO_NUMBER relievoShadowedColorRELIEVO_NUMBER

//RELIEVO::Section(UniformFlow)
#ifdef RELIEVO_SHADOW_FACE_NORMAL
  vec3 relievoShadowDx = dFdx(vertexVC.xyz);
  vec3 relievoShadowDy = dFdy(vertexVC.xyz);
#endif

//RELIEVO::Section(FragmentImpl)
  vec3 relievoShadowNormalVC = vec3(0.0);
#if defined(RELIEVO_SHADOW_IMPOSTOR)
  relievoShadowNormalVC = RELIEVO_IMPOSTOR_NORMAL;
#elif defined(RELIEVO_SHADOW_FACE_NORMAL)
  relievoShadowNormalVC =
    normalize(cross(normalize(relievoShadowDx), normalize(relievoShadowDy)));
  if ((cameraParallel != 0 ? -relievoShadowNormalVC.z
                           : dot(relievoShadowNormalVC, vertexVC.xyz)) > 0.0)
  {
    relievoShadowNormalVC = -relievoShadowNormalVC;
  }
#endif
  for (int i = 0; i < RELIEVO_SHADOW_LIGHTS; ++i)
  {
    relievoVisibility[i] = relievoShadowReceives == 0
      ? 1.0
      : relievoShadowLookUp(i, vertexVC.xyz, relievoShadowNormalVC);
  }

//RELIEVO::Section(LightImpl)
  relievoShadowedColorRELIEVO_NUMBER = relievoUnshadowedColorRELIEVO_NUMBER() *
    (1.0 - relievoShadowStrength[RELIEVO_SLOT] * (1.0 - relievoVisibility[RELIEVO_SLOT]));
