//VTK::System::Dec
//RELIEVO::Include(extensions.glsl)
//RELIEVO::Defines
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The fog of a pixel, premultiplied, to be blended over the linear colour.
//RELIEVO::Include(formulas/fog.glsl)
in vec2 texCoord;
uniform vec2 relievoSize;
uniform sampler2D fogDepth; // colour times optical depth, optical depth

void main()
{
  vec4 fog = texelFetch(fogDepth, ivec2(floor(texCoord * relievoSize)), 0);
  if (!(fog.a > 0.0))
  {
    discard;
  }
  gl_FragData[0] = relievoFogShare(fog.a) * fog;
}
