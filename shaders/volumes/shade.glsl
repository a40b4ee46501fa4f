// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The share of a light that volumes let pass (vtkRelievoVolumeShade). The includer defines
// RELIEVO_SHADOW_LIGHTS, the number of lights, RELIEVO_VOLUME_AROUND if one is among the volumes,
// RELIEVO_VOLUME_TINTED if they colour the light, RELIEVO_VOLUME_HARMONICS, the number of harmonics
// of the series that rays have, or 0 if they have nodes (vtkRelievoOpticalDepths),
// RELIEVO_VOLUME_SPREAD if a sun has a size; then
// with shadow/soft.glsl where pixels have parts of its disc (RELIEVO_SHADOW_PARTS).
//RELIEVO::Include(volumes/texel.glsl)
uniform sampler3D relievoVolumeDepths; // of all lights, one behind the other
uniform vec3 relievoVolumeTexture;     // its size
uniform float relievoVolumeSlices;     // of a light
uniform mat4 relievoVolumeMatrix[RELIEVO_SHADOW_LIGHTS]; // from a place to `map`
uniform vec4 relievoVolumeSize[RELIEVO_SHADOW_LIGHTS];   // w: whether it is around the light

// With RELIEVO_VOLUME_TINTED: the shares of red, green and blue, and last that without colours.
#ifdef RELIEVO_VOLUME_TINTED
#define RELIEVO_VOLUME_SHARE vec4
#define RELIEVO_VOLUME_WHOLE(share) (share).w
#define RELIEVO_VOLUME_COLORS(share) (share).rgb
#define RELIEVO_VOLUME_PASSES(texel) exp(-vec4((texel).rgb + (texel).a, (texel).a))
#else
#define RELIEVO_VOLUME_SHARE float
#define RELIEVO_VOLUME_WHOLE(share) (share)
#define RELIEVO_VOLUME_COLORS(share) (share)
#define RELIEVO_VOLUME_PASSES(texel) exp(-(texel).r)
#endif

#ifdef RELIEVO_VOLUME_SPREAD
// Of a sun's rays: texels aside per slice behind the volumes' middle, and that slice.
uniform vec3 relievoVolumeSpread[RELIEVO_SHADOW_LIGHTS];
#endif

#if RELIEVO_VOLUME_HARMONICS > 0
// At a texel, by the series: its terms lie behind each other, not interpolated.
vec4 relievoVolumeDepth(int slot, vec3 texel)
{
  vec3 at = (vec3(texel.xy, float(slot) * relievoVolumeSlices) + 0.5) / relievoVolumeTexture;
  float share = texel.z / (relievoVolumeSize[slot].z - 1.0);
  vec2 turn = vec2(cos(6.2831853 * share), sin(6.2831853 * share));
  vec2 turned = vec2(1.0, 0.0);
  vec4 depths = share * texture(relievoVolumeDepths, at);
  for (int m = 1; m <= RELIEVO_VOLUME_HARMONICS; ++m)
  {
    turned = vec2(turned.x * turn.x - turned.y * turn.y, turned.x * turn.y + turned.y * turn.x);
    at.z += 1.0 / relievoVolumeTexture.z;
    depths += turned.y * texture(relievoVolumeDepths, at);
    at.z += 1.0 / relievoVolumeTexture.z;
    depths += (1.0 - turned.x) * texture(relievoVolumeDepths, at);
  }
  return max(depths, 0.0);
}
#else
vec4 relievoVolumeDepth(int slot, vec3 texel)
{
  texel.z += float(slot) * relievoVolumeSlices;
  return texture(relievoVolumeDepths, (texel + 0.5) / relievoVolumeTexture);
}
#endif

RELIEVO_VOLUME_SHARE relievoVolumePassesAt(int slot, vec4 map)
{
  vec3 texel = relievoVolumeTexel(map, relievoVolumeSize[slot].xyz);
  bool there = map.w > 0.0;
#ifdef RELIEVO_VOLUME_AROUND
  bool around = relievoVolumeSize[slot].w > 0.0;
  texel = around ? relievoVolumeTexelAround(map, relievoVolumeSize[slot].xyz) : texel;
  there = there || around;
#endif
  vec4 depths = relievoVolumeDepth(slot, texel);
  return there ? RELIEVO_VOLUME_PASSES(depths) : RELIEVO_VOLUME_SHARE(1.0);
}

#ifdef RELIEVO_VOLUME_SPREAD
// For a ray of a disc of the sky, to one of a spiral of points. The rays meet the volumes about at
// their middle.
RELIEVO_VOLUME_SHARE relievoVolumePassesAside(int slot, vec4 map, int point, int points)
{
  vec3 spread = relievoVolumeSpread[slot];
  float angle = 2.3999632 * float(point);
  vec2 disc = sqrt((float(point) + 0.5) / float(points)) * vec2(cos(angle), sin(angle));
  vec2 aside = spread.xy * disc * max(map.z - spread.z, 0.0);
  return relievoVolumePassesAt(slot, map + vec4(aside, 0.0, 0.0));
}
#endif

RELIEVO_VOLUME_SHARE relievoVolumePasses(int slot, vec3 place)
{
  vec4 map = relievoVolumeMatrix[slot] * vec4(place, 1.0);
#ifdef RELIEVO_VOLUME_SPREAD
  // Where pixels have parts of the disc, their mean is over the disc's points.
#ifdef RELIEVO_SHADOW_PARTS
  return relievoVolumePassesAside(slot, map, relievoShadowPartNumber(), RELIEVO_SHADOW_PARTS);
#else
  RELIEVO_VOLUME_SHARE sum = RELIEVO_VOLUME_SHARE(0.0);
  for (int i = 0; i < 8; ++i)
  {
    sum += relievoVolumePassesAside(slot, map, i, 8);
  }
  return sum / 8.0;
#endif
#else
  return relievoVolumePassesAt(slot, map);
#endif
}
