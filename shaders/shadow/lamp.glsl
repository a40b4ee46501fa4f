// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The share of the light of one lamp from data that reaches a point: for the resource `lamp
// shadows` (vtkRelievoLampShadows), with places relative to the lamp, in eye space.
#define RELIEVO_SHADOW_FACES 6
#define RELIEVO_SHADOW_HAS_PLANE true
#define RELIEVO_RECEIVER(matrix, place) (place)
//RELIEVO::Include(formulas/light/shadow.glsl)
//RELIEVO::Include(shadow/lookup.glsl)
//RELIEVO::Include(shadow/map.glsl)
//RELIEVO::Include(shadow/reach.glsl)
uniform float relievoShadowStrength;

float relievoLampUnshadowed(vec3 fromLamp, vec3 faceNormal)
{
  return 1.0 - relievoShadowStrength * (1.0 - relievoShadowCube(0, fromLamp, faceNormal));
}
