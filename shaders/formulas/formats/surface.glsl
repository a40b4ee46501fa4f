// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// A surface's lighting properties, packed in words of 32 bits. Floats become int before uint, for
// which processors have an instruction.

const float relievoMostSpecularPower = float(128.0); // the limit of vtkProperty

// A colour of 0 to 1 in 10, 10 and 9 bits, and a kind of 0 to 7. Linear colours are packed by their
// square roots, which preserves the digits of dark ones.
uint relievoPackSurfaceColor(vec3 color, uint kind)
{
  uint red = uint(int(clamp(color.x, float(0.0), float(1.0)) * float(1023.0) + float(0.5)));
  uint green = uint(int(clamp(color.y, float(0.0), float(1.0)) * float(1023.0) + float(0.5)));
  uint blue = uint(int(clamp(color.z, float(0.0), float(1.0)) * float(511.0) + float(0.5)));
  return red | (green << uint(10)) | (blue << uint(20)) | (kind << uint(29));
}

vec3 relievoUnpackSurfaceColor(uint word)
{
  return vec3(float(word & 0x3ffu) / float(1023.0),
    float((word >> uint(10)) & 0x3ffu) / float(1023.0),
    float((word >> uint(20)) & 0x1ffu) / float(511.0));
}

uint relievoUnpackSurfaceKind(uint word)
{
  return word >> uint(29);
}

// Two numbers of 0 to 1 in 16 bits each.
uint relievoPackUnorm16(vec2 v)
{
  uint x = uint(int(clamp(v.x, float(0.0), float(1.0)) * float(65535.0) + float(0.5)));
  uint y = uint(int(clamp(v.y, float(0.0), float(1.0)) * float(65535.0) + float(0.5)));
  return x | (y << uint(16));
}

vec2 relievoUnpackUnorm16(uint word)
{
  return vec2(float(word & 0xffffu), float(word >> uint(16))) / float(65535.0);
}
