// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// A colour for an id, so that neighbouring ids differ visibly; for debug views.

// Mixes all bits of a word into all others; different words have different hashes. The multipliers
// are C. Wellons' "lowbias32" (nullprogram.com, 2018).
uint relievoHash(uint word)
{
  word = (word ^ (word >> uint(16))) * 0x7feb352du;
  word = (word ^ (word >> uint(15))) * 0x846ca68bu;
  return word ^ (word >> uint(16));
}

// RGB in [0, 1] (display values): any hue, saturation 0.45 to 0.85, value 0.7 to 1. The id -1
// (0xffffffff, background) is black.
vec3 relievoHashColor(uint id)
{
  if (id == 0xffffffffu)
  {
    return vec3(float(0.0), float(0.0), float(0.0));
  }
  uint hash = relievoHash(id);
  float hue = float(hash & uint(65535)) * (float(6.0) / float(65536.0));
  float saturation =
    float(0.45) + float((hash >> uint(16)) & uint(255)) * (float(0.4) / float(255.0));
  float value = float(0.7) + float(hash >> uint(24)) * (float(0.3) / float(255.0));
  vec3 ramp = vec3(abs(hue - float(3.0)) - float(1.0), float(2.0) - abs(hue - float(2.0)),
    float(2.0) - abs(hue - float(4.0)));
  vec3 pure = clamp(ramp, float(0.0), float(1.0));
  return value * (vec3(float(1.0), float(1.0), float(1.0)) * (float(1.0) - saturation) +
    pure * saturation);
}
