// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Spliced into VTK's fragment shaders: how much of each casting light reaches the fragment, and the
// light's colour taken down by it wherever VTK's own code reads it.
//
// Defines, by vtkRelievoShadowSplice: RELIEVO_SHADOW_LIGHTS (casting lights), RELIEVO_SHADOW_FACES
// (room for their maps), RELIEVO_SHADOW_NUMBERS (lights of the renderer), RELIEVO_SHADOW_WIDE (the
// filter's radius is above 1), and of the mapper's shader: RELIEVO_SHADOW_HAS_PLANE, RELIEVO_SHADOW_FACE_NORMAL (a surface: its plane comes from derivatives),
// RELIEVO_SHADOW_IMPOSTOR (VTK moved vertexVC to the impostor, normalVCVSOutput is exact).

//RELIEVO::Section(Extensions)
#extension GL_ARB_texture_gather : enable

//RELIEVO::Section(FragmentDec)
//RELIEVO::Include(formulas/shadow.glsl)
uniform sampler2DArray relievoShadowMaps;
uniform mat4 relievoShadowMatrix[RELIEVO_SHADOW_FACES]; // eye space to map space
uniform mat4 relievoShadowPlane[RELIEVO_SHADOW_FACES];  // the same for planes
uniform float relievoShadowTexel[RELIEVO_SHADOW_FACES]; // depth of a texel's width, at w = 1
uniform int relievoShadowLayer[RELIEVO_SHADOW_FACES];   // -1: no map
uniform vec4 relievoShadowSource[RELIEVO_SHADOW_LIGHTS]; // eye space; w = 0: direction to the light
uniform float relievoShadowStrength[RELIEVO_SHADOW_LIGHTS];
uniform int relievoShadowSlot[RELIEVO_SHADOW_NUMBERS]; // of light N of the renderer; -1: casts none
uniform float relievoShadowSize;  // of a map, in texels
uniform int relievoShadowRadius;  // of the filter, in texels; 0: the nearest texel alone
uniform float relievoShadowBias;  // in texels
uniform float relievoShadowLift;  // in texels: of points and lines, which have no plane
uniform float relievoShadowReceives; // 0 or 1
float relievoVisibility[RELIEVO_SHADOW_LIGHTS];

float relievoVisibilityOf(int number)
{
  int slot = relievoShadowSlot[number];
  return slot < 0 ? 1.0 : relievoVisibility[slot];
}

// Depths of the texels right and above of a corner texel, as textureGather orders them: (0, 1),
// (1, 1), (1, 0), (0, 0).
vec4 relievoShadowGather(int layer, vec2 corner)
{
#ifdef GL_ARB_texture_gather
  return textureGather(
    relievoShadowMaps, vec3((corner + 1.0) / relievoShadowSize, float(layer)));
#else
  ivec2 last = ivec2(relievoShadowSize) - 1;
  ivec2 low = clamp(ivec2(corner), ivec2(0), last);
  ivec2 high = clamp(ivec2(corner) + 1, ivec2(0), last);
  return vec4(texelFetch(relievoShadowMaps, ivec3(low.x, high.y, layer), 0).r,
    texelFetch(relievoShadowMaps, ivec3(high, layer), 0).r,
    texelFetch(relievoShadowMaps, ivec3(high.x, low.y, layer), 0).r,
    texelFetch(relievoShadowMaps, ivec3(low, layer), 0).r);
#endif
}

// Which of those texels let light through to a receiver with this depth at the corner texel. Nothing
// is drawn at depth 1.
vec4 relievoShadowLit(int layer, vec2 corner, float depth, vec2 perTexel)
{
  vec4 casters = relievoShadowGather(layer, corner);
  vec4 receivers = depth + vec4(perTexel.y, perTexel.x + perTexel.y, perTexel.x, 0.0);
  return max(step(receivers, casters), step(vec4(1.0), casters));
}

// place: in map space. Branches cost more than they save: this is one straight line of code.
float relievoShadowFilter(int layer, vec3 place, vec2 slope)
{
  vec2 at = place.xy * relievoShadowSize - 0.5;
  vec2 corner = floor(at);
  vec2 part = at - corner;
  vec2 perTexel = slope / relievoShadowSize;
  float depth = place.z - dot(perTexel, part);
#ifdef RELIEVO_SHADOW_WIDE
  float lit = 0.0;
  for (int j = 1 - relievoShadowRadius; j < relievoShadowRadius; j += 2)
  {
    vec2 y = vec2(relievoFilterWeight(j, relievoShadowRadius, part.y),
      relievoFilterWeight(j + 1, relievoShadowRadius, part.y));
    for (int i = 1 - relievoShadowRadius; i < relievoShadowRadius; i += 2)
    {
      vec2 x = vec2(relievoFilterWeight(i, relievoShadowRadius, part.x),
        relievoFilterWeight(i + 1, relievoShadowRadius, part.x));
      vec2 offset = vec2(i, j);
      vec4 four = relievoShadowLit(layer, corner + offset, depth + dot(perTexel, offset), perTexel);
      lit += y.x * dot(x, four.wz) + y.y * dot(x, four.xy);
    }
  }
  float across = float(2 * relievoShadowRadius - 1);
  return lit / (across * across);
#else
  part = relievoShadowRadius == 0 ? floor(part + 0.5) : part;
  vec4 four = relievoShadowLit(layer, corner, depth, perTexel);
  vec2 rows = mix(four.wx, four.zy, part.x);
  return mix(rows.x, rows.y, part.y);
#endif
}

// normalVC: of the receiver's plane, towards the eye; zero if there is no plane. `seen` becomes 1 if
// the point is in the map.
float relievoShadowFace(int face, vec3 positionVC, vec3 normalVC, out float seen)
{
  vec4 map = relievoShadowMatrix[face] * vec4(positionVC, 1.0);
  vec3 place = map.xyz / map.w;
  vec2 off = abs(place.xy - 0.5);
  float inner = 0.5 - float(relievoShadowRadius) / relievoShadowSize;
  seen = map.w > 0.0 && max(off.x, off.y) <= inner && relievoShadowLayer[face] >= 0 ? 1.0 : 0.0;
  float texel = relievoShadowTexel[face] / map.w;
#ifdef RELIEVO_SHADOW_HAS_PLANE
  vec4 plane = relievoShadowPlane[face] * vec4(normalVC, -dot(normalVC, positionVC));
  vec2 slope = relievoReceiverSlope(plane, 64.0 * texel * relievoShadowSize);
  float bias = relievoShadowBias * texel;
#else
  vec2 slope = vec2(0.0);
  float bias = (relievoShadowBias + relievoShadowLift) * texel;
#endif
  place.z = min(place.z, 1.0) - bias;
  return relievoShadowFilter(relievoShadowLayer[face], place, slope);
}

// Dark where the side that is seen is turned away from the light: the surface is in between.
float relievoShadowFacing(int light, vec3 positionVC, vec3 normalVC)
{
#ifdef RELIEVO_SHADOW_HAS_PLANE
  vec4 source = relievoShadowSource[light];
  return dot(normalVC, source.xyz - source.w * positionVC) > 0.0 ? 1.0 : 0.0;
#else
  return 1.0;
#endif
}

// A light with one map.
float relievoShadowOne(int light, int face, vec3 positionVC, vec3 normalVC)
{
  float seen;
  float lit = relievoShadowFace(face, positionVC, normalVC, seen);
  lit = mix(1.0, lit, seen) * relievoShadowFacing(light, positionVC, normalVC);
  return mix(1.0, lit, relievoShadowReceives);
}

// A light with up to six.
float relievoShadowCube(int light, int first, vec3 positionVC, vec3 normalVC)
{
  float lit = 1.0;
  for (int face = first; face < first + 6; ++face)
  {
    float seen;
    float here = relievoShadowFace(face, positionVC, normalVC, seen);
    if (seen > 0.0)
    {
      lit = here;
      break;
    }
  }
  lit *= relievoShadowFacing(light, positionVC, normalVC);
  return mix(1.0, lit, relievoShadowReceives);
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
#if defined(RELIEVO_SHADOW_IMPOSTOR)
  vec3 relievoShadowNormalVC = RELIEVO_IMPOSTOR_NORMAL;
#elif defined(RELIEVO_SHADOW_FACE_NORMAL)
  vec3 relievoShadowNormalVC = cross(relievoShadowDx, relievoShadowDy);
  relievoShadowNormalVC *= (cameraParallel != 0 ? -relievoShadowNormalVC.z
                                                : dot(relievoShadowNormalVC, vertexVC.xyz)) > 0.0
    ? -1.0
    : 1.0;
#else
  vec3 relievoShadowNormalVC = vec3(0.0);
#endif

//RELIEVO::Section(Visibility)
  relievoVisibility[RELIEVO_SLOT] =
    RELIEVO_LOOK_UP(RELIEVO_SLOT, RELIEVO_FACE, vertexVC.xyz, relievoShadowNormalVC);

//RELIEVO::Section(LightImpl)
  relievoShadowedColorRELIEVO_NUMBER = relievoUnshadowedColorRELIEVO_NUMBER() *
    (1.0 - relievoShadowStrength[RELIEVO_SLOT] * (1.0 - relievoVisibility[RELIEVO_SLOT]));
