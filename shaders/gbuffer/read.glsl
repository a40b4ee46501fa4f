// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads the layers back from the words of the G-buffer; pixel (0, 0) is the viewport's lower left
// one. Defines by vtkRelievoGBufferLayout, with codes of codes.glsl.
//RELIEVO::Include(codes.glsl)
//RELIEVO::Include(formulas/formats/normal_depth.glsl)
//RELIEVO::Include(formulas/formats/octahedral.glsl)
//RELIEVO::Include(formulas/formats/surface.glsl)
uniform usampler2D relievoWords1;
#if RELIEVO_ATTACHMENTS > 1
uniform usampler2D relievoWords2;
#endif
#if RELIEVO_ATTACHMENTS > 2
uniform usampler2D relievoWords3;
#endif
#if RELIEVO_ATTACHMENTS > 3
uniform usampler2D relievoWords4;
#endif
#if RELIEVO_ATTACHMENTS > 4
uniform usampler2D relievoWords5;
#endif
uniform ivec2 relievoOffset; // of the viewport in the words' textures
uniform float relievoNear;
uniform float relievoFar;
uniform int relievoParallel;

uint relievoFetchWord(ivec2 pixel, int word)
{
  ivec2 texel = pixel + relievoOffset;
  int attachment = word / RELIEVO_ATTACHMENT_WORDS;
  uvec4 words = uvec4(uint(0));
  if (attachment == 0)
  {
    words = texelFetch(relievoWords1, texel, 0);
  }
#if RELIEVO_ATTACHMENTS > 1
  else if (attachment == 1)
  {
    words = texelFetch(relievoWords2, texel, 0);
  }
#endif
#if RELIEVO_ATTACHMENTS > 2
  else if (attachment == 2)
  {
    words = texelFetch(relievoWords3, texel, 0);
  }
#endif
#if RELIEVO_ATTACHMENTS > 3
  else if (attachment == 3)
  {
    words = texelFetch(relievoWords4, texel, 0);
  }
#endif
#if RELIEVO_ATTACHMENTS > 4
  else
  {
    words = texelFetch(relievoWords5, texel, 0);
  }
#endif
  int channel = word % RELIEVO_ATTACHMENT_WORDS;
  return channel == 0 ? words.x : channel == 1 ? words.y : channel == 2 ? words.z : words.w;
}

vec3 relievoFetchNormalAt(ivec2 pixel, int word)
{
#if RELIEVO_NORMAL_FORMAT == RELIEVO_NORMAL_FLOAT32
  return relievoUnpackNormalFloat(uvec3(relievoFetchWord(pixel, word),
    relievoFetchWord(pixel, word + 1), relievoFetchWord(pixel, word + 2)));
#elif RELIEVO_NORMAL_FORMAT == RELIEVO_NORMAL_FLOAT16
  return relievoUnpackNormalHalf(
    uvec2(relievoFetchWord(pixel, word), relievoFetchWord(pixel, word + 1)));
#elif RELIEVO_NORMAL_FORMAT == RELIEVO_NORMAL_OCT16 || \
  RELIEVO_NORMAL_FORMAT == RELIEVO_NORMAL_OCT16_PRECISE
  return relievoUnpackNormalOct16(relievoFetchWord(pixel, word));
#elif RELIEVO_NORMAL_FORMAT == RELIEVO_NORMAL_OCT8 || \
  RELIEVO_NORMAL_FORMAT == RELIEVO_NORMAL_OCT8_PRECISE
  return relievoUnpackNormalOct8(relievoFetchWord(pixel, word));
#elif RELIEVO_NORMAL_FORMAT == RELIEVO_NORMAL_RGB10A2
  return relievoUnpackNormalUnorm10(relievoFetchWord(pixel, word));
#else
  return relievoUnpackNormalUnorm8(relievoFetchWord(pixel, word));
#endif
}

#ifdef RELIEVO_NORMAL_DEPTH_WORD
vec4 relievoFetchNormalDepth(ivec2 pixel)
{
  int word = RELIEVO_NORMAL_DEPTH_WORD;
#if RELIEVO_NORMAL_DEPTH_FORMAT == RELIEVO_NORMAL_DEPTH_RGBA8
  return relievoUnpackNormalDepth8(relievoFetchWord(pixel, word), relievoNear, relievoFar);
#elif RELIEVO_NORMAL_DEPTH_FORMAT == RELIEVO_NORMAL_DEPTH_RGBA16F
  return relievoUnpackNormalDepth16F(
    uvec2(relievoFetchWord(pixel, word), relievoFetchWord(pixel, word + 1)),
    relievoDepth16FScale(relievoFar));
#else
  return relievoUnpackNormalDepth32F(
    uvec4(relievoFetchWord(pixel, word), relievoFetchWord(pixel, word + 1),
      relievoFetchWord(pixel, word + 2), relievoFetchWord(pixel, word + 3)));
#endif
}
#endif

#if defined(RELIEVO_DEPTH_WORD) || defined(RELIEVO_NORMAL_DEPTH_WORD)
// World units; +infinity in the background.
float relievoFetchDepth(ivec2 pixel)
{
#ifdef RELIEVO_NORMAL_DEPTH_WORD
  return relievoFetchNormalDepth(pixel).w;
#else
  uint word = relievoFetchWord(pixel, RELIEVO_DEPTH_WORD);
#if RELIEVO_DEPTH_FORMAT == RELIEVO_DEPTH_16F
  return relievoUnpackDepth16F(word, relievoDepth16FScale(relievoFar));
#elif RELIEVO_DEPTH_FORMAT == RELIEVO_DEPTH_WINDOW_Z24
  float z = relievoUnpackWindowZ24(word);
  return relievoParallel != 0 ? relievoParallelDepth(z, relievoNear, relievoFar)
                              : relievoPerspectiveDepth(z, relievoNear, relievoFar);
#elif RELIEVO_DEPTH_FORMAT == RELIEVO_DEPTH_REVERSED_32F
  float z = relievoUnpackDepth32F(word);
  return isinf(z) ? -z
    : relievoParallel != 0 ? relievoParallelDepthFromReversed(z, relievoNear, relievoFar)
                           : relievoPerspectiveDepthFromReversed(z, relievoNear, relievoFar);
#else
  return relievoUnpackDepth32F(word);
#endif
#endif
}
#endif

#if defined(RELIEVO_NORMAL_WORD) || defined(RELIEVO_NORMAL_DEPTH_WORD)
// Eye space, unit; the zero vector without a normal.
vec3 relievoFetchNormal(ivec2 pixel)
{
#ifdef RELIEVO_NORMAL_WORD
  return relievoFetchNormalAt(pixel, RELIEVO_NORMAL_WORD);
#else
  return relievoFetchNormalDepth(pixel).xyz;
#endif
}
#endif

#ifdef RELIEVO_GEOMETRIC_NORMAL_WORD
// The triangle's normal: eye space, unit, or the zero vector.
vec3 relievoFetchGeometricNormal(ivec2 pixel)
{
  return relievoFetchNormalAt(pixel, RELIEVO_GEOMETRIC_NORMAL_WORD);
}
#endif

#ifdef RELIEVO_ALBEDO_WORD
// The albedo in VTK's display values, with the opacity; 0 in the background.
vec4 relievoFetchAlbedo(ivec2 pixel)
{
  return unpackUnorm4x8(relievoFetchWord(pixel, RELIEVO_ALBEDO_WORD));
}
#endif

#ifdef RELIEVO_SURFACE_WORD
// A surface's lighting properties. Colours are VTK's display values; those of PBR are linear.
struct relievoSurface
{
  int shading;      // RELIEVO_SHADING_*
  bool deferred;    // whether VTK has left its lights out
  vec3 color;       // without light
  float diffuse;    // Phong: diffuse coefficient
  float power;      // Phong: exponent of the highlight
  vec3 specular;    // Phong: colour of the highlight times its coefficient
  float metallic;   // PBR
  float roughness;  // PBR
};

const relievoSurface relievoNoSurface =
  relievoSurface(RELIEVO_SHADING_NONE, false, vec3(0.0), 1.0, 1.0, vec3(0.0), 0.0, 0.5);

relievoSurface relievoFetchSurface(ivec2 pixel)
{
  uint word = relievoFetchWord(pixel, RELIEVO_SURFACE_WORD);
  int kind = int(relievoUnpackSurfaceKind(word));
  relievoSurface surface = relievoNoSurface;
  surface.shading = kind & 3;
  surface.deferred = kind > 3;
  surface.color = relievoUnpackSurfaceColor(word);
  if (surface.shading == RELIEVO_SHADING_PBR)
  {
    surface.color *= surface.color;
  }
#ifdef RELIEVO_SURFACE_DETAIL_WORD
  vec2 detail = relievoUnpackUnorm16(relievoFetchWord(pixel, RELIEVO_SURFACE_DETAIL_WORD));
  if (surface.shading == RELIEVO_SHADING_PBR)
  {
    surface.metallic = detail.x;
    surface.roughness = detail.y;
  }
  else
  {
    surface.diffuse = detail.x;
    surface.power = detail.y * relievoMostSpecularPower;
  }
#endif
#ifdef RELIEVO_SURFACE_SPECULAR_WORD
  surface.specular =
    relievoUnpackSurfaceColor(relievoFetchWord(pixel, RELIEVO_SURFACE_SPECULAR_WORD));
#endif
  return surface;
}
#endif

#ifdef RELIEVO_DIRECT_LIGHT_WORD
// The share of casting lights in the light of each linear colour channel.
vec3 relievoFetchDirectLight(ivec2 pixel)
{
  return unpackUnorm4x8(relievoFetchWord(pixel, RELIEVO_DIRECT_LIGHT_WORD)).rgb;
}
#endif

#ifdef RELIEVO_SHADOW_WORD
// The unshadowed share of the light with this index among the stored ones: 1 lit, 0 dark.
float relievoFetchVisibility(ivec2 pixel, int place)
{
  vec2 two = unpackUnorm2x16(relievoFetchWord(pixel, RELIEVO_SHADOW_WORD + place / 2));
  return place % 2 == 0 ? two.x : two.y;
}
#endif

#ifdef RELIEVO_ID_WORD
uniform samplerBuffer relievoParts; // sorted: the first word in halves, the part, or -1
uniform int relievoNumberOfParts;

// The number of the pixel's part, an actor's block or a glyph; 0 in the background.
uint relievoFetchPart(ivec2 pixel)
{
  uint word = relievoFetchWord(pixel, RELIEVO_ID_WORD);
  if (word == ~uint(0))
  {
    return uint(0);
  }
  int low = 0;
  int high = relievoNumberOfParts;
  while (high - low > 1)
  {
    int middle = (low + high) / 2;
    vec4 start = texelFetch(relievoParts, middle);
    uint first = uint(start.x) * uint(65536) + uint(start.y);
    low = first <= word ? middle : low;
    high = first <= word ? high : middle;
  }
  float part = texelFetch(relievoParts, low).z;
  // Words of glyphs do not use the highest bit.
  return part < 0.0 ? word | (uint(1) << 31) : uint(part) + uint(1);
}
#endif
