// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Compositing of premultiplied layers.
//RELIEVO::Include(formulas/color/srgb.glsl)

// Associative: (a over b) over c equals a over (b over c).
vec4 relievoOver(vec4 front, vec4 behind)
{
  return front + (float(1.0) - front.w) * behind;
}

// Premultiplied display colours to premultiplied linear light, without a limit. Where a layer
// shines, with more light than cover, it is converted as if its cover were as large as its light:
// towards a point's rim the cover fades faster than the light, and their quotient is unbounded.
vec4 relievoLinearLayerFromSrgb(vec4 layer, bool shines)
{
  float cover = layer.w;
  if (shines)
  {
    cover = max(max(layer.x, layer.y), max(layer.z, layer.w));
  }
  if (!(cover > float(0.0)))
  {
    return vec4(float(0.0), float(0.0), float(0.0), layer.w);
  }
  vec3 linear = cover *
    relievoLinearColorFromSrgb(vec3(layer.x / cover, layer.y / cover, layer.z / cover));
  return vec4(linear.x, linear.y, linear.z, layer.w);
}

// The cover of a layer whose alpha was -1 and was blended with a transmittance t by VTK's weighted
// average before 9.3: alpha becomes (1 - t) t + t alpha.
float relievoAveragedCover(float alpha)
{
  return float(1.0) - sqrt(max(-alpha, float(0.0)));
}
