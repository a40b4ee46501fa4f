// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Normal and depth together: RGBA8 (one word), RGBA16F (two words), RGBA32F (four words).
//
// Depth is linear (eye space -z). The background has the zero normal and depth +infinity; a surface
// without a normal has the zero vector and its own depth.
//RELIEVO::Include(formulas/formats/depth.glsl)
//RELIEVO::Include(formulas/formats/normal_formats.glsl)

// The words of the background, the clear values of a buffer of each format.
const uint relievoNormalDepth8None = 0xff000000u;
const uvec2 relievoNormalDepth16FNone = uvec2(0x00000000u, 0x7c000000u);
const uvec4 relievoNormalDepth32FNone = uvec4(0x00000000u, 0x00000000u, 0x00000000u, 0x7f800000u);

// RGBA8: normal as 0.5 n + 0.5 in the lower three bytes, (depth - near) / (far - near) in the
// highest: only 256 steps of depth, the limit of the classic layout.
uint relievoPackNormalDepth8(vec3 n, float depth, float zNear, float zFar)
{
  if (isinf(depth))
  {
    return relievoNormalDepth8None;
  }
  uint rgb = relievoPackNormalUnorm8(n);
  uint alpha = relievoQuantizeUnorm(relievoNormalizedDepth(depth, zNear, zFar), float(255.0));
  // Without a normal the far plane's alpha would mean background.
  if (rgb == uint(0))
  {
    alpha = min(alpha, uint(254));
  }
  return rgb | (alpha << uint(24));
}

// x, y, z: the unit normal; w: depth.
vec4 relievoUnpackNormalDepth8(uint word, float zNear, float zFar)
{
  vec3 n = relievoUnpackNormalUnorm8(word);
  float normalized = relievoDequantizeUnorm(word >> uint(24), float(255.0));
  float depth = word == relievoNormalDepth8None
    ? relievoInfinity()
    : relievoDepthFromNormalized(normalized, zNear, zFar);
  return vec4(n.x, n.y, n.z, depth);
}

// RGBA16F: normal and depth * scale (1: world units; see relievoPackDepth16F).
uvec2 relievoPackNormalDepth16F(vec3 n, float depth, float scale)
{
  uvec2 words = relievoPackNormalHalf(n);
  return uvec2(words.x, words.y | (relievoPackDepth16F(depth, scale) << uint(16)));
}

vec4 relievoUnpackNormalDepth16F(uvec2 words, float scale)
{
  vec3 n = relievoUnpackNormalHalf(words);
  return vec4(n.x, n.y, n.z, relievoUnpackDepth16F(words.y >> uint(16), scale));
}

// RGBA32F: normal and depth in world units, bit for bit.
uvec4 relievoPackNormalDepth32F(vec3 n, float depth)
{
  uvec3 words = relievoPackNormalFloat(n);
  return uvec4(words.x, words.y, words.z, relievoPackDepth32F(depth));
}

vec4 relievoUnpackNormalDepth32F(uvec4 words)
{
  return vec4(uintBitsToFloat(words.x), uintBitsToFloat(words.y), uintBitsToFloat(words.z),
    uintBitsToFloat(words.w));
}
