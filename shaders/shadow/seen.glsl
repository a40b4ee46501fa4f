// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Places in pixels, and verdicts about them, for verdicts found once per pixel.
//
// Pixels are counted from the centre of the viewport, so that their centres are exact in float. The
// visible place at a pixel's centre is given by its eye-space z: an equal z means the same place,
// bit for bit.
//RELIEVO::Include(rays/passes.glsl)

// Local space: the world's axes, relative to a point near the visible surfaces; from eye space
// about the centre.
uniform mat4 relievoShadowToLocal;
// Texel: z, far behind everything for the background, and the code of the plane's normal.
uniform sampler2D relievoSeen;
uniform vec2 relievoSeenSize; // of the viewport, in pixels
// From eye space to pixels: (x * X.x + z * X.y + X.z) / (z * W.x + W.y), Y likewise; to depth:
// (z * Z.x + Z.y) / (z * W.x + W.y).
uniform vec3 relievoSeenX;
uniform vec3 relievoSeenY;
uniform vec2 relievoSeenZ;
uniform vec2 relievoSeenW;
uniform int relievoSeenLights;   // with verdicts
uniform float relievoSeenLevels; // of a verdict, from 0, dark, to the last, lit

// The pixel of a texel, and the texel of a place in pixels.
vec2 relievoSeenPixel(vec2 texel)
{
  return texel + (0.5 - 0.5 * relievoSeenSize);
}
vec2 relievoSeenTexel(vec2 pixel)
{
  return floor(pixel + 0.5 * relievoSeenSize);
}

vec2 relievoSeenAt(vec3 placeVC)
{
  vec2 at = vec2(dot(relievoSeenX, vec3(placeVC.x, placeVC.z, 1.0)),
    dot(relievoSeenY, vec3(placeVC.y, placeVC.z, 1.0)));
  return at / (placeVC.z * relievoSeenW.x + relievoSeenW.y);
}

// The visible place at a pixel, in eye space.
vec3 relievoSeenPlace(vec2 pixel, float z)
{
  float w = z * relievoSeenW.x + relievoSeenW.y;
  return vec3((pixel.x * w - relievoSeenX.y * z - relievoSeenX.z) / relievoSeenX.x,
    (pixel.y * w - relievoSeenY.y * z - relievoSeenY.z) / relievoSeenY.x, z);
}

// The effect of a raster's grid on a visible place, in eye space: a vector towards the eye, as long
// as the distance by which the place may be off a plane. Corners move by half a diagonal of 1/256
// pixel, those of the visible triangle and those of its neighbour, and the place with them, in the
// picture and, by its plane's slope, along the line of sight. slant: the cosine between line and
// normal, 1 without a surface; a NaN normal counts as seen from the side.
vec3 relievoSeenSnap(vec3 placeVC, float slant, bool parallel)
{
  float w = abs(placeVC.z * relievoSeenW.x + relievoSeenW.y);
  float pixel = max(w / abs(relievoSeenX.x), w / abs(relievoSeenY.x));
  float slope = abs(slant) > 1.0 / 64.0 ? 1.0 / abs(slant) : 64.0;
  return 0.0055242 * pixel * (1.0 + slope) * (parallel ? vec3(0.0, 0.0, 1.0) : -normalize(placeVC));
}

// 0 at the near plane, 1 at the far one.
float relievoSeenDepth(float z)
{
  return 0.5 + 0.5 * (z * relievoSeenZ.x + relievoSeenZ.y) / (z * relievoSeenW.x + relievoSeenW.y);
}

// Rounds a verdict to its levels, as stored.
RELIEVO_PASSES relievoSeenLevel(RELIEVO_PASSES passes)
{
  return floor(passes * (relievoSeenLevels - 1.0) + 0.5);
}
RELIEVO_PASSES relievoSeenVerdict(RELIEVO_PASSES level)
{
  return level / (relievoSeenLevels - 1.0);
}

// The level of the next light, a digit of the number.
RELIEVO_PASSES relievoSeenNextLevel(inout RELIEVO_PASSES digits)
{
  RELIEVO_PASSES others = floor(digits / relievoSeenLevels);
  RELIEVO_PASSES level = digits - others * relievoSeenLevels;
  digits = others;
  return level;
}

// From a place to a light, or along its direction.
vec3 relievoSeenToLight(vec4 source, vec3 place)
{
  return source.xyz - (source.w != 0.0 ? place : vec3(0.0));
}
