// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// An environment reflected in a rough mirror: the levels of a prefiltered cube map.
// B. Karis: Real Shading in Unreal Engine 4, SIGGRAPH 2013 course (the split sum, normal = view);
// B. Walter, S. Marschner, H. Li, K. Torrance: Microfacet Models for Refraction through Rough
// Surfaces, EGSR 2007 (GGX).

// Weight of light that arrives at cosine x from the axis (normal = view = axis of reflection), for
// roughness in [0, 1]; the width of GGX's lobe is alpha = roughness^2. The weight is the
// distribution of half vectors times x without its constant factor, so weights have to be divided
// by their sum. cos^2 of the half vector's angle is (1 + x) / 2.
float relievoPrefilterWeight(float x, float roughness)
{
  float alpha = roughness * roughness;
  float alpha2 = alpha * alpha;
  // (1 + x) / 2 * (alpha^2 - 1) + 1, without the difference that loses small alphas at x = 1.
  float width = float(0.5) * ((float(1.0) - x) + alpha2 * (float(1.0) + x));
  return x > float(0.0) ? x / (width * width) : float(0.0);
}

// The level of a roughness in [0, 1], of `levels` levels: 0 is sharp, levels - 1 is roughness 1;
// fractions interpolate between two levels.
float relievoPrefilterLevel(float roughness, int levels)
{
  return clamp(roughness, float(0.0), float(1.0)) * float(levels - 1);
}

// The roughness of level `level` of `levels`.
float relievoPrefilterRoughness(int level, int levels)
{
  return levels > 1 ? float(level) / float(levels - 1) : float(0.0);
}
