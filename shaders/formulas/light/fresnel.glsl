// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Fresnel reflection of a surface.

// The reflected share of light at this cosine between view and normal, from the share at normal
// incidence: C. Schlick, An Inexpensive BRDF Model for Physically-based Rendering, Computer
// Graphics Forum 13(3), 1994.
// A rough surface reflects less at grazing angles, because its facets are tilted: the limit of 1
// becomes 1 - roughness, if that exceeds the share at normal incidence (S. Lagarde, Adopting a
// physically based shading model, 2011). With roughness 0 this is Schlick's formula.
float relievoFresnel(float straight, float cosine, float roughness)
{
  float grazing = max(float(1.0) - roughness, straight);
  float rest = float(1.0) - clamp(cosine, float(0.0), float(1.0));
  float square = rest * rest;
  return straight + (grazing - straight) * (square * square * rest);
}
