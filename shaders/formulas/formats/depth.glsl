// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Depth: conversion between linear depth (eye space -z, world units), window z, reversed z, and
// packed words.
//
// zNear and zFar are the distances of the clipping planes, zNear < zFar; in perspective zNear > 0
// and zFar may be infinite.
// The window z of OpenGL is 0 on the near plane, 1 on the far plane; reversed z (clip range zero to
// one) is 1 on the near plane, 0 on the far plane. Depth +infinity means background: it has
// window z +infinity and reversed z -infinity and comes back from them.
//RELIEVO::Include(formulas/formats/numbers.glsl)

// The words of depth +infinity, the clear values of a buffer of each format.
const uint relievoDepth32FNone = 0x7f800000u;
const uint relievoDepth16FNone = 0x00007c00u;
const uint relievoDepth24None = 0xffffffffu;
const uint relievoReversed32FNone = 0xff800000u;

float relievoInfinity()
{
  return uintBitsToFloat(relievoDepth32FNone);
}

// Depth to (depth - near) / (far - near), 0 to 1 between the planes, and back.
float relievoNormalizedDepth(float depth, float zNear, float zFar)
{
  return (depth - zNear) / (zFar - zNear);
}

float relievoDepthFromNormalized(float normalized, float zNear, float zFar)
{
  return zNear + normalized * (zFar - zNear);
}

// Perspective: depth to reversed z, whose spacing shrinks towards the far plane like that of
// floats.
float relievoPerspectiveReversedZ(float depth, float zNear, float zFar)
{
  return isinf(depth)
    ? -depth
    : (zNear / depth) * ((float(1.0) - depth / zFar) / (float(1.0) - zNear / zFar));
}

float relievoPerspectiveDepthFromReversed(float reversedZ, float zNear, float zFar)
{
  return isinf(reversedZ)
    ? -reversedZ
    : zNear / (zNear / zFar + reversedZ * (float(1.0) - zNear / zFar));
}

// Perspective: depth to window z, as 1 - reversed z: far away, where window z is coarsest, only its
// own last bit is lost.
float relievoPerspectiveWindowZ(float depth, float zNear, float zFar)
{
  return isinf(depth) ? depth : float(1.0) - relievoPerspectiveReversedZ(depth, zNear, zFar);
}

// Perspective: window z to depth. Loses digits as far / near grows: far depths depend on 1 - z
// alone.
float relievoPerspectiveDepth(float windowZ, float zNear, float zFar)
{
  return isinf(windowZ)
    ? windowZ
    : zNear / ((float(1.0) - windowZ) + windowZ * (zNear / zFar));
}

// Parallel projection: depth to window z and back.
float relievoParallelWindowZ(float depth, float zNear, float zFar)
{
  return (depth - zNear) / (zFar - zNear);
}

float relievoParallelDepth(float windowZ, float zNear, float zFar)
{
  return zNear + windowZ * (zFar - zNear);
}

// Parallel projection: depth to reversed z and back.
float relievoParallelReversedZ(float depth, float zNear, float zFar)
{
  return (zFar - depth) / (zFar - zNear);
}

float relievoParallelDepthFromReversed(float reversedZ, float zNear, float zFar)
{
  return zFar - reversedZ * (zFar - zNear);
}

// R32F, bit for bit: for depth, window z and reversed z.
uint relievoPackDepth32F(float depth)
{
  return floatBitsToUint(depth);
}

float relievoUnpackDepth32F(uint word)
{
  return uintBitsToFloat(word);
}

// R16F of depth * scale, in the lower 16 bits. With scale 1 (world units) depths beyond 65504
// become 65504 and those below 6.1e-5 lose digits; relievoDepth16FScale avoids both up to
// far / near = 5e8.
uint relievoPackDepth16F(float depth, float scale)
{
  return packHalf2x16(vec2(relievoSaturateHalf(depth * scale), float(0.0)));
}

float relievoUnpackDepth16F(uint word, float scale)
{
  return unpackHalf2x16(word).x / scale;
}

// The largest power of two that scales a finite far to at most 65504, the largest half; a power of
// two causes no rounding. The mask selects a float's exponent.
float relievoDepth16FScale(float zFar)
{
  return uintBitsToFloat(floatBitsToUint(float(65504.0) / zFar) & 0x7f800000u);
}

// 24-bit window z (unorm) in the lower 24 bits; window z +infinity has word relievoDepth24None.
uint relievoPackWindowZ24(float windowZ)
{
  return isinf(windowZ) ? relievoDepth24None : relievoQuantizeUnorm(windowZ, float(16777215.0));
}

float relievoUnpackWindowZ24(uint word)
{
  return word > uint(0x00ffffff) ? relievoInfinity()
                                 : relievoDequantizeUnorm(word, float(16777215.0));
}
