// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The linear colour of the frame, premultiplied; pixel (0, 0) is the viewport's lower left one.
uniform sampler2D relievoColor;

vec4 relievoFetchColor(ivec2 pixel)
{
  return texelFetch(relievoColor, pixel, 0);
}
