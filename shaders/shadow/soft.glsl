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

// For each part of the light: texels of its map per depth, and the index of its map.
uniform vec3 relievoShadowRays[RELIEVO_SHADOW_LIGHTS * RELIEVO_SHADOW_PARTS];

// Steps of the sample number per column and row of the raster (vtkRelievoSampleLattice).
uniform vec2 relievoShadowPartStep; // whole numbers

// Most steps along a ray. Mesa unrolls a loop whose limit is a constant, and then every pixel takes
// all steps in software.
uniform float relievoShadowSteps; // a whole number

// Texels without casters are deeper than all receivers, of which some are beyond the far plane.
float relievoShadowDepthAt(int layer, ivec2 texel)
{
  ivec2 inside = clamp(texel, ivec2(0), ivec2(int(relievoShadowSize) - 1));
  float depth = texelFetch(relievoShadowMaps, ivec3(inside, layer), 0).r;
  return inside == texel && depth < 1.0 ? depth : 1e9;
}

#ifdef RELIEVO_SHADOW_NEAREST
// For each block of texels, the least depth of any texel that a ray from there may pass
// (vtkRelievoNearestDepths); the binary logarithm of a block's side is RELIEVO_SHADOW_NEAREST.
uniform samplerBuffer relievoShadowNearest;
uniform int relievoShadowBlocks; // on a map's side
#endif

// The depth in front of which nothing blocks a ray that starts at a texel, with that depth.
float relievoShadowNearestTo(int layer, ivec2 texel, float depth)
{
#ifdef RELIEVO_SHADOW_NEAREST
  ivec2 block = clamp(texel >> RELIEVO_SHADOW_NEAREST, ivec2(0), ivec2(relievoShadowBlocks - 1));
  int at = (layer * relievoShadowBlocks + block.y) * relievoShadowBlocks + block.x;
  float nearest = texelFetch(relievoShadowNearest, at).r;
  return depth <= 1.0 ? nearest : 0.0; // rays from beyond the map's depths reach farther
#else
  return 0.0;
#endif
}

// Of the part that the present pixel's cell has.
int relievoShadowPartNumber()
{
  ivec2 cell = ivec2(gl_FragCoord.xy);
  int number = cell.x * int(relievoShadowPartStep.x) + cell.y * int(relievoShadowPartStep.y);
  return number - number / RELIEVO_SHADOW_PARTS * RELIEVO_SHADOW_PARTS;
}

// For the part of the present cell, from a place relative to the origin of lookup.glsl. first: of
// the light's maps.
float relievoShadowPart(int light, int first, vec3 position, vec3 normalVC)
{
  int number = relievoShadowPartNumber();
  vec3 chosen = relievoShadowRays[light * RELIEVO_SHADOW_PARTS + number];
  int face = first + int(chosen.z);
  // Affine, as the rays are parallel: elements that are not read cost nothing.
  mat4 matrix = mat4(vec4(relievoShadowMatrix[face][0].xyz, 0.0),
    vec4(relievoShadowMatrix[face][1].xyz, 0.0), vec4(relievoShadowMatrix[face][2].xyz, 0.0),
    vec4(relievoShadowMatrix[face][3].xyz, 1.0));
  vec4 eye = relievoShadowEye[face];
  float texel = relievoShadowTexel[face];
  int layer = int(relievoShadowLayer[face]);
  vec4 map = matrix * vec4(position, 1.0);
  vec3 plane = relievoMapPlane(matrix, map, normalVC);
  vec3 place = RELIEVO_RECEIVER(matrix, map).xyz;
  vec2 slope = RELIEVO_SHADOW_HAS_PLANE ? relievoReceiverSlope(plane, 64.0 * texel) : vec2(0.0);
  place.z -= RELIEVO_SHADOW_HAS_PLANE ? 0.0 : relievoShadowLift * texel;
  bool open = !RELIEVO_SHADOW_HAS_PLANE ||
    (plane.z - dot(plane.xy, chosen.xy)) * dot(plane, eye.xyz - eye.w * place) < 0.0;
  ivec2 at = ivec2(floor(place.xy + 0.5));
  // The receiver itself does not block, as far as it is flat.
  float surface = place.z + dot(slope, vec2(at) - place.xy);
  float seen = relievoShadowDepthAt(layer, at);
  float texels = place.z * max(abs(chosen.x), abs(chosen.y));
  // Neighbouring texels need no tracing, and places outside of the map are lit.
  bool traced = open && texels > 1.0 && relievoShadowSees(place);
  open = open && (traced || !(seen < surface));
  float steps = clamp(ceil(2.0 * texels), 3.0, relievoShadowSteps);
  // Position of the lookups within the steps.
  float within = fract(0.6180339887 * float(number) + 0.5);
  float before = place.z;
  bool wasBelow = seen < min(place.z, surface);
  float nearest = relievoShadowNearestTo(layer, at, place.z);
  if (traced && (wasBelow || before >= nearest))
  {
    float i = 0.0;
    do
    {
      float part = min((i + within) / (steps - 1.0), 1.0);
      float way = place.z * part * part;
      float own = place.z - way;
      at = ivec2(floor(place.xy + way * chosen.xy + 0.5));
      seen = relievoShadowDepthAt(layer, at);
      bool below = seen < min(own, place.z + dot(slope, vec2(at) - place.xy));
      float step = before - own;
      open = !(wasBelow ? !below && seen < before + 1.5 * step : below && seen > own - step);
      wasBelow = below;
      before = own;
      i += 1.0;
    } while (open && i < steps && (wasBelow || before >= nearest));
  }
  return open || !relievoShadowSees(place) ? 1.0 : 0.0;
}
