// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Directions on an octahedron unfolded to a square, in 2 x 8 or 2 x 16 bits.
// Z. Cigolle, S. Donow, D. Evangelakos, M. Mara, M. McGuire, Q. Meyer: A Survey of Efficient
// Representations for Independent Unit Vectors, JCGT 3(2), 2014.
//
// Words: two offset snorm codes (relievoQuantizeSnorm), x in the lower one; 2 x 8 fills the lower
// 16 bits. Word 0 means "no direction": zero, infinite or NaN vectors encode to it, and it decodes
// to the zero vector, so that a cleared buffer decodes to zero. Encoded values must not be blended
// or filtered: the square's rim is a seam.
//RELIEVO::Include(formulas/formats/numbers.glsl)

// Whether n has a direction: not zero, and every component finite.
bool relievoIsDirection(vec3 n)
{
  float size = abs(n.x) + abs(n.y) + abs(n.z);
  return size > float(0.0) && !isinf(size) && !isnan(size);
}

// Direction n (any length; relievoIsDirection) to the square [-1, 1]^2.
vec2 relievoOctEncode(vec3 n)
{
  float size = abs(n.x) + abs(n.y) + abs(n.z);
  float u = n.x / size;
  float v = n.y / size;
  if (n.z < float(0.0))
  {
    return vec2((float(1.0) - abs(v)) * relievoSignNotZero(u),
      (float(1.0) - abs(u)) * relievoSignNotZero(v));
  }
  return vec2(u, v);
}

// A point of the square [-1, 1]^2 to its unit vector.
vec3 relievoOctDecode(vec2 e)
{
  float x = e.x;
  float y = e.y;
  float z = float(1.0) - abs(x) - abs(y);
  if (z < float(0.0))
  {
    x = (float(1.0) - abs(e.y)) * relievoSignNotZero(e.x);
    y = (float(1.0) - abs(e.x)) * relievoSignNotZero(e.y);
  }
  return normalize(vec3(x, y, z));
}

// Two codes in one word, the second one shifted by `bits`.
uint relievoOctJoin(uint x, uint y, int bits)
{
  return x | (y << uint(bits));
}

// The unit vector of a word of two codes of `bits` bits each; the zero vector for word 0.
vec3 relievoOctUnpack(uint word, int bits)
{
  if (word == uint(0))
  {
    return vec3(float(0.0), float(0.0), float(0.0));
  }
  uint mask = (uint(1) << uint(bits)) - uint(1);
  float maxCode = float((uint(1) << uint(bits - 1)) - uint(1));
  return relievoOctDecode(vec2(relievoDequantizeSnorm(word & mask, maxCode),
    relievoDequantizeSnorm((word >> uint(bits)) & mask, maxCode)));
}

// The word of direction n, each coordinate rounded to the nearest code.
uint relievoOctPack(vec3 n, int bits)
{
  if (!relievoIsDirection(n))
  {
    return uint(0);
  }
  float maxCode = float((uint(1) << uint(bits - 1)) - uint(1));
  vec2 e = relievoOctEncode(n);
  return relievoOctJoin(
    relievoQuantizeSnorm(e.x, maxCode), relievoQuantizeSnorm(e.y, maxCode), bits);
}

// The word of direction n with the nearest decoded vector of the four codes around its position.
// Encoding costs four decodings, decoding costs nothing extra. Nearness is the squared distance of
// unit vectors: their scalar product is 1 - 1e-9 for all four at 16 bits, which a float cannot
// distinguish from 1.
uint relievoOctPackPrecise(vec3 n, int bits)
{
  if (!relievoIsDirection(n))
  {
    return uint(0);
  }
  float maxCode = float((uint(1) << uint(bits - 1)) - uint(1));
  vec3 unit = normalize(n / (abs(n.x) + abs(n.y) + abs(n.z)));
  vec2 e = relievoOctEncode(n);
  float baseX = floor(clamp(e.x, float(-1.0), float(1.0)) * maxCode);
  float baseY = floor(clamp(e.y, float(-1.0), float(1.0)) * maxCode);
  float bestX = baseX;
  float bestY = baseY;
  float bestDistance = float(8.0);
  for (int i = 0; i < 4; ++i)
  {
    float x = min(baseX + float(i & 1), maxCode);
    float y = min(baseY + float(i >> 1), maxCode);
    vec3 off = relievoOctDecode(vec2(x / maxCode, y / maxCode)) - unit;
    float distance2 = dot(off, off);
    if (distance2 < bestDistance)
    {
      bestDistance = distance2;
      bestX = x;
      bestY = y;
    }
  }
  float offset = maxCode + float(1.0);
  return relievoOctJoin(uint(bestX + offset), uint(bestY + offset), bits);
}

// The formats: 2 x 8 bits in the lower half of the word, 2 x 16 bits; plain and precise.
uint relievoPackNormalOct8(vec3 n)
{
  return relievoOctPack(n, 8);
}

uint relievoPackNormalOct8Precise(vec3 n)
{
  return relievoOctPackPrecise(n, 8);
}

vec3 relievoUnpackNormalOct8(uint word)
{
  return relievoOctUnpack(word, 8);
}

uint relievoPackNormalOct16(vec3 n)
{
  return relievoOctPack(n, 16);
}

uint relievoPackNormalOct16Precise(vec3 n)
{
  return relievoOctPackPrecise(n, 16);
}

vec3 relievoUnpackNormalOct16(uint word)
{
  return relievoOctUnpack(word, 16);
}
