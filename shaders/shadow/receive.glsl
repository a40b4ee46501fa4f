// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Spliced into VTK's fragment shaders: how much of each casting light reaches the fragment, and the
// light's colour taken down by it wherever VTK's own code reads it.
//
// Defines, by vtkRelievoShadowSplice: RELIEVO_SHADOW_LIGHTS (casting lights), RELIEVO_SHADOW_FACES
// (room for their maps), RELIEVO_SHADOW_NUMBERS (lights of the renderer), RELIEVO_SHADOW_WIDE (the
// filter's radius is above 1), and of the mapper's shader: RELIEVO_SHADOW_TRIANGLES (planes come
// from derivatives), RELIEVO_SHADOW_IMPOSTOR (VTK moved vertexVC to the impostor, normalVCVSOutput
// is exact). What it shares with other splices: splice/contract.glsl.
//
// Between the sections FragmentDec and MapsDec stands the section MethodDec of the method's own
// file, which declares its uniforms and defines
//   float relievoShadowVerdict(int face, vec3 place, vec2 slope, float texel)
// with the arguments of relievoShadowFilter, in an evenly spaced map: 1 lit, 0 dark.

//RELIEVO::Section(Extensions)
#extension GL_ARB_texture_gather : enable

//RELIEVO::Section(FragmentDec)
//RELIEVO::Include(formulas/shadow.glsl)
uniform sampler2DArray relievoShadowMaps;
// Places are taken from a point amid what is seen: far from the eye the large parts of matrix and
// position would cancel each other, and their digits with them.
uniform vec3 relievoShadowCenter; // eye space
#define RELIEVO_SHADOW_POSITION (vertexVC.xyz - relievoShadowCenter)
// From there to map space, less the bias.
uniform mat4 relievoShadowMatrix[RELIEVO_SHADOW_FACES];
uniform float relievoShadowTexel[RELIEVO_SHADOW_FACES]; // depth of a texel's width, at w = 1
uniform vec4 relievoShadowEye[RELIEVO_SHADOW_FACES]; // in map space; w = 0: the direction to it
// -1; 1 if the picture is mirrored. A plane's normal from derivatives in map space points away from
// the light where eye and light see the same side: a picture and a map are not each other's mirror.
uniform float relievoShadowHand;
uniform float relievoShadowLayer[RELIEVO_SHADOW_FACES];
uniform float relievoShadowLowest[RELIEVO_SHADOW_FACES]; // depth of a receiver
uniform float relievoShadowStrength[RELIEVO_SHADOW_LIGHTS];
uniform int relievoShadowSlot[RELIEVO_SHADOW_NUMBERS]; // of light N of the renderer; -1: casts none
uniform float relievoShadowSize;  // of a map, in texels
uniform float relievoShadowInner; // half of it, less the filter; -1 for what receives no shadows
uniform int relievoShadowRadius;  // of the filter, in texels; 0: the nearest texel alone
uniform float relievoShadowLift;  // in texels: of points and lines, which have no plane
#if defined(RELIEVO_SHADOW_IMPOSTOR)
#define RELIEVO_SHADOW_HAS_PLANE true
#elif defined(RELIEVO_SHADOW_TRIANGLES)
uniform int relievoShadowFaces; // whether faces are drawn, not their edges or corners
#define RELIEVO_SHADOW_HAS_PLANE (relievoShadowFaces != 0)
#else
#define RELIEVO_SHADOW_HAS_PLANE false
#endif
float relievoVisibility[RELIEVO_SHADOW_LIGHTS];
#undef RELIEVO_VISIBILITY
#define RELIEVO_VISIBILITY(number) relievoVisibilityOf(number)

float relievoVisibilityOf(int number)
{
  // A layer may be asked of a light that there is not.
  int slot = number < RELIEVO_SHADOW_NUMBERS ? relievoShadowSlot[number] : -1;
  return slot < 0 ? 1.0 : relievoVisibility[slot];
}

// Depths of the texels right and above of a corner texel, as textureGather orders them: (0, 1),
// (1, 1), (1, 0), (0, 0).
vec4 relievoShadowGather(float layer, vec2 corner)
{
#ifdef GL_ARB_texture_gather
  return textureGather(relievoShadowMaps, vec3((corner + 1.0) / relievoShadowSize, layer));
#else
  ivec2 last = ivec2(relievoShadowSize) - 1;
  ivec2 low = clamp(ivec2(corner), ivec2(0), last);
  ivec2 high = clamp(ivec2(corner) + 1, ivec2(0), last);
  int z = int(layer);
  return vec4(texelFetch(relievoShadowMaps, ivec3(low.x, high.y, z), 0).r,
    texelFetch(relievoShadowMaps, ivec3(high, z), 0).r,
    texelFetch(relievoShadowMaps, ivec3(high.x, low.y, z), 0).r,
    texelFetch(relievoShadowMaps, ivec3(low, z), 0).r);
#endif
}

// Which of those texels let light through to a receiver with this depth at the corner texel.
// Nothing is drawn at depth 1, so a receiver there is lit. Casters before the map are drawn at
// depth 0, so where there may be some no bias may bring a receiver there.
vec4 relievoShadowLit(int face, vec2 corner, float depth, vec2 slope)
{
  vec4 receivers = depth + vec4(slope.y, slope.x + slope.y, slope.x, 0.0);
  return step(clamp(receivers, relievoShadowLowest[face], 1.0),
    relievoShadowGather(relievoShadowLayer[face], corner));
}

// What of the light of a map reaches a receiver. place: in the map's texels, and its depth; slope:
// of the receiver's depth per texel; texel: depth of a texel's width there. Branches cost more than
// they save: but for wide filters this is one straight line of code.
float relievoShadowFilter(int face, vec3 place, vec2 slope, float texel)
{
  place.z -= RELIEVO_SHADOW_HAS_PLANE ? 0.0 : relievoShadowLift * texel;
  vec2 corner = floor(place.xy);
  vec2 part = place.xy - corner;
  float depth = place.z - dot(slope, part);
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
      vec4 four = relievoShadowLit(face, corner + offset, depth + dot(slope, offset), slope);
      lit += y.x * dot(x, four.wz) + y.y * dot(x, four.xy);
    }
  }
  float across = float(2 * relievoShadowRadius - 1);
  return lit / (across * across);
#else
  part = relievoShadowRadius == 0 ? floor(part + 0.5) : part;
  vec4 four = relievoShadowLit(face, corner, depth, slope);
  vec2 rows = mix(four.wx, four.zy, part.x);
  return mix(rows.x, rows.y, part.y);
#endif
}

// Whether the map holds the place.
bool relievoShadowSees(vec3 place)
{
  vec2 off = abs(place.xy - (0.5 * relievoShadowSize - 0.5));
  return max(off.x, off.y) <= relievoShadowInner;
}

//RELIEVO::Section(MapsDec)
// What of the light of a map reaches a place of it, as the method finds it. plane: normal of the
// receiver's plane in map space, of any length. Dark unless `facing` is negative: the side that is
// seen is turned away from the light, the surface is in between.
float relievoShadowAt(int face, vec3 place, vec3 plane, float facing, float inverseW)
{
  float texel = relievoShadowTexel[face] * inverseW;
  vec2 slope =
    RELIEVO_SHADOW_HAS_PLANE ? relievoReceiverSlope(plane, 64.0 * texel) : vec2(0.0);
  float lit = relievoShadowVerdict(face, place, slope, texel);
  return facing < 0.0 || !RELIEVO_SHADOW_HAS_PLANE ? lit : 0.0;
}

// A light with one map: of parallel rays, or a lamp's.
float relievoShadowSun(int face, vec3 place, vec3 plane)
{
  float lit = relievoShadowAt(face, place, plane, relievoShadowHand * plane.z, 1.0);
  return relievoShadowSees(place) ? lit : 1.0;
}
float relievoShadowLamp(int face, vec4 map, vec3 plane, float facing)
{
  vec3 place = map.xyz / map.w;
  float lit = relievoShadowAt(face, place, plane, facing, 1.0 / map.w);
  return map.w > 0.0 && relievoShadowSees(place) ? lit : 1.0;
}

// A lamp with up to six.
float relievoShadowCube(int first, vec3 position, vec3 normalVC)
{
  for (int face = first; face < first + 6; ++face)
  {
    vec4 map =
      RELIEVO_RECEIVER(relievoShadowMatrix[face], relievoShadowMatrix[face] * vec4(position, 1.0));
    if (map.w > 0.0 && relievoShadowSees(map.xyz / map.w))
    {
      vec3 plane = relievoMapPlane(relievoShadowMatrix[face], map, normalVC);
      float facing = relievoMapFacing(plane, map.xyz / map.w, relievoShadowEye[face]);
      return relievoShadowAt(face, map.xyz / map.w, plane, facing, 1.0 / map.w);
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
#ifdef RELIEVO_SHADOW_TRIANGLES
  vec3 relievoShadowDx = dFdx(vertexVC.xyz);
  vec3 relievoShadowDy = dFdy(vertexVC.xyz);
#endif

//RELIEVO::Section(SunFlow)
  vec3 relievoShadowPlaceRELIEVO_SLOT =
    (relievoShadowMatrix[RELIEVO_FACE] * vec4(RELIEVO_SHADOW_POSITION, 1.0)).xyz;
  vec3 relievoShadowPlaneRELIEVO_SLOT =
    cross(dFdx(relievoShadowPlaceRELIEVO_SLOT), dFdy(relievoShadowPlaceRELIEVO_SLOT));

//RELIEVO::Section(SunVisibility)
  relievoVisibility[RELIEVO_SLOT] = relievoShadowSun(RELIEVO_FACE,
    RELIEVO_RECEIVER(
      relievoShadowMatrix[RELIEVO_FACE], vec4(relievoShadowPlaceRELIEVO_SLOT, 1.0)).xyz,
    relievoShadowPlaneRELIEVO_SLOT);

//RELIEVO::Section(LampFlow)
  vec4 relievoShadowMapRELIEVO_SLOT =
    relievoShadowMatrix[RELIEVO_FACE] * vec4(RELIEVO_SHADOW_POSITION, 1.0);
  vec3 relievoShadowPlaceRELIEVO_SLOT =
    relievoShadowMapRELIEVO_SLOT.xyz / relievoShadowMapRELIEVO_SLOT.w;
  vec3 relievoShadowPlaneRELIEVO_SLOT =
    cross(dFdx(relievoShadowPlaceRELIEVO_SLOT), dFdy(relievoShadowPlaceRELIEVO_SLOT));

//RELIEVO::Section(LampVisibility)
  relievoVisibility[RELIEVO_SLOT] = relievoShadowLamp(RELIEVO_FACE,
    RELIEVO_RECEIVER(relievoShadowMatrix[RELIEVO_FACE], relievoShadowMapRELIEVO_SLOT),
    relievoShadowPlaneRELIEVO_SLOT, relievoShadowHand * relievoShadowPlaneRELIEVO_SLOT.z);

//RELIEVO::Section(NormalVisibility)
  {
    vec4 map = relievoShadowMatrix[RELIEVO_FACE] * vec4(RELIEVO_SHADOW_POSITION, 1.0);
    vec3 plane = relievoMapPlane(relievoShadowMatrix[RELIEVO_FACE], map, relievoShadowNormalVC);
    relievoVisibility[RELIEVO_SLOT] = relievoShadowLamp(RELIEVO_FACE, map, plane,
      relievoMapFacing(plane, map.xyz / map.w, relievoShadowEye[RELIEVO_FACE]));
  }

//RELIEVO::Section(NoVisibility)
  relievoVisibility[RELIEVO_SLOT] = 1.0;

//RELIEVO::Section(CubeVisibility)
  relievoVisibility[RELIEVO_SLOT] =
    relievoShadowCube(RELIEVO_FACE, RELIEVO_SHADOW_POSITION, relievoShadowNormalVC);

//RELIEVO::Section(FragmentImpl)
#if defined(RELIEVO_SHADOW_IMPOSTOR)
  vec3 relievoShadowNormalVC = RELIEVO_IMPOSTOR_NORMAL;
#elif defined(RELIEVO_SHADOW_TRIANGLES)
  vec3 relievoShadowNormalVC =
    normalize(cross(normalize(relievoShadowDx), normalize(relievoShadowDy)));
#else
  vec3 relievoShadowNormalVC = vec3(0.0, 0.0, 1.0);
#endif

//RELIEVO::Section(LightImpl)
  relievoShadowedColorRELIEVO_NUMBER = relievoUnshadowedColorRELIEVO_NUMBER() *
    (1.0 - relievoShadowStrength[RELIEVO_SLOT] * (1.0 - relievoVisibility[RELIEVO_SLOT]));
