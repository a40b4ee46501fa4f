// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Every formula once, by number, from words to words: the GPU and C++ run these same lines, and the
// test compares the results. Numbers are returned as the bits of a float.

vec3 relievoTestVector(uvec4 words)
{
  return vec3(uintBitsToFloat(words.x), uintBitsToFloat(words.y), uintBitsToFloat(words.z));
}

uvec4 relievoTestBits(vec4 v)
{
  return uvec4(
    floatBitsToUint(v.x), floatBitsToUint(v.y), floatBitsToUint(v.z), floatBitsToUint(v.w));
}

uvec4 relievoTestBits3(vec3 v)
{
  return relievoTestBits(vec4(v.x, v.y, v.z, float(0.0)));
}

// An off-centre, sheared projection with row 3 of perspective (w = 0) or parallel (w = 1).
mat4 relievoTestProjection(float w)
{
  return mat4(float(1.7), float(0.0), float(0.0), float(0.0),
    float(0.02), float(2.3), float(0.0), float(0.0),
    float(0.3), float(-0.2), float(-1.2), w - float(1.0),
    float(0.05), float(0.07), float(-2.2), w);
}

// Normals: a.xyz is the vector, or its words.
uvec4 relievoTestNormals(int which, uvec4 a)
{
  vec3 n = relievoTestVector(a);
  if (which == 0)
  {
    return uvec4(relievoPackNormalOct8(n), relievoPackNormalOct8Precise(n),
      relievoPackNormalOct16(n), relievoPackNormalOct16Precise(n));
  }
  if (which == 1)
  {
    uvec2 halves = relievoPackNormalHalf(n);
    return uvec4(
      relievoPackNormalUnorm8(n), relievoPackNormalUnorm10(n), halves.x, halves.y);
  }
  if (which == 2)
  {
    uvec3 floats = relievoPackNormalFloat(n);
    return uvec4(floats.x, floats.y, floats.z, relievoIsDirection(n) ? uint(1) : uint(0));
  }
  if (which == 3)
  {
    return relievoTestBits3(relievoUnpackNormalOct8(a.x));
  }
  if (which == 4)
  {
    return relievoTestBits3(relievoUnpackNormalOct16(a.x));
  }
  if (which == 5)
  {
    return relievoTestBits3(relievoUnpackNormalUnorm8(a.x));
  }
  if (which == 6)
  {
    return relievoTestBits3(relievoUnpackNormalUnorm10(a.x));
  }
  if (which == 7)
  {
    return relievoTestBits3(relievoUnpackNormalHalf(uvec2(a.x, a.y & uint(65535))));
  }
  return relievoTestBits3(relievoUnpackNormalFloat(uvec3(a.x, a.y, a.z)));
}

// Depth: a.x depth (11: window or reversed z; 14: a word), a.y near, a.z far; 15: b a normal; 16
// and above: b words.
uvec4 relievoTestDepth(int which, uvec4 a, uvec4 b)
{
  vec3 v = relievoTestVector(a);
  vec3 n = relievoTestVector(b);
  if (which == 10)
  {
    return uvec4(floatBitsToUint(relievoPerspectiveWindowZ(v.x, v.y, v.z)),
      floatBitsToUint(relievoPerspectiveReversedZ(v.x, v.y, v.z)),
      floatBitsToUint(relievoParallelWindowZ(v.x, v.y, v.z)),
      floatBitsToUint(relievoParallelReversedZ(v.x, v.y, v.z)));
  }
  if (which == 11)
  {
    return uvec4(floatBitsToUint(relievoPerspectiveDepth(v.x, v.y, v.z)),
      floatBitsToUint(relievoPerspectiveDepthFromReversed(v.x, v.y, v.z)),
      floatBitsToUint(relievoParallelDepth(v.x, v.y, v.z)),
      floatBitsToUint(relievoParallelDepthFromReversed(v.x, v.y, v.z)));
  }
  if (which == 12)
  {
    float t = relievoNormalizedDepth(v.x, v.y, v.z);
    return uvec4(floatBitsToUint(t), floatBitsToUint(relievoDepthFromNormalized(t, v.y, v.z)),
      floatBitsToUint(relievoDepth16FScale(v.z)), relievoPackDepth32F(v.x));
  }
  if (which == 13)
  {
    return uvec4(relievoPackWindowZ24(v.x), relievoPackDepth16F(v.x, float(1.0)),
      relievoPackDepth16F(v.x, float(0.25)), relievoPackDepth32F(v.x));
  }
  if (which == 14)
  {
    return uvec4(floatBitsToUint(relievoUnpackWindowZ24(a.x)),
      floatBitsToUint(relievoUnpackDepth16F(a.x & uint(65535), float(1.0))),
      floatBitsToUint(relievoUnpackDepth16F(a.x & uint(65535), float(0.25))),
      floatBitsToUint(relievoUnpackDepth32F(a.x)));
  }
  if (which == 15)
  {
    uvec2 halves = relievoPackNormalDepth16F(n, v.x, float(1.0));
    return uvec4(relievoPackNormalDepth8(n, v.x, v.y, v.z), halves.x, halves.y,
      relievoPackNormalDepth32F(n, v.x).w);
  }
  if (which == 16)
  {
    return relievoTestBits(relievoUnpackNormalDepth8(b.x, v.y, v.z));
  }
  if (which == 17)
  {
    return relievoTestBits(relievoUnpackNormalDepth16F(uvec2(b.x, b.y), float(1.0)));
  }
  return relievoTestBits(relievoUnpackNormalDepth32F(b));
}

// Space: a.xy pixel, a.z depth (25, 26: a.xyz a position); b.xy size of the viewport.
uvec4 relievoTestSpace(int which, uvec4 a, uvec4 b)
{
  vec3 v = relievoTestVector(a);
  vec3 size = relievoTestVector(b);
  vec2 ndc = relievoNdcFromPixel(vec2(v.x, v.y), vec2(size.x, size.y));
  vec4 viewport = vec4(float(3.0), float(5.0), size.x, size.y);
  if (which == 20)
  {
    vec3 eye =
      relievoPerspectiveEyePosition(ndc, v.z, float(1.7), float(2.3), float(0.3), float(-0.2));
    return relievoTestBits(vec4(eye.x, eye.y, eye.z, relievoRange(eye)));
  }
  if (which == 21)
  {
    vec3 eye =
      relievoParallelEyePosition(ndc, v.z, float(1.7), float(2.3), float(0.3), float(-0.2));
    return relievoTestBits(vec4(eye.x, eye.y, eye.z, relievoDepthFromEyePosition(eye)));
  }
  if (which == 22)
  {
    return relievoTestBits3(relievoEyePosition(ndc, v.z, relievoTestProjection(float(0.0))));
  }
  if (which == 23)
  {
    return relievoTestBits3(relievoEyePosition(ndc, v.z, relievoTestProjection(float(1.0))));
  }
  if (which == 24)
  {
    vec3 direction = relievoEyeDirection(ndc, float(1.7), float(2.3), float(0.3), float(-0.2));
    return relievoTestBits(vec4(direction.x, direction.y, direction.z,
      relievoRangeFromDepth(v.z, direction)));
  }
  if (which == 25)
  {
    return relievoTestBits3(relievoWorldPosition(v, relievoTestProjection(float(1.0))));
  }
  if (which == 26)
  {
    vec4 clip = relievoTestProjection(float(0.0)) * vec4(v.x, v.y, v.z, float(1.0));
    return relievoTestBits3(relievoWindowFromNdc(relievoNdcFromClip(clip), viewport));
  }
  return relievoTestBits3(relievoNdcFromWindow(v, viewport));
}

// Colour: a.x a value, or an id.
uvec4 relievoTestColor(int which, uvec4 a)
{
  vec3 v = relievoTestVector(a);
  if (which == 30)
  {
    return relievoTestBits3(relievoSrgbColorFromLinear(v));
  }
  if (which == 31)
  {
    return relievoTestBits3(relievoLinearColorFromSrgb(v));
  }
  if (which == 32)
  {
    return relievoTestBits3(relievoColormap(v.x));
  }
  if (which == 33)
  {
    return relievoTestBits3(relievoHashColor(a.x));
  }
  if (which == 34)
  {
    return uvec4(relievoHash(a.x), relievoHash(a.y), relievoHash(a.z), relievoHash(a.w));
  }
  if (which == 35)
  {
    return relievoTestBits3(relievoApproximateSrgbColorFromLinear(v));
  }
  return relievoTestBits3(relievoApproximateLinearColorFromSrgb(v));
}

// Tone: a.xyz light, whatever it is; 56: a.xyz coordinates of pixels; 57: values and thresholds;
// 58: light by the operator neutral.
uvec4 relievoTestTone(int which, uvec4 a)
{
  vec3 v = relievoTestVector(a);
  vec3 light = relievoToneClean(v);
  if (which < 54 || which == 58)
  {
    return relievoTestBits3(relievoTone(which == 58 ? 4 : which - 50, light, float(4.0)));
  }
  if (which == 54)
  {
    return relievoTestBits(vec4(relievoLuminance(light), relievoToneLogLuminance(light),
      relievoToneAutoExposure(relievoToneLogLuminance(light)),
      relievoToneIsLight(v) ? float(1.0) : float(0.0)));
  }
  if (which == 55)
  {
    return relievoTestBits3(relievoToneReinhard(light, float(0.5)));
  }
  if (which == 56)
  {
    return relievoTestBits3(vec3(relievoToneBayer(a.x, a.y), relievoToneBayer(a.y, a.z),
      relievoToneCurve(float(7.3), float(7.3))));
  }
  return relievoTestBits3(vec3(relievoToneDither(v.x, v.y), relievoToneDither(v.y, v.z),
    relievoToneDither(float(1.0), v.x)));
}

// Environment: a.xyz a direction; 42 to 45: a.xy a place (45 also: cosine, roughness), b.x a face.
uvec4 relievoTestEnvironment(int which, uvec4 a, uvec4 b)
{
  vec3 d = relievoTestVector(a);
  vec2 st = vec2(d.x, d.y);
  if (which == 40)
  {
    vec2 uv = relievoEquirectangularFromDirection(d);
    vec2 ball = relievoSphereMapFromDirection(d);
    return relievoTestBits(vec4(uv.x, uv.y, ball.x, ball.y));
  }
  if (which == 41)
  {
    int face = relievoCubeFace(d);
    vec2 place = relievoCubeFromDirection(d, face);
    return uvec4(uint(face), floatBitsToUint(place.x), floatBitsToUint(place.y),
      floatBitsToUint(relievoCubeDensity(place)));
  }
  if (which == 42)
  {
    return relievoTestBits3(relievoDirectionFromEquirectangular(st));
  }
  if (which == 43)
  {
    return relievoTestBits3(relievoDirectionFromCube(st, int(b.x)));
  }
  if (which == 44)
  {
    return relievoTestBits3(relievoDirectionFromSphereMap(st));
  }
  if (which == 45)
  {
    return relievoTestBits(vec4(relievoEquirectangularDensity(st), relievoSphereMapDensity(st),
      relievoPrefilterWeight(d.x, d.y) * d.y * d.y, relievoPrefilterLevel(d.y, 6)));
  }
  if (which == 47)
  {
    return relievoTestBits(vec4(relievoFresnel(d.x, d.y, d.z), relievoFresnel(d.x, d.y, float(0.0)),
      relievoFresnel(d.x, float(0.0), d.z), relievoFresnel(d.x, -d.y, d.z)));
  }
  vec3 coefficients[9];
  for (int i = 0; i < 9; ++i)
  {
    float shade = float(i + 1);
    coefficients[i] = vec3(shade, float(1.0) / shade, relievoPrefilterRoughness(i, 9));
  }
  return relievoTestBits3(relievoShIrradiance(d, coefficients));
}

// Fog: pairs of floats, which must be equal to the last bit, and values derived from them.
uvec4 relievoTestFog(int which, uvec4 a, uvec4 b)
{
  vec3 u = relievoTestVector(a);
  vec3 v = relievoTestVector(b);
  if (which == 60)
  {
    vec2 sum = relievoSum(u.x, v.x);
    vec2 product = relievoProduct(u.x, v.x);
    return relievoTestBits(vec4(sum.x, sum.y, product.x, product.y));
  }
  vec3 least = vec3(float(3e-8) * u.y, float(2e-8) * v.y, float(1e-8) * u.z);
  if (which == 61)
  {
    vec2 sum = relievoPairSum(vec2(u.x, least.x * u.x), vec2(v.x, least.y * v.x));
    vec2 product = relievoPairProduct(vec2(u.x, least.x * u.x), v.x);
    return relievoTestBits(vec4(sum.x, sum.y, product.x, product.y));
  }
  // 0.5 (x + y)^2 - 1, as it is at a pixel some way off: it cancels to a small rest.
  vec2 pixel = vec2(floor(float(100.0) * u.x), floor(float(100.0) * v.x));
  float away = pixel.x + pixel.y;
  float discriminant = relievoFogDiscriminant(pixel,
    vec3(float(0.5) * away * away + u.z * float(0.001), -away, -away), least,
    vec3(float(0.5), float(1.0), float(0.5)), vec3(float(0.0), float(0.0), float(0.0)));
  float end = float(4.0) * abs(u.y);
  return relievoTestBits(vec4(discriminant,
    relievoFogChord(abs(u.z), float(1.0) + abs(v.z), end, u.y, end - u.y),
    relievoFogLinear(abs(u.x), abs(v.y)), relievoFogShare(abs(u.y))));
}

// Noise: the words of a corner, the same to the last bit, and the noise itself, near and far.
uvec4 relievoTestNoise(uvec4 a, uvec4 b)
{
  ivec3 far = ivec3(int(a.x >> uint(3)), int(a.y >> uint(3)), int(a.z >> uint(3))) -
    ivec3(268435456, 268435456, 268435456);
  ivec3 near = ivec3(int(a.x & uint(7)), int(a.y & uint(7)), int(a.z & uint(7)));
  float cell = float(1.0) / float(16777216.0);
  vec3 part = vec3(float(b.x >> uint(8)) * cell, float(b.y >> uint(8)) * cell,
    float(b.z >> uint(8)) * cell);
  return uvec4(relievoNoiseHash(a.x, a.y, a.z, a.w), relievoNoiseHash(b.x, a.y, b.z, a.w),
    floatBitsToUint(relievoSimplexNoise(far, part, a.w)),
    floatBitsToUint(relievoSimplexNoise(near, part, a.w)));
}

// Skin: quaternions from the directions a.xyz and b.xyz, with real parts between -1 and 1.
uvec4 relievoTestSkin(int which, uvec4 a, uvec4 b)
{
  vec3 v = relievoTestVector(a);
  vec3 w = relievoTestVector(b);
  vec4 p = normalize(vec4(v.x, v.y, v.z, w.x));
  vec4 q = normalize(vec4(w.x, w.y, w.z, v.z));
  if (which == 80)
  {
    return relievoTestBits(relievoQuaternionNlerp(p, q, float(0.3)));
  }
  if (which == 81)
  {
    return relievoTestBits(relievoQuaternionSlerp(p, q, float(0.3)));
  }
  if (which == 82)
  {
    return relievoTestBits3(relievoQuaternionRotate(p, w));
  }
  if (which == 83)
  {
    mat3 turn = relievoQuaternionMatrix(p);
    return relievoTestBits(relievoQuaternionNear(relievoQuaternionOf(turn), p));
  }
  if (which == 84)
  {
    vec4 real = p * float(0.7);
    return relievoTestBits3(relievoDualTranslation(real, relievoDualOf(real, w)));
  }
  return relievoTestBits3(relievoNormalMatrix(mat3(v, w, vec3(v.y, w.z, v.x))) * w);
}

// Indices into a tree, from a.x leaves and the leaf a.y.
uvec4 relievoTestTree(uvec4 a)
{
  float leaf = float(-1.0) - float(a.y);
  return uvec4(uint(relievoTreeNodesOf(float(a.x))), uint(relievoTreeLeaf(leaf)),
    uint(relievoTreeLeafFirst(leaf)), uint(0));
}

uvec4 relievoTestCase(int which, uvec4 a, uvec4 b)
{
  if (which < 10)
  {
    return relievoTestNormals(which, a);
  }
  if (which < 20)
  {
    return relievoTestDepth(which, a, b);
  }
  if (which < 30)
  {
    return relievoTestSpace(which, a, b);
  }
  if (which < 40)
  {
    return relievoTestColor(which, a);
  }
  if (which < 50)
  {
    return relievoTestEnvironment(which, a, b);
  }
  if (which < 60)
  {
    return relievoTestTone(which, a);
  }
  if (which < 70)
  {
    return relievoTestFog(which, a, b);
  }
  if (which < 80)
  {
    return relievoTestNoise(a, b);
  }
  if (which < 90)
  {
    return relievoTestSkin(which, a, b);
  }
  return relievoTestTree(a);
}
