// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// How much of the light a surface mirrors.

// Share of the light that is mirrored where the view meets the normal at this cosine, from what is
// mirrored straight from above: C. Schlick, An Inexpensive BRDF Model for Physically-based
// Rendering, Computer Graphics Forum 13(3), 1994.
// A rough surface mirrors less at grazing angles, for its facets are turned away: there, 1 becomes
// 1 - roughness, if that is more than straight from above (S. Lagarde, Adopting a physically based
// shading model, 2011). With roughness 0 it is Schlick's own.
float relievoFresnel(float straight, float cosine, float roughness)
{
  float grazing = max(float(1.0) - roughness, straight);
  float rest = float(1.0) - clamp(cosine, float(0.0), float(1.0));
  float square = rest * rest;
  return straight + (grazing - straight) * (square * square * rest);
}
