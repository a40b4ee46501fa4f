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

// VTK's texts of a light's colour, and of a light's number; and the text in front of the colour.
//RELIEVO::Section(Colors)
(df * in_lightDiffuseColor[RELIEVO_NUMBER]
(sf * in_lightSpecularColor[RELIEVO_NUMBER]
+= in_lightDiffuseColor[RELIEVO_NUMBER] * nDotL
specular = in_lightSpecularColor[RELIEVO_NUMBER] *
//RELIEVO::Section(Numbers)
posNum
dirNum
lightNum
//RELIEVO::Section(Color)
in_light
//RELIEVO::Section(DimmedColor)
relievoVolumeLit(RELIEVO_NUMBER) * in_light

//RELIEVO::Section(Dec)
//RELIEVO::Include(formulas/light/shadow.glsl)
#define RELIEVO_SHADOW_HAS_PLANE false
uniform float relievoShadowStrength[RELIEVO_SHADOW_LIGHTS];
uniform int relievoVolumeSlot[RELIEVO_VOLUME_NUMBERS]; // of a light in VTK's shader; -1: casts none
//RELIEVO::Include(shadow/maps.glsl)
#if defined(RELIEVO_SHADOW_COLORED) || defined(RELIEVO_VOLUME_TINTED)
#define RELIEVO_VOLUME_LEFT vec3
vec3 relievoShadowColors[RELIEVO_SHADOW_LIGHTS];
#else
#define RELIEVO_VOLUME_LEFT float
#endif
float relievoVisibility[RELIEVO_SHADOW_LIGHTS];
RELIEVO_VOLUME_LEFT relievoVolumeLeft[RELIEVO_SHADOW_LIGHTS]; // of each light, for a sample

// The nearest texel decides: the march averages over many samples, and each costs.
float relievoShadowFilter(int face, vec3 place, vec2 slope, float texel)
{
  ivec2 last = ivec2(relievoShadowSize) - 1;
  float depth =
    texelFetch(relievoShadowMaps,
      ivec3(clamp(ivec2(place.xy + 0.5), ivec2(0), last), int(relievoShadowLayer[face])), 0).r;
  return step(clamp(place.z, relievoShadowLowest[face], 1.0), depth);
}

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

// Software OpenGL runs all branches: each light is looked up once for a sample.
void relievoVolumeLookUp()
{
RELIEVO_VOLUME_LOOKUPS
}

RELIEVO_VOLUME_LEFT relievoVolumeLit(int number)
{
  int slot = relievoVolumeSlot[number];
  return slot < 0 ? RELIEVO_VOLUME_LEFT(1.0) : relievoVolumeLeft[slot];
}

// VTK's function that lights a sample, and the first line of its body.
//RELIEVO::Section(Function)
vec4 computeLighting(vec4 color
//RELIEVO::Section(FunctionBegin)
vec4 finalColor = vec4(0.0);
//RELIEVO::Section(LookUp)
  relievoVolumeLookUp();

//RELIEVO::Section(LightImpl)
  {
    RELIEVO_VOLUME_LEFT lit = RELIEVO_VOLUME_LEFT(1.0);
RELIEVO_VOLUME_PAST
    relievoVolumeLeft[RELIEVO_SLOT] = 1.0 - relievoShadowStrength[RELIEVO_SLOT] * (1.0 - lit);
  }

//RELIEVO::Section(ShadeImpl)
    lit *= RELIEVO_VOLUME_LEFT(
      RELIEVO_VOLUME_COLORS(relievoVolumePasses(RELIEVO_SLOT, g_dataPos)));

//RELIEVO::Section(MapImpl)
    lit *= relievoVolumeInMap(RELIEVO_FACE);

//RELIEVO::Section(CubeImpl)
    lit *= relievoShadowCube(RELIEVO_FACE, g_dataPos, vec3(0.0, 0.0, 1.0));

//RELIEVO::Section(TraceImpl)
    {
      vec3 placeLC = (relievoShadowToLocal * vec4(g_dataPos, 1.0)).xyz;
      vec4 source = relievoShadowSource[RELIEVO_SLOT];
      lit *= RELIEVO_VOLUME_LEFT(relievoTreeWalk(relievoTreeNodes, placeLC,
        relievoSeenToLight(source, placeLC), source.w != 0.0, 0.0, vec3(0.0)));
    }
