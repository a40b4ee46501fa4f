// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The share of a light that volumes let pass (vtkRelievoVolumeShade). The includer defines
// RELIEVO_SHADOW_LIGHTS, the number of lights, and RELIEVO_VOLUME_AROUND if one is among the volumes.
//RELIEVO::Include(volumes/texel.glsl)
uniform sampler3D relievoVolumeDepths; // of all lights, one behind the other
uniform vec3 relievoVolumeTexture;     // its size
uniform float relievoVolumeSlices;     // of a light
uniform mat4 relievoVolumeMatrix[RELIEVO_SHADOW_LIGHTS]; // from a place to `map`
uniform vec4 relievoVolumeSize[RELIEVO_SHADOW_LIGHTS];   // w: whether it is around the light

float relievoVolumePasses(int slot, vec3 place)
{
  vec4 map = relievoVolumeMatrix[slot] * vec4(place, 1.0);
  vec3 texel = relievoVolumeTexel(map, relievoVolumeSize[slot].xyz);
  bool there = map.w > 0.0;
#ifdef RELIEVO_VOLUME_AROUND
  bool around = relievoVolumeSize[slot].w > 0.0;
  texel = around ? relievoVolumeTexelAround(map, relievoVolumeSize[slot].xyz) : texel;
  there = there || around;
#endif
  texel.z += float(slot) * relievoVolumeSlices;
  float depth = texture(relievoVolumeDepths, (texel + 0.5) / relievoVolumeTexture).r;
  return there ? exp(-depth) : 1.0;
}
