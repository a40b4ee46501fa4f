// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether a part of a sun's disc reaches a place: the part's ray is traced through a map drawn from
// the centre of several parts, like relief mapping traces rays through heights (F. Policarpo, M.
// Oliveira, J. Comba, Real-time relief mapping on arbitrary polygonal surfaces, 2005), in steps
// that grow with the distance. The ray is blocked where it passes through the surface, up or down,
// but not where the surface ends above it.
//
// The includer has shadow/lookup.glsl, RELIEVO_SHADOW_LIGHTS and RELIEVO_SHADOW_PARTS, the number
// of parts.
#define RELIEVO_SHADOW_STEPS 12 // at most

// For each part of the light: texels of its map per depth, and the index of its map.
uniform vec3 relievoShadowRays[RELIEVO_SHADOW_LIGHTS * RELIEVO_SHADOW_PARTS];

// Steps of the sample number per column and row of the raster (vtkRelievoSampleLattice).
uniform vec2 relievoShadowPartStep; // whole numbers

float relievoShadowDepthAt(int face, ivec2 texel)
{
  ivec2 inside = clamp(texel, ivec2(0), ivec2(int(relievoShadowSize) - 1));
  float depth = texelFetch(relievoShadowMaps, ivec3(inside, int(relievoShadowLayer[face])), 0).r;
  return inside == texel ? depth : 1.0;
}

// within: 0 to 1, position of the lookups within the steps.
float relievoShadowFollow(int face, vec3 place, vec2 slope, vec2 ray, int steps, float within)
{
  float lit = 1.0;
  float before = place.z;
  bool wasBelow = false;
  for (int i = 0; i <= steps; ++i)
  {
    float part = i == 0 ? 0.0 : min((float(i) - 1.0 + within) / float(steps - 1), 1.0);
    float way = place.z * part * part;
    float own = place.z - way;
    ivec2 at = ivec2(floor(place.xy + way * ray + 0.5));
    float seen = relievoShadowDepthAt(face, at);
    // The receiver itself does not block, as far as it is flat.
    bool below = seen < min(own, place.z + dot(slope, vec2(at) - place.xy));
    float step = before - own;
    bool blocks = i > 0 && (wasBelow ? !below && seen < before + 1.5 * step
                                     : below && seen > own - step);
    lit = blocks ? 0.0 : lit;
    wasBelow = below;
    before = own;
  }
  return lit;
}

// For the part of the present cell, from a place relative to the origin of lookup.glsl. first: of
// the light's maps.
float relievoShadowPart(int light, int first, vec3 position, vec3 normalVC)
{
  ivec2 cell = ivec2(gl_FragCoord.xy);
  int number = cell.x * int(relievoShadowPartStep.x) + cell.y * int(relievoShadowPartStep.y);
  number -= number / RELIEVO_SHADOW_PARTS * RELIEVO_SHADOW_PARTS;
  vec3 chosen = relievoShadowRays[light * RELIEVO_SHADOW_PARTS + number];
  int face = first + int(chosen.z);
  vec4 map = relievoShadowMatrix[face] * vec4(position, 1.0);
  vec3 plane = relievoMapPlane(relievoShadowMatrix[face], map, normalVC);
  vec3 place = RELIEVO_RECEIVER(relievoShadowMatrix[face], map).xyz;
  float texel = relievoShadowTexel[face];
  vec2 slope = RELIEVO_SHADOW_HAS_PLANE ? relievoReceiverSlope(plane, 64.0 * texel) : vec2(0.0);
  place.z -= RELIEVO_SHADOW_HAS_PLANE ? 0.0 : relievoShadowLift * texel;
  vec4 eye = relievoShadowEye[face];
  bool faces = (plane.z - dot(plane.xy, chosen.xy)) * dot(plane, eye.xyz - eye.w * place) < 0.0;
  float lit = 0.0;
  if (faces || !RELIEVO_SHADOW_HAS_PLANE)
  {
    // Neighbouring texels need no tracing.
    float texels = place.z * max(abs(chosen.x), abs(chosen.y));
    ivec2 at = ivec2(floor(place.xy + 0.5));
    int steps = clamp(int(ceil(2.0 * texels)), 3, RELIEVO_SHADOW_STEPS);
    float within = fract(0.6180339887 * float(number) + 0.5);
    lit = texels > 1.0
      ? relievoShadowFollow(face, place, slope, chosen.xy, steps, within)
      : step(place.z + dot(slope, vec2(at) - place.xy), relievoShadowDepthAt(face, at));
  }
  return relievoShadowSees(place) ? lit : 1.0;
}
