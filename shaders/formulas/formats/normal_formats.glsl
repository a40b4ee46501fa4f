// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Unit vectors by three components: 3 x 8 bits, 3 x 10 bits (RGB10A2), half and float.
//
// Words 0 mean "no direction" in every format: zero, infinite or NaN vectors encode to them, and
// they decode to the zero vector. No unit vector has the codes (0, 0, 0): all components would be
// -1.
//RELIEVO::Include(formulas/formats/octahedral.glsl)

// A component in [-1, 1] as 0.5 n + 0.5 in steps of 1 / maxCode.
uint relievoQuantizeBiased(float component, float maxCode)
{
  return relievoQuantizeUnorm(float(0.5) * component + float(0.5), maxCode);
}

// The three components as 0.5 n + 0.5 in `bits` bits each, x lowest.
uint relievoPackNormalBiased(vec3 n, int bits)
{
  if (!relievoIsDirection(n))
  {
    return uint(0);
  }
  float maxCode = float((uint(1) << uint(bits)) - uint(1));
  return relievoQuantizeBiased(n.x, maxCode) | (relievoQuantizeBiased(n.y, maxCode) << uint(bits)) |
    (relievoQuantizeBiased(n.z, maxCode) << uint(2 * bits));
}

// The unit vector of a word of relievoPackNormalBiased; higher bits are ignored.
vec3 relievoUnpackNormalBiased(uint word, int bits)
{
  uint mask = (uint(1) << uint(bits)) - uint(1);
  uint x = word & mask;
  uint y = (word >> uint(bits)) & mask;
  uint z = (word >> uint(2 * bits)) & mask;
  if ((x | y | z) == uint(0))
  {
    return vec3(float(0.0), float(0.0), float(0.0));
  }
  // 2 x / maxCode - 1, times maxCode: normalising removes the factor, and integers are exact.
  float maxCode = float(mask);
  return normalize(vec3(float(2.0) * float(x) - maxCode, float(2.0) * float(y) - maxCode,
    float(2.0) * float(z) - maxCode));
}

// RGB8: unit vector n in the lower 24 bits, x in the lowest byte (the order of packUnorm4x8).
uint relievoPackNormalUnorm8(vec3 n)
{
  return relievoPackNormalBiased(n, 8);
}

vec3 relievoUnpackNormalUnorm8(uint word)
{
  return relievoUnpackNormalBiased(word, 8);
}

// RGB10A2: unit vector n in the lower 30 bits, x lowest (GL_UNSIGNED_INT_2_10_10_10_REV); A is 0.
uint relievoPackNormalUnorm10(vec3 n)
{
  return relievoPackNormalBiased(n, 10);
}

vec3 relievoUnpackNormalUnorm10(uint word)
{
  return relievoUnpackNormalBiased(word, 10);
}

// Three halves: x and y in the first word, z in the lower half of the second.
uvec2 relievoPackNormalHalf(vec3 n)
{
  if (!relievoIsDirection(n))
  {
    return uvec2(0, 0);
  }
  return uvec2(packHalf2x16(vec2(n.x, n.y)), packHalf2x16(vec2(n.z, float(0.0))));
}

vec3 relievoUnpackNormalHalf(uvec2 words)
{
  vec2 xy = unpackHalf2x16(words.x);
  vec3 n = vec3(xy.x, xy.y, unpackHalf2x16(words.y).x);
  return relievoIsDirection(n) ? normalize(n) : vec3(float(0.0), float(0.0), float(0.0));
}

// Three floats, bit for bit; not normalised when decoded.
uvec3 relievoPackNormalFloat(vec3 n)
{
  if (!relievoIsDirection(n))
  {
    return uvec3(0, 0, 0);
  }
  return uvec3(floatBitsToUint(n.x), floatBitsToUint(n.y), floatBitsToUint(n.z));
}

vec3 relievoUnpackNormalFloat(uvec3 words)
{
  return vec3(uintBitsToFloat(words.x), uintBitsToFloat(words.y), uintBitsToFloat(words.z));
}
