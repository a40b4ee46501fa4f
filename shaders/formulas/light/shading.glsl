// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// A surface's reflection of a light, by VTK's formulas. Directions are unit vectors.

// Phong's highlight: a light that comes along fromLight, mirrored towards the eye.
float relievoPhongHighlight(vec3 normal, vec3 fromLight, vec3 toEye, float power)
{
  vec3 mirrored = fromLight - float(2.0) * dot(normal, fromLight) * normal;
  return pow(max(float(0.0), dot(mirrored, toEye)), power);
}

// Share of microfacets that face halfway: Trowbridge and Reitz 1975, GGX; alpha is roughness^2.
float relievoGgx(float nDotH, float roughness)
{
  float a = roughness * roughness;
  float d = (nDotH * a * a - nDotH) * nDotH + float(1.0);
  return a * a / (float(3.14159265358979) * d * d);
}

// Smith's masking and shadowing, height-correlated (E. Heitz 2014), over 4 n.v n.l. VTK uses
// roughness itself as alpha here.
float relievoSmith(float nDotV, float nDotL, float roughness)
{
  float a2 = roughness * roughness;
  float v = nDotL * sqrt(a2 + nDotV * (nDotV - a2 * nDotV));
  float l = nDotV * sqrt(a2 + nDotL * (nDotL - a2 * nDotL));
  return float(0.5) / (v + l);
}

// Reflected radiance of VTK's PBR for a light of radiance 1: (diffuse + specular) n.l, with an
// index of refraction of 1.5, C. Schlick's Fresnel term (1994) and no edge tint.
vec3 relievoPbr(
  vec3 albedo, float metallic, float roughness, vec3 normal, vec3 toLight, vec3 toEye)
{
  vec3 sum = toLight + toEye;
  vec3 halfway = sum / max(length(sum), float(1e-6));
  float nDotV = clamp(dot(normal, toEye), float(1e-5), float(1.0));
  float nDotL = clamp(dot(normal, toLight), float(1e-5), float(1.0));
  float nDotH = clamp(dot(normal, halfway), float(1e-5), float(1.0));
  float hDotL = clamp(dot(halfway, toLight), float(1e-5), float(1.0));
  vec3 f0 = mix(vec3(float(0.04)), albedo, metallic);
  float rim = clamp((f0.x + f0.y + f0.z) * float(16.5), float(0.0), float(1.0));
  vec3 f90 = mix(vec3(rim), vec3(float(1.0)), metallic);
  vec3 fresnel = f0 + (f90 - f0) * pow(float(1.0) - hDotL, float(5.0));
  vec3 diffuse =
    (vec3(float(1.0)) - fresnel) * albedo * ((float(1.0) - metallic) / float(3.14159265358979));
  float specular = relievoGgx(nDotH, roughness) * relievoSmith(nDotV, nDotL, roughness);
  return (diffuse + specular * fresnel) * nDotL;
}
