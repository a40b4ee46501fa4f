//VTK::System::Dec
//RELIEVO::Include(extensions.glsl)
//RELIEVO::Defines
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The renderer's lights at each pixel whose VTK shader has left them out, computed by VTK's
// formulas.
//
// Defines, by vtkRelievoDeferredStage: VTK's declarations of its lights, and RELIEVO_LIGHTS, a list
// of RELIEVO_HEADLIGHT(color, number), RELIEVO_SUN(color, direction, number) or RELIEVO_LAMP(color,
// direction, place, attenuation, positional, exponent, cone, number), where number counts the
// renderer's lights, switched-off lights included. RELIEVO_SHADOW_NUMBERS: the number of lights, if
// some cast shadows. RELIEVO_PBR_SUNS_AT_PLACES: VTK's PBR treats a sun among lamps as a lamp at
// the sun's position.
//RELIEVO::Include(gbuffer/read.glsl)
//RELIEVO::Include(formulas/geometry/unproject.glsl)
//RELIEVO::Include(formulas/light/shading.glsl)
in vec2 texCoord;
uniform vec2 relievoSize; // of the viewport
uniform mat4 relievoProjection;
#if defined(RELIEVO_SHADOW_NUMBERS) && defined(RELIEVO_SHADOW_WORD)
uniform float relievoShadowStrengths[RELIEVO_SHADOW_NUMBERS];
#endif

ivec2 relievoPixel = ivec2(0);
relievoSurface relievoLit = relievoNoSurface;
vec3 relievoPlaceVC = vec3(0.0);
vec3 relievoNormalVC = vec3(0.0);
vec3 relievoToEyeVC = vec3(0.0);
vec3 relievoDiffuseLight = vec3(0.0); // Phong; for PBR the whole reflection
vec3 relievoSpecularLight = vec3(0.0);

// The unshadowed share of the light at the pixel.
float relievoUnshadowed(int number)
{
#if defined(RELIEVO_SHADOW_NUMBERS) && defined(RELIEVO_SHADOW_WORD)
  return 1.0 -
    relievoShadowStrengths[number] * (1.0 - relievoFetchVisibility(relievoPixel, number));
#else
  return 1.0;
#endif
}

// Light that travels along `direction`; `share` by distance and cone.
void relievoAddLight(vec3 color, vec3 direction, float share, int number)
{
  vec3 light = color * relievoUnshadowed(number);
  if (relievoLit.shading == RELIEVO_SHADING_PBR)
  {
    relievoDiffuseLight += light * share *
      relievoPbr(relievoLit.color, relievoLit.metallic, relievoLit.roughness, relievoNormalVC,
        -direction, relievoToEyeVC);
    return;
  }
  float cosine = dot(relievoNormalVC, -direction);
  if (cosine > 0.0)
  {
    relievoDiffuseLight += light * (share * cosine);
#ifdef RELIEVO_SURFACE_SPECULAR_WORD
    relievoSpecularLight += light *
      (share * relievoPhongHighlight(
        relievoNormalVC, direction, relievoToEyeVC, relievoLit.power));
#endif
  }
}

// A light at the eye. For PBR it comes from the eye, for Phong along the view direction; surfaces
// turned away from the view keep VTK's small remainder.
void relievoAddHeadlight(vec3 color, int number)
{
  if (relievoLit.shading == RELIEVO_SHADING_PBR)
  {
    relievoAddLight(color, -relievoToEyeVC, 1.0, number);
    return;
  }
  vec3 light = color * relievoUnshadowed(number);
  float cosine = max(0.000001, relievoNormalVC.z);
  relievoDiffuseLight += light * cosine;
  relievoSpecularLight += light * pow(cosine, relievoLit.power);
}

void relievoAddLamp(vec3 color, vec3 direction, vec3 place, vec3 attenuation, int positional,
  float exponent, float cone, int number)
{
  vec3 fromLamp = relievoPlaceVC - place;
  float range = length(fromLamp);
  fromLamp /= range;
  if (positional == 0)
  {
#ifdef RELIEVO_PBR_SUNS_AT_PLACES
    bool atPlace = relievoLit.shading == RELIEVO_SHADING_PBR;
#else
    bool atPlace = false;
#endif
    relievoAddLight(color, atPlace ? fromLamp : direction, 1.0, number);
    return;
  }
  float share = 1.0 / (attenuation.x + range * (attenuation.y + range * attenuation.z));
  if (cone < 90.0)
  {
    float off = dot(fromLamp, direction);
    share = off >= cos(radians(cone)) ? share * pow(off, exponent) : 0.0;
  }
  relievoAddLight(color, fromLamp, share, number);
}

#define RELIEVO_HEADLIGHT(color, number) relievoAddHeadlight(color, number);
#define RELIEVO_SUN(color, direction, number) relievoAddLight(color, direction, 1.0, number);
#define RELIEVO_LAMP(color, direction, place, attenuation, positional, exponent, cone, number) \
  relievoAddLamp(color, direction, place, attenuation, positional, exponent, cone, number);

void main()
{
  relievoPixel = ivec2(floor(texCoord * relievoSize));
  relievoLit = relievoFetchSurface(relievoPixel);
  if (!relievoLit.deferred)
  {
    discard;
  }
  float depth = relievoFetchDepth(relievoPixel);
  vec2 place = relievoNdcFromPixel(vec2(relievoPixel), relievoSize);
  relievoPlaceVC = relievoEyePosition(place, depth, relievoProjection);
  relievoNormalVC = relievoFetchNormal(relievoPixel);
  // VTK's shaders use the direction to the origin as the direction to the eye, in parallel views
  // too.
  relievoToEyeVC = normalize(-relievoPlaceVC);
  RELIEVO_LIGHTS
  vec3 color = relievoLit.diffuse * relievoLit.color * relievoDiffuseLight +
    relievoLit.specular * relievoSpecularLight;
  if (relievoLit.shading == RELIEVO_SHADING_PBR)
  {
    color = pow(relievoDiffuseLight, vec3(1.0 / 2.2));
  }
  gl_FragData[0] = vec4(color, 0.0);
}
