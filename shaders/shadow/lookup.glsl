// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Looks places up in the maps of lights, texel by texel. The includer defines RELIEVO_SHADOW_FACES
// (number of maps), RELIEVO_SHADOW_WIDE (the filter's radius is above 1) and
// RELIEVO_SHADOW_HAS_PLANE (an expression: whether the receiver has a plane).
//RELIEVO::Include(shadow/maps.glsl)

// Depths of the texels right and above of a corner texel, as textureGather orders them: (0, 1),
// (1, 1), (1, 0), (0, 0).
vec4 relievoShadowGather(float layer, vec2 corner)
{
#ifdef GL_ARB_texture_gather
  return textureGather(relievoShadowMaps, vec3((corner + 1.0) / relievoShadowSize, layer));
#else
  ivec2 last = ivec2(relievoShadowSize) - 1;
  ivec2 low = clamp(ivec2(corner), ivec2(0), last);
  ivec2 high = clamp(ivec2(corner) + 1, ivec2(0), last);
  int z = int(layer);
  return vec4(texelFetch(relievoShadowMaps, ivec3(low.x, high.y, z), 0).r,
    texelFetch(relievoShadowMaps, ivec3(high, z), 0).r,
    texelFetch(relievoShadowMaps, ivec3(high.x, low.y, z), 0).r,
    texelFetch(relievoShadowMaps, ivec3(low, z), 0).r);
#endif
}

// Which of those texels are unblocked for a receiver with this depth at the corner texel. Depth 1
// means no caster, so a receiver there is lit. Casters in front of the map are at depth 0, so if
// there may be any, no bias may move a receiver there.
vec4 relievoShadowLit(int face, vec2 corner, float depth, vec2 slope)
{
  vec4 receivers = depth + vec4(slope.y, slope.x + slope.y, slope.x, 0.0);
  return step(clamp(receivers, relievoShadowLowest[face], 1.0),
    relievoShadowGather(relievoShadowLayer[face], corner));
}

// The share of a map's light that reaches a receiver. place: in the map's texels, and its depth;
// slope: of the receiver's depth per texel; texel: depth of a texel's width there. Branches cost
// more than they save: except for wide filters the code has none.
float relievoShadowFilter(int face, vec3 place, vec2 slope, float texel)
{
  place.z -= RELIEVO_SHADOW_HAS_PLANE ? 0.0 : relievoShadowLift * texel;
  vec2 corner = floor(place.xy);
  vec2 part = place.xy - corner;
  float depth = place.z - dot(slope, part);
#ifdef RELIEVO_SHADOW_WIDE
  float lit = 0.0;
  for (int j = 1 - relievoShadowRadius; j < relievoShadowRadius; j += 2)
  {
    vec2 y = vec2(relievoFilterWeight(j, relievoShadowRadius, part.y),
      relievoFilterWeight(j + 1, relievoShadowRadius, part.y));
    for (int i = 1 - relievoShadowRadius; i < relievoShadowRadius; i += 2)
    {
      vec2 x = vec2(relievoFilterWeight(i, relievoShadowRadius, part.x),
        relievoFilterWeight(i + 1, relievoShadowRadius, part.x));
      vec2 offset = vec2(i, j);
      vec4 four = relievoShadowLit(face, corner + offset, depth + dot(slope, offset), slope);
      lit += y.x * dot(x, four.wz) + y.y * dot(x, four.xy);
    }
  }
  float across = float(2 * relievoShadowRadius - 1);
  return lit / (across * across);
#else
  part = relievoShadowRadius == 0 ? floor(part + 0.5) : part;
  vec4 four = relievoShadowLit(face, corner, depth, slope);
  vec2 rows = mix(four.wx, four.zy, part.x);
  return mix(rows.x, rows.y, part.y);
#endif
}
