// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The maps of lights. The includer defines RELIEVO_SHADOW_FACES (number of maps).
uniform sampler2DArray relievoShadowMaps;
// From a place, relative to the includer's origin, to map space, with the bias subtracted.
uniform mat4 relievoShadowMatrix[RELIEVO_SHADOW_FACES];
uniform float relievoShadowTexel[RELIEVO_SHADOW_FACES]; // depth of a texel's width, at w = 1
uniform vec4 relievoShadowEye[RELIEVO_SHADOW_FACES]; // in map space; w = 0: the direction to it
uniform float relievoShadowLayer[RELIEVO_SHADOW_FACES];
uniform float relievoShadowLowest[RELIEVO_SHADOW_FACES]; // depth of a receiver
uniform float relievoShadowSize;  // of a map, in texels
uniform float relievoShadowInner; // half of it, less the filter; -1 for props without shadows on
                                  // them
uniform int relievoShadowRadius;  // of the filter, in texels; 0: only the nearest texel
uniform float relievoShadowLift;  // in texels: for points and lines, which have no plane

// Whether the place is within the map.
bool relievoShadowSees(vec3 place)
{
  vec2 off = abs(place.xy - (0.5 * relievoShadowSize - 0.5));
  return max(off.x, off.y) <= relievoShadowInner;
}
