// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Fog in spheres: the length of a pixel's ray inside a sphere, up to a surface, and its
// transmittance.
//
// Near a sphere's outline its chord is the square root of a small difference. An error of 1e-5
// radii in the chord requires an error of 1e-11 in the difference, and so sums and products of two
// floats each: a value, and its remainder (T. J. Dekker, A floating-point technique for extending
// the available precision, 1971), which the compiler must not rearrange: exact.glsl.
#ifndef RELIEVO_EXACT
#define RELIEVO_EXACT
#endif

// a + b.
vec2 relievoSum(float a, float b)
{
  RELIEVO_EXACT float sum = a + b;
  RELIEVO_EXACT float second = sum - a;
  RELIEVO_EXACT float first = sum - second;
  RELIEVO_EXACT float lacks = (a - first) + (b - second);
  return vec2(sum, lacks);
}

// a * b, from 12-bit halves, whose products are exact.
vec2 relievoProduct(float a, float b)
{
  float aHigh = uintBitsToFloat(floatBitsToUint(a) & 0xfffff000u);
  float bHigh = uintBitsToFloat(floatBitsToUint(b) & 0xfffff000u);
  RELIEVO_EXACT float aLow = a - aHigh;
  RELIEVO_EXACT float bLow = b - bHigh;
  RELIEVO_EXACT float product = a * b;
  RELIEVO_EXACT float lacks =
    ((aHigh * bHigh - product) + aHigh * bLow + aLow * bHigh) + aLow * bLow;
  return vec2(product, lacks);
}

vec2 relievoPairSum(vec2 a, vec2 b)
{
  vec2 sum = relievoSum(a.x, b.x);
  RELIEVO_EXACT float lacks = sum.y + (a.y + b.y);
  return relievoSum(sum.x, lacks);
}

vec2 relievoPairProduct(vec2 a, float b)
{
  vec2 product = relievoProduct(a.x, b);
  RELIEVO_EXACT float lacks = product.y + a.y * b;
  return relievoSum(product.x, lacks);
}

// The radicand of the chord: a polynomial of degree 2 over the pixels, positive where the ray hits
// the sphere. `pixel` is counted from the origin of the coefficients:
//   linear.x + linear.y x + linear.z y + square.x x^2 + square.y x y + square.z y^2
// each coefficient with its remainder after rounding to float.
float relievoFogDiscriminant(
  vec2 pixel, vec3 linear, vec3 linearLacks, vec3 square, vec3 squareLacks)
{
  vec2 alongX = relievoPairSum(vec2(linear.y, linearLacks.y),
    relievoPairSum(relievoPairProduct(vec2(square.x, squareLacks.x), pixel.x),
      relievoPairProduct(vec2(square.y, squareLacks.y), pixel.y)));
  vec2 alongY = relievoPairSum(vec2(linear.z, linearLacks.z),
    relievoPairProduct(vec2(square.z, squareLacks.z), pixel.y));
  vec2 sum = relievoPairSum(vec2(linear.x, linearLacks.x),
    relievoPairSum(
      relievoPairProduct(alongX, pixel.x), relievoPairProduct(alongY, pixel.y)));
  return sum.x + sum.y;
}

// The length of the ray inside the sphere, in radii: 0 to 2.
//   discriminant  as above
//   square        squared length of the ray per unit of depth
// and depths in radii:
//   end           from the ray's begin to the surface, where it ends; may be infinite
//   toMiddle      from the ray's begin to the point nearest to the sphere's centre
//   fromMiddle    from that point to the surface
// min(exit, end) - max(entry, begin) is the least of four differences; each of them is computed
// from numbers that make it exact, for any position of eye and surface: inside, in front or behind.
float relievoFogChord(
  float discriminant, float square, float end, float toMiddle, float fromMiddle)
{
  if (!(discriminant > float(0.0)))
  {
    return float(0.0);
  }
  float halfChord = sqrt(discriminant) / square;
  float inside = min(
    min(halfChord + halfChord, end), min(toMiddle + halfChord, fromMiddle + halfChord));
  return max(inside, float(0.0)) * sqrt(square);
}

// The length of a pixel's ray inside the sphere, in radii, from the sphere's values
// (vtkRelievoSphereRays): the polynomial and its remainders; w of linear and linearLacks: the depth
// of the centre; w of square: 1 / radius; origin and offsets: from the centre to the ray at the
// centre's depth, in radii, and its change per pixel in x and y. `direction`: x and y of the ray
// per unit of depth.
float relievoFogChordAt(vec2 pixel, vec4 linear, vec4 linearLacks, vec4 square, vec4 squareLacks,
  vec2 origin, vec4 offsets, vec2 direction, float end)
{
  float discriminant = relievoFogDiscriminant(pixel, vec3(linear.x, linear.y, linear.z),
    vec3(linearLacks.x, linearLacks.y, linearLacks.z), vec3(square.x, square.y, square.z),
    vec3(squareLacks.x, squareLacks.y, squareLacks.z));
  float length2 = direction.x * direction.x + direction.y * direction.y + float(1.0);
  float offsetX = origin.x + offsets.x * pixel.x + offsets.z * pixel.y;
  float offsetY = origin.y + offsets.y * pixel.x + offsets.w * pixel.y;
  // Depth of the centre minus that of the ray's nearest point.
  float deeper = (offsetX * direction.x + offsetY * direction.y) / length2;
  return relievoFogChord(discriminant, length2, end * square.w, linear.w * square.w - deeper,
    ((end - linear.w) - linearLacks.w) * square.w + deeper);
}

// Optical depth of a chord in radii, with transmittance e^-depth. Depths above the limit would
// overflow sums of floats, and are invisible.
const float relievoFogLimit = float(1e6);

// The mode `beer`, Beer and Lambert: density is per radius.
float relievoFogBeer(float chord, float density)
{
  return min(chord * density, relievoFogLimit);
}

// The mode `chord`, the classic: absorption grows linearly, up to `density` at the full chord of 2
// radii.
float relievoFogLinear(float chord, float density)
{
  float held = min(float(0.5) * chord * density, float(1.0));
  return -log(max(float(1.0) - held, float(1e-7)));
}

// The share of fog colour per unit of optical depth: (1 - e^-depth) / depth.
float relievoFogShare(float depth)
{
  return depth < float(0.1)
    ? float(1.0) - depth / float(2.0) * (float(1.0) - depth / float(3.0) *
        (float(1.0) - depth / float(4.0) * (float(1.0) - depth / float(5.0))))
    : (float(1.0) - exp(-depth)) / depth;
}
