// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The share of a light that reaches a place, by the maps of lookup.glsl and the method's
// relievoShadowVerdict. RELIEVO_RECEIVER: see splice/contract.glsl.

// The share of a map's light that reaches a place in it, by the method. plane: normal of the
// receiver's plane in map space, of any length. Dark unless `facing` is negative: the visible side
// is turned away from the light, so the surface itself is between.
float relievoShadowAt(int face, vec3 place, vec3 plane, float facing, float inverseW)
{
  float texel = relievoShadowTexel[face] * inverseW;
  vec2 slope =
    RELIEVO_SHADOW_HAS_PLANE ? relievoReceiverSlope(plane, 64.0 * texel) : vec2(0.0);
  float lit = relievoShadowVerdict(face, place, slope, texel);
  return facing < 0.0 || !RELIEVO_SHADOW_HAS_PLANE ? lit : 0.0;
}

// A lamp with up to six.
float relievoShadowCube(int first, vec3 position, vec3 normalVC)
{
  for (int face = first; face < first + 6; ++face)
  {
    vec4 map =
      RELIEVO_RECEIVER(relievoShadowMatrix[face], relievoShadowMatrix[face] * vec4(position, 1.0));
    if (map.w > 0.0 && relievoShadowSees(map.xyz / map.w))
    {
      vec3 plane = relievoMapPlane(relievoShadowMatrix[face], map, normalVC);
      float facing = relievoMapFacing(plane, map.xyz / map.w, relievoShadowEye[face]);
      return relievoShadowAt(face, map.xyz / map.w, plane, facing, 1.0 / map.w);
    }
  }
  return 1.0;
}
