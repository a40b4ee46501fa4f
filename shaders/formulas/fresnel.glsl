// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The share of light that a surface mirrors.

// The share of light that is mirrored at this cosine between view and normal, from the share at
// normal incidence: C. Schlick, An Inexpensive BRDF Model for Physically-based Rendering, Computer
// Graphics Forum 13(3), 1994.
// A rough surface mirrors less at grazing angles, because its facets are tilted: the limit of 1
// becomes 1 - roughness, if that is more than the share at normal incidence (S. Lagarde, Adopting a
// physically based shading model, 2011). With roughness 0 it is Schlick's formula.
float relievoFresnel(float straight, float cosine, float roughness)
{
  float grazing = max(float(1.0) - roughness, straight);
  float rest = float(1.0) - clamp(cosine, float(0.0), float(1.0));
  float square = rest * rest;
  return straight + (grazing - straight) * (square * square * rest);
}
