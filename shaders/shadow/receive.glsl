// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Spliced into VTK's fragment shaders: computes the share of each casting light that reaches the
// fragment, and multiplies the light's colour by it wherever VTK's own code reads it.
//
// Defines, by vtkRelievoShadowSplice: RELIEVO_SHADOW_LIGHTS (casting lights), RELIEVO_SHADOW_FACES
// (number of their maps), RELIEVO_SHADOW_NUMBERS (lights of the renderer), RELIEVO_SHADOW_WIDE (the
// filter's radius is above 1), RELIEVO_SHADOW_PARTS (of each soft sun), RELIEVO_SHADOW_COLORED
// (surfaces colour the transmitted light), RELIEVO_VOLUME_TINTED (volumes do), and by the mapper's
// shader: RELIEVO_SHADOW_TRIANGLES
// (planes come from derivatives), RELIEVO_SHADOW_IMPOSTOR (VTK moved vertexVC to the impostor,
// normalVCVSOutput is exact), RELIEVO_SHADOW_LINEAR_LIGHT (of PBR surfaces). Names shared with
// other splices: splice/contract.glsl.
//
// On shadow catchers VTK's light code appears three times, before the section CaughtImpl and twice
// in it: with shadows, without casting lights, and without shadows. All light a white surface; the
// catcher's colour is VTK's ambientColor, or that of its array.
//
// The section MethodDec of the method's own file is inserted between the sections FragmentDec and
// MapsDec. It declares the method's uniforms and defines
//   float relievoShadowVerdict(int face, vec3 place, vec2 slope, float texel)
// with the arguments of relievoShadowFilter, in an even map: 1 lit, 0 dark.

//RELIEVO::Section(Extensions)
#extension GL_ARB_texture_gather : enable

//RELIEVO::Section(FragmentDec)
//RELIEVO::Include(formulas/light/shadow.glsl)
// Places are relative to a point near the visible surfaces: far from the eye, the large parts of
// matrix and position would otherwise cancel, and lose digits.
uniform vec3 relievoShadowCenter; // eye space
#define RELIEVO_SHADOW_POSITION (vertexVC.xyz - relievoShadowCenter)
// -1; 1 if the picture is mirrored. A plane's normal from derivatives in map space points away from
// the light if eye and light see the same side, because a picture and a map have opposite
// handedness.
uniform float relievoShadowHand;
// A catcher's colour follows the background's gradient: by this share of it from the bottom to the
// top. The height in the picture, from the rows of the projection that give y and w.
uniform vec3 relievoCatcherRise;
uniform vec4 relievoCatcherHeight[2];
uniform float relievoShadowStrength[RELIEVO_SHADOW_LIGHTS];
uniform int relievoShadowSlot[RELIEVO_SHADOW_NUMBERS]; // of light N of the renderer; -1: casts none
#if defined(RELIEVO_SHADOW_IMPOSTOR)
#define RELIEVO_SHADOW_HAS_PLANE true
#elif defined(RELIEVO_SHADOW_TRIANGLES)
uniform int relievoShadowFaces; // whether faces are drawn, not their edges or corners
#define RELIEVO_SHADOW_HAS_PLANE (relievoShadowFaces != 0)
#else
#define RELIEVO_SHADOW_HAS_PLANE false
#endif
//RELIEVO::Include(shadow/lookup.glsl)
float relievoVisibility[RELIEVO_SHADOW_LIGHTS];
#if defined(RELIEVO_SHADOW_COLORED) || defined(RELIEVO_VOLUME_TINTED)
vec3 relievoShadowColors[RELIEVO_SHADOW_LIGHTS]; // per colour channel
#define RELIEVO_SHADOW_LEFT(slot) relievoShadowColors[slot]
#else
#define RELIEVO_SHADOW_LEFT(slot) relievoVisibility[slot]
#endif
#undef RELIEVO_VISIBILITY
#define RELIEVO_VISIBILITY(number) relievoVisibilityOf(number)

float relievoVisibilityOf(int number)
{
  // A layer may be requested for a light that does not exist.
  int slot = number < RELIEVO_SHADOW_NUMBERS ? relievoShadowSlot[number] : -1;
  return slot < 0 ? 1.0 : relievoVisibility[slot];
}

// A catcher's array: the displayed colour of each point where all light reaches it, and the share
// of the sky that is hidden from it. Other catchers have VTK's colour.
//RELIEVO::Section(CatcherVertexDec)
in vec4 relievoCatcher;
out vec4 relievoCatcherVSOutput;
//RELIEVO::Section(CatcherVertexImpl)
  relievoCatcherVSOutput = relievoCatcher;
//RELIEVO::Section(CatcherDec)
in vec4 relievoCatcherVSOutput;
#define RELIEVO_CATCHER relievoCatcherVSOutput
//RELIEVO::Section(PlainCatcherDec)
#define RELIEVO_CATCHER vec4(ambientColor, 0.0)

// Left out where highlights have no strength: their powers are a tenth of the shader's work.
//RELIEVO::Section(SpecularOfVTK)
specularColor = specularIntensity * specularColorUniform;
//RELIEVO::Section(HighlightOfVTK)
sf = sign(df)*
//RELIEVO::Section(NoHighlight)
sf = 0.0

//RELIEVO::Section(BulgeOfVTK)
uniform float ZCalcR;
//RELIEVO::Section(BulgeDec)
uniform int relievoFromLight; // 1 while a light's map is drawn
// Points as spheres and lines as tubes are moved in front of their primitive by a share of the
// radius, which VTK gives in pixels of the picture: in a map, that offset would make them shadow
// themselves.
#define ZCalcR (relievoFromLight > 0 ? 0.0 : ZCalcR)

//RELIEVO::Section(MapsDec)
//RELIEVO::Include(shadow/reach.glsl)

// A light with one map: with parallel rays, or a lamp.
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

#ifdef RELIEVO_SHADOW_PARTS
//RELIEVO::Include(shadow/soft.glsl)
#endif

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

//RELIEVO::Section(SoftVisibility)
  relievoVisibility[RELIEVO_SLOT] = relievoShadowPart(RELIEVO_SLOT, RELIEVO_FACE,
    RELIEVO_SHADOW_POSITION, relievoShadowNormalVC);

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

// Volumes dim the light that the maps and rays of surfaces let pass.
//RELIEVO::Section(ShadeDec)
//RELIEVO::Include(volumes/shade.glsl)

//RELIEVO::Section(ShadeImpl)
#if defined(RELIEVO_VOLUME_TINTED) && !defined(RELIEVO_SHADOW_COLORED)
  relievoShadowColors[RELIEVO_SLOT] = vec3(relievoVisibility[RELIEVO_SLOT]);
#endif
  if (relievoShadowInner >= 0.0)
  {
    RELIEVO_VOLUME_SHARE passes = relievoVolumePasses(RELIEVO_SLOT, RELIEVO_SHADOW_POSITION);
    relievoVisibility[RELIEVO_SLOT] *= RELIEVO_VOLUME_WHOLE(passes);
#if defined(RELIEVO_SHADOW_COLORED) || defined(RELIEVO_VOLUME_TINTED)
    relievoShadowColors[RELIEVO_SLOT] *= RELIEVO_VOLUME_COLORS(passes);
#endif
  }

//RELIEVO::Section(FragmentImpl)
#if defined(RELIEVO_SHADOW_IMPOSTOR)
  vec3 relievoShadowNormalVC = RELIEVO_IMPOSTOR_NORMAL;
#elif defined(RELIEVO_SHADOW_TRIANGLES)
  vec3 relievoShadowNormalVC =
    normalize(cross(normalize(relievoShadowDx), normalize(relievoShadowDy)));
#else
  vec3 relievoShadowNormalVC = vec3(0.0, 0.0, 1.0);
#endif

//RELIEVO::Section(CatchImpl)
  float relievoCatcherUp = 0.5 +
    0.5 * dot(relievoCatcherHeight[0], vertexVC) / dot(relievoCatcherHeight[1], vertexVC);
  vec4 relievoCatches = RELIEVO_CATCHER;
  vec3 relievoCatcherColor =
    relievoCatches.rgb * (1.0 + clamp(relievoCatcherUp, 0.0, 1.0) * relievoCatcherRise);
  ambientColor = vec3(0.0);
  diffuseColor = vec3(1.0);

//RELIEVO::Section(UnshadowedImpl)
#undef lightColorRELIEVO_NUMBER

//RELIEVO::Section(CaughtImpl)
  vec3 relievoReaches = gl_FragData[0].rgb;
  {
RELIEVO_OTHER_LIGHT_OF_VTK
  }
  vec3 relievoOthers = gl_FragData[0].rgb;
  {
RELIEVO_LIGHT_OF_VTK
  }
  ambientColor = relievoCatcherColor;
  diffuseColor = vec3(0.0);
  for (int i = 0; i < 3; ++i)
  {
    float all = gl_FragData[0][i];
    float share = relievoCatcherShare(relievoReaches[i], all);
    float direct = max(share - relievoCatcherShare(relievoOthers[i], all), 0.0);
    // In linear light the hidden part of the sky is missing from all light but the casting lights'.
    float whole = pow(share, 2.2);
    float left = max(whole - relievoCatches.a * (whole - pow(direct, 2.2)), 0.0);
    relievoDirectLight[i] = min(pow(direct, 2.2) / max(left, 1e-6), 1.0);
    gl_FragData[0][i] = ambientColor[i] * pow(left, 1.0 / 2.2);
  }

//RELIEVO::Section(DirectDec)
vec3 relievoDirectLight;
#undef RELIEVO_DIRECT_LIGHT
#define RELIEVO_DIRECT_LIGHT relievoDirectLight

// VTK adds up the light of PBR surfaces in linear colours, and other light in displayed ones.
vec3 relievoLightSum(vec3 shown)
{
#ifdef RELIEVO_SHADOW_LINEAR_LIGHT
  return pow(max(shown, vec3(0.0)), vec3(2.2));
#else
  return shown;
#endif
}

//RELIEVO::Section(NoLightImpl)
  relievoShadowedColorRELIEVO_NUMBER = vec3(0.0);

//RELIEVO::Section(OthersImpl)
  vec4 relievoLit = gl_FragData[0];
  {
RELIEVO_LIGHT_OF_VTK
  }
  relievoDirectLight = relievoLightSum(relievoLit.rgb) - relievoLightSum(gl_FragData[0].rgb);
  gl_FragData[0] = relievoLit;

//RELIEVO::Section(DirectImpl)
  relievoDirectLight /= max(relievoLightSum(gl_FragData[0].rgb), vec3(1e-6));
  relievoDirectLight = clamp(relievoDirectLight, vec3(0.0), vec3(1.0));
#ifndef RELIEVO_SHADOW_LINEAR_LIGHT
  relievoDirectLight = pow(relievoDirectLight, vec3(2.2));
#endif

//RELIEVO::Section(LightImpl)
  relievoShadowedColorRELIEVO_NUMBER = relievoUnshadowedColorRELIEVO_NUMBER() *
    (1.0 - relievoShadowStrength[RELIEVO_SLOT] * (1.0 - RELIEVO_SHADOW_LEFT(RELIEVO_SLOT)));
