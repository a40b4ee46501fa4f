// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Spliced into VTK's fragment shaders: packs the requested layers into the words of the G-buffer.
//
// Defines, by vtkRelievoGBufferLayout: RELIEVO_ATTACHMENTS, each of RELIEVO_ATTACHMENT_WORDS,
// RELIEVO_*_WORD, RELIEVO_*_FORMAT; by
// vtkRelievoGBufferSplice, from the mapper's shader: RELIEVO_FACE_NORMAL (the face's normal is
// requested, and VTK computes none), RELIEVO_HAS_NORMAL (normalVCVSOutput),
// RELIEVO_NORMAL_BY_WINDING, RELIEVO_GLYPH_WINDING (winding.glsl is spliced), RELIEVO_GLYPH_DEPTH
// (glyph_depth.glsl is spliced), RELIEVO_SPHERE_POINTS, RELIEVO_TUBE_LINES, RELIEVO_PBR_ALBEDO,
// RELIEVO_BACKFACE_PROPERTY, RELIEVO_PRIMITIVE_SOURCE, RELIEVO_LAYERS_ONLY,
// RELIEVO_LINEAR_VISIBILITY, RELIEVO_COINCIDENT_OFFSET, RELIEVO_LIGHT_LEFT_OUT (lights.glsl).
// Codes: codes.glsl. Defines of other splices: splice/contract.glsl.

//RELIEVO::Section(Extensions)
//RELIEVO::Include(extensions.glsl)
#extension GL_ARB_explicit_attrib_location : require

//RELIEVO::Section(FragmentDec)
//RELIEVO::Include(codes.glsl)
//RELIEVO::Include(formulas/formats/normal_depth.glsl)
//RELIEVO::Include(formulas/formats/octahedral.glsl)
layout(location = 1) out uvec4 relievoOutput1;
#if RELIEVO_ATTACHMENTS > 1
layout(location = 2) out uvec4 relievoOutput2;
#endif
#if RELIEVO_ATTACHMENTS > 2
layout(location = 3) out uvec4 relievoOutput3;
#endif
#if RELIEVO_ATTACHMENTS > 3
layout(location = 4) out uvec4 relievoOutput4;
#endif
#if RELIEVO_ATTACHMENTS > 4
layout(location = 5) out uvec4 relievoOutput5;
#endif
#if RELIEVO_ATTACHMENT_WORDS > 2
#define RELIEVO_ATTACHMENT(n) uvec4(relievoWords[4 * n], relievoWords[4 * n + 1], \
    relievoWords[4 * n + 2], relievoWords[4 * n + 3])
#else
#define RELIEVO_ATTACHMENT(n) uvec4(relievoWords[2 * n], relievoWords[2 * n + 1], uint(0), uint(0))
#endif
uniform int relievoFirstPrimitive; // -1: the words are used up
uniform float relievoWinding; // -1 if actor, view and projection together mirror
uniform int relievoFaces; // whether faces are drawn, not their edges or corners
uniform float relievoNear;
uniform float relievoFar;
#ifdef RELIEVO_SURFACE_WORD
//RELIEVO::Include(formulas/formats/surface.glsl)
uniform int relievoShading; // RELIEVO_SHADING_*
uniform vec4 relievoHighlight[2]; // of both sides: colour times coefficient, exponent
uniform vec2 relievoMetal; // metallic, roughness
#endif

uint relievoPackDepth(float depth, bool parallel, float zNear, float zFar)
{
#if RELIEVO_DEPTH_FORMAT == RELIEVO_DEPTH_16F
  return relievoPackDepth16F(depth, relievoDepth16FScale(zFar));
#elif RELIEVO_DEPTH_FORMAT == RELIEVO_DEPTH_WINDOW_Z24
  return relievoPackWindowZ24(parallel ? relievoParallelWindowZ(depth, zNear, zFar)
                                       : relievoPerspectiveWindowZ(depth, zNear, zFar));
#elif RELIEVO_DEPTH_FORMAT == RELIEVO_DEPTH_REVERSED_32F
  return relievoPackDepth32F(parallel ? relievoParallelReversedZ(depth, zNear, zFar)
                                      : relievoPerspectiveReversedZ(depth, zNear, zFar));
#else
  return relievoPackDepth32F(depth);
#endif
}

// Up to three words, of which the layout stores some.
uvec3 relievoPackNormal(vec3 n)
{
#if RELIEVO_NORMAL_FORMAT == RELIEVO_NORMAL_FLOAT32
  return relievoPackNormalFloat(n);
#elif RELIEVO_NORMAL_FORMAT == RELIEVO_NORMAL_FLOAT16
  return uvec3(relievoPackNormalHalf(n), uint(0));
#elif RELIEVO_NORMAL_FORMAT == RELIEVO_NORMAL_OCT16
  return uvec3(relievoPackNormalOct16(n), uint(0), uint(0));
#elif RELIEVO_NORMAL_FORMAT == RELIEVO_NORMAL_OCT16_PRECISE
  return uvec3(relievoPackNormalOct16Precise(n), uint(0), uint(0));
#elif RELIEVO_NORMAL_FORMAT == RELIEVO_NORMAL_OCT8
  return uvec3(relievoPackNormalOct8(n), uint(0), uint(0));
#elif RELIEVO_NORMAL_FORMAT == RELIEVO_NORMAL_OCT8_PRECISE
  return uvec3(relievoPackNormalOct8Precise(n), uint(0), uint(0));
#elif RELIEVO_NORMAL_FORMAT == RELIEVO_NORMAL_RGB10A2
  return uvec3(relievoPackNormalUnorm10(n), uint(0), uint(0));
#else
  return uvec3(relievoPackNormalUnorm8(n), uint(0), uint(0));
#endif
}
#if RELIEVO_NORMAL_FORMAT == RELIEVO_NORMAL_FLOAT32
#define RELIEVO_STORE_NORMAL(word, packed) \
  relievoWords[word] = packed.x; relievoWords[word + 1] = packed.y; \
  relievoWords[word + 2] = packed.z;
#elif RELIEVO_NORMAL_FORMAT == RELIEVO_NORMAL_FLOAT16
#define RELIEVO_STORE_NORMAL(word, packed) \
  relievoWords[word] = packed.x; relievoWords[word + 1] = packed.y;
#else
#define RELIEVO_STORE_NORMAL(word, packed) relievoWords[word] = packed.x;
#endif

//RELIEVO::Section(UniformFlow)
#ifdef RELIEVO_FACE_NORMAL
  vec3 relievoDx = dFdx(vertexVC.xyz);
  vec3 relievoDy = dFdy(vertexVC.xyz);
#endif

//RELIEVO::Section(FragmentImpl)
  uint relievoWords[RELIEVO_ATTACHMENT_WORDS * RELIEVO_ATTACHMENTS];
  for (int i = 0; i < RELIEVO_ATTACHMENT_WORDS * RELIEVO_ATTACHMENTS; ++i)
  {
    relievoWords[i] = uint(0);
  }

  float relievoDepth = -RELIEVO_SURFACE_VC.z;
#ifdef RELIEVO_GLYPH_DEPTH
  relievoDepth = clamp(relievoDepth, relievoGlyphDepthsVSOutput.x, relievoGlyphDepthsVSOutput.y);
#endif
  // Points as spheres and lines as tubes lie in front of their primitive by a share of the radius,
  // which VTK gives in eye space at unit depth.
#if defined(RELIEVO_SPHERE_POINTS) || defined(RELIEVO_TUBE_LINES)
#ifdef RELIEVO_SPHERE_POINTS
  float relievoLift = normalVCVSOutput.z * ZCalcR;
#else
  float relievoLift = lenZ * ZCalcR / clamp(tubeBasis2.z, 0.5, 1.0);
#endif
  relievoDepth = cameraParallel != 0 ? relievoDepth - relievoLift
                                     : relievoDepth * (1.0 - relievoLift);
#endif

#if defined(RELIEVO_NORMAL_WORD) || defined(RELIEVO_GEOMETRIC_NORMAL_WORD) || \
  defined(RELIEVO_NORMAL_DEPTH_WORD)
  vec3 relievoFaceVC = vec3(0.0);
#ifdef RELIEVO_FACE_NORMAL
  relievoFaceVC = normalize(cross(normalize(relievoDx), normalize(relievoDy)));
  float relievoFacing = cameraParallel != 0 ? -relievoFaceVC.z : dot(relievoFaceVC, vertexVC.xyz);
  if (relievoFacing > 0.0)
  {
    relievoFaceVC = -relievoFaceVC;
  }
  if (relievoFaces == 0)
  {
    relievoFaceVC = vec3(0.0);
  }
#endif
  vec3 relievoNormalVC = relievoFaceVC;
#ifdef RELIEVO_HAS_NORMAL
  relievoNormalVC = normalVCVSOutput;
#ifdef RELIEVO_NORMAL_BY_WINDING
  // VTK orients these by the winding, which a mirroring matrix inverts.
  relievoNormalVC *= relievoWinding;
#ifdef RELIEVO_GLYPH_WINDING
  relievoNormalVC *= relievoGlyphWindingVSOutput;
#endif
#endif
#ifdef RELIEVO_FACE_NORMAL
  if (relievoFaces == 0)
#endif
  {
    relievoFaceVC = relievoNormalVC;
  }
#endif
#endif

#ifdef RELIEVO_NORMAL_DEPTH_WORD
#if RELIEVO_NORMAL_DEPTH_FORMAT == RELIEVO_NORMAL_DEPTH_RGBA8
  relievoWords[RELIEVO_NORMAL_DEPTH_WORD] =
    relievoPackNormalDepth8(relievoNormalVC, relievoDepth, relievoNear, relievoFar);
#elif RELIEVO_NORMAL_DEPTH_FORMAT == RELIEVO_NORMAL_DEPTH_RGBA16F
  uvec2 relievoHalves = relievoPackNormalDepth16F(
    relievoNormalVC, relievoDepth, relievoDepth16FScale(relievoFar));
  relievoWords[RELIEVO_NORMAL_DEPTH_WORD] = relievoHalves.x;
  relievoWords[RELIEVO_NORMAL_DEPTH_WORD + 1] = relievoHalves.y;
#else
  uvec4 relievoFloats = relievoPackNormalDepth32F(relievoNormalVC, relievoDepth);
  relievoWords[RELIEVO_NORMAL_DEPTH_WORD] = relievoFloats.x;
  relievoWords[RELIEVO_NORMAL_DEPTH_WORD + 1] = relievoFloats.y;
  relievoWords[RELIEVO_NORMAL_DEPTH_WORD + 2] = relievoFloats.z;
  relievoWords[RELIEVO_NORMAL_DEPTH_WORD + 3] = relievoFloats.w;
#endif
#endif

#ifdef RELIEVO_DEPTH_WORD
  relievoWords[RELIEVO_DEPTH_WORD] =
    relievoPackDepth(relievoDepth, cameraParallel != 0, relievoNear, relievoFar);
#endif

#ifdef RELIEVO_ID_WORD
  relievoWords[RELIEVO_ID_WORD] = uint(relievoFirstPrimitive);
#if RELIEVO_PRIMITIVE_SOURCE == RELIEVO_PRIMITIVE_OF_MESH || \
  RELIEVO_PRIMITIVE_SOURCE == RELIEVO_PRIMITIVE_OF_POINTS
  relievoWords[RELIEVO_ID_WORD] +=
    relievoFirstPrimitive == -1 ? uint(0) : uint(gl_PrimitiveID + PrimitiveIDOffset);
#elif RELIEVO_PRIMITIVE_SOURCE == RELIEVO_PRIMITIVE_OF_GLYPHS
  relievoWords[RELIEVO_ID_WORD] +=
    relievoFirstPrimitive == -1 ? uint(0) : uint(relievoInstanceVSOutput);
#endif
#endif

#ifdef RELIEVO_PLACE_WORD
  relievoWords[RELIEVO_PLACE_WORD] = floatBitsToUint(RELIEVO_SURFACE_VC.x);
  relievoWords[RELIEVO_PLACE_WORD + 1] = floatBitsToUint(RELIEVO_SURFACE_VC.y);
#endif

#ifdef RELIEVO_NORMAL_WORD
  uvec3 relievoNormalWords = relievoPackNormal(relievoNormalVC);
  RELIEVO_STORE_NORMAL(RELIEVO_NORMAL_WORD, relievoNormalWords)
#endif
#ifdef RELIEVO_GEOMETRIC_NORMAL_WORD
  uvec3 relievoFaceWords = relievoPackNormal(relievoFaceVC);
  RELIEVO_STORE_NORMAL(RELIEVO_GEOMETRIC_NORMAL_WORD, relievoFaceWords)
#endif

#if defined(RELIEVO_ALBEDO_WORD) || defined(RELIEVO_SURFACE_WORD)
#ifdef RELIEVO_PBR_ALBEDO
  vec4 relievoAlbedo = vec4(albedo, opacity);
#else
  float relievoDiffuse = diffuseIntensity;
  float relievoAmbient = ambientIntensity;
#ifdef RELIEVO_BACKFACE_PROPERTY
  if (gl_FrontFacing == false)
  {
    relievoDiffuse = diffuseIntensityBF;
    relievoAmbient = ambientIntensityBF;
  }
#endif
  vec4 relievoAlbedo = vec4(0.0, 0.0, 0.0, opacity);
  if (relievoDiffuse > 0.0)
  {
    relievoAlbedo.rgb = diffuseColor / relievoDiffuse;
  }
  else if (relievoAmbient > 0.0)
  {
    relievoAlbedo.rgb = ambientColor / relievoAmbient;
  }
#endif
  // Repeats VTK's texture code on the unlit colour, which then has the name of the code's output.
  {
#define fragOutput0 relievoAlbedo
    //RELIEVO::Texture::Copy
#undef fragOutput0
  }
#endif
#ifdef RELIEVO_ALBEDO_WORD
  relievoAlbedo.a = RELIEVO_ALPHA(relievoAlbedo.a);
  relievoWords[RELIEVO_ALBEDO_WORD] = packUnorm4x8(relievoAlbedo);
#endif

#if defined(RELIEVO_SURFACE_DETAIL_WORD) || defined(RELIEVO_SURFACE_SPECULAR_WORD)
#ifdef RELIEVO_BACKFACE_PROPERTY
  vec4 relievoGloss = relievoHighlight[gl_FrontFacing ? 0 : 1];
#else
  vec4 relievoGloss = relievoHighlight[0];
#endif
  float relievoPower = relievoGloss.a / relievoMostSpecularPower;
#endif
#ifdef RELIEVO_SURFACE_SPECULAR_WORD
  vec4 relievoSpecular = vec4(relievoGloss.rgb, 1.0);
#ifndef RELIEVO_PBR_ALBEDO
  {
#define fragOutput0 relievoSpecular
    //RELIEVO::Texture::Copy
#undef fragOutput0
  }
#endif
#endif

#ifdef RELIEVO_SURFACE_WORD
#ifdef RELIEVO_LIGHT_LEFT_OUT
  int relievoKind = relievoShading + 4;
#else
  int relievoKind = relievoShading;
#endif
  vec3 relievoStored = relievoShading == RELIEVO_SHADING_PBR
    ? sqrt(max(relievoAlbedo.rgb, vec3(0.0)))
    : relievoAlbedo.rgb;
  relievoWords[RELIEVO_SURFACE_WORD] = relievoPackSurfaceColor(relievoStored, uint(relievoKind));
#ifdef RELIEVO_SURFACE_DETAIL_WORD
#ifdef RELIEVO_PBR_ALBEDO
  relievoWords[RELIEVO_SURFACE_DETAIL_WORD] = relievoPackUnorm16(vec2(metallic, roughness));
#else
  relievoWords[RELIEVO_SURFACE_DETAIL_WORD] = relievoPackUnorm16(
    relievoShading == RELIEVO_SHADING_PBR ? relievoMetal : vec2(relievoDiffuse, relievoPower));
#endif
#endif
#ifdef RELIEVO_SURFACE_SPECULAR_WORD
  relievoWords[RELIEVO_SURFACE_SPECULAR_WORD] =
    relievoPackSurfaceColor(relievoSpecular.rgb, uint(0));
#endif
#endif

#ifdef RELIEVO_DIRECT_LIGHT_WORD
  relievoWords[RELIEVO_DIRECT_LIGHT_WORD] = packUnorm4x8(vec4(RELIEVO_DIRECT_LIGHT, 0.0));
#endif
#ifdef RELIEVO_SHADOW_WORD
  //RELIEVO::Shadow::Words
#endif

  relievoOutput1 = RELIEVO_ATTACHMENT(0);
#if RELIEVO_ATTACHMENTS > 1
  relievoOutput2 = RELIEVO_ATTACHMENT(1);
#endif
#if RELIEVO_ATTACHMENTS > 2
  relievoOutput3 = RELIEVO_ATTACHMENT(2);
#endif
#if RELIEVO_ATTACHMENTS > 3
  relievoOutput4 = RELIEVO_ATTACHMENT(3);
#endif
#if RELIEVO_ATTACHMENTS > 4
  relievoOutput5 = RELIEVO_ATTACHMENT(4);
#endif
#ifdef RELIEVO_LINEAR_VISIBILITY
  // Window z cannot order far fragments if far / near is large; a float of the depth itself keeps
  // its relative precision everywhere.
#ifdef RELIEVO_COINCIDENT_OFFSET
  // VTK separates coincident surfaces in window z; here by the same share of the depth.
  gl_FragDepth = (relievoDepth / relievoFar) * (1.0 + gl_FragDepth - gl_FragCoord.z);
#else
  gl_FragDepth = relievoDepth / relievoFar;
#endif
#endif
#ifdef RELIEVO_LAYERS_ONLY
  // The colour is unused, so its light and reflections are not computed.
  gl_FragData[0] = vec4(0.0, 0.0, 0.0, gl_FragData[0].a);
#endif

//RELIEVO::Section(ShadowWord)
  relievoWords[RELIEVO_SHADOW_WORD + RELIEVO_OFFSET] =
    packUnorm2x16(vec2(RELIEVO_VISIBILITY(RELIEVO_FIRST), RELIEVO_VISIBILITY(RELIEVO_SECOND)));
