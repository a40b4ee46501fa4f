// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Spliced into VTK's shaders of volumes (vtkRelievoShadowVolumes): each light of a sample is
// multiplied by its visibility, past surfaces by the light's maps or rays and through volumes, the
// sample's own too, by volumes/shade.glsl. Places are those of VTK's ray march, g_dataPos; the
// matrices' uniforms lead from there.
//
// Defines: RELIEVO_SHADOW_LIGHTS, RELIEVO_SHADOW_FACES as in receive.glsl; RELIEVO_VOLUME_NUMBERS,
// the number of lights in VTK's shader. The method's section MethodDec is inserted between Dec and
// LitDec, and TraceDec if it traces rays.

// Lines of two texts: VTK's, and its replacement, for each of VTK's names of a light's number.
//RELIEVO::Section(Words)
(df * in_lightDiffuseColor[RELIEVO_NUMBER] => (df * relievoVolumeLit(RELIEVO_NUMBER) * in_lightDiffuseColor[RELIEVO_NUMBER]
(sf * in_lightSpecularColor[RELIEVO_NUMBER] => (sf * relievoVolumeLit(RELIEVO_NUMBER) * in_lightSpecularColor[RELIEVO_NUMBER]
+= in_lightDiffuseColor[RELIEVO_NUMBER] * nDotL => += relievoVolumeLit(RELIEVO_NUMBER) * in_lightDiffuseColor[RELIEVO_NUMBER] * nDotL
specular = in_lightSpecularColor[RELIEVO_NUMBER] * => specular = relievoVolumeLit(RELIEVO_NUMBER) * in_lightSpecularColor[RELIEVO_NUMBER] *
//RELIEVO::Section(Numbers)
posNum
dirNum
lightNum

//RELIEVO::Section(Dec)
//RELIEVO::Include(formulas/shadow.glsl)
#define RELIEVO_SHADOW_HAS_PLANE false
uniform float relievoShadowStrength[RELIEVO_SHADOW_LIGHTS];
uniform int relievoVolumeSlot[RELIEVO_VOLUME_NUMBERS]; // of a light in VTK's shader; -1: casts none
//RELIEVO::Include(shadow/lookup.glsl)

//RELIEVO::Section(ShadeDec)
//RELIEVO::Include(volumes/shade.glsl)

//RELIEVO::Section(LitDec)
//RELIEVO::Include(shadow/reach.glsl)

// By the light's only map. Places outside are lit.
float relievoVolumeInMap(int face)
{
  vec4 map = relievoShadowMatrix[face] * vec4(g_dataPos, 1.0);
  vec3 place = map.xyz / map.w;
  float lit = relievoShadowAt(face, place, vec3(0.0), -1.0, 1.0 / map.w);
  return map.w > 0.0 && relievoShadowSees(place) ? lit : 1.0;
}

float relievoVolumePast(int slot)
{
  float lit = 1.0;
RELIEVO_VOLUME_MAPS
  return lit;
}

// The last light and sample asked for: VTK asks twice for each.
int relievoVolumeLast = -1;
vec3 relievoVolumeAt;
float relievoVolumeLeft;

float relievoVolumeLit(int number)
{
  if (number != relievoVolumeLast || g_dataPos != relievoVolumeAt)
  {
    int slot = relievoVolumeSlot[number];
    relievoVolumeLast = number;
    relievoVolumeAt = g_dataPos;
    relievoVolumeLeft = slot < 0
      ? 1.0
      : 1.0 - relievoShadowStrength[slot] * (1.0 - relievoVolumePast(slot) RELIEVO_VOLUME_SHADE);
  }
  return relievoVolumeLeft;
}

//RELIEVO::Section(Shade)
* relievoVolumePasses(slot, g_dataPos)

//RELIEVO::Section(MapImpl)
  lit = slot == RELIEVO_SLOT ? relievoVolumeInMap(RELIEVO_FACE) : lit;

//RELIEVO::Section(CubeImpl)
  lit = slot == RELIEVO_SLOT ? relievoShadowCube(RELIEVO_FACE, g_dataPos, vec3(0.0, 0.0, 1.0)) : lit;

//RELIEVO::Section(TraceImpl)
  {
    vec3 placeLC = (relievoShadowToLocal * vec4(g_dataPos, 1.0)).xyz;
    vec4 source = relievoShadowSource[slot];
    lit *= RELIEVO_PASSES_WHOLE(relievoTreeWalk(relievoTreeNodes, placeLC,
      relievoSeenToLight(source, placeLC), source.w != 0.0, 0.0, vec3(0.0)));
  }
