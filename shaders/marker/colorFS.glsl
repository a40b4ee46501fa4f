//VTK::System::Dec
//RELIEVO::Include(extensions.glsl)
//RELIEVO::Defines
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// All markers of a pixel, premultiplied, to be blended over the linear colour.
in vec2 texCoord;
uniform vec2 relievoSize;
uniform sampler2D markersOver;

void main()
{
  vec4 over = texelFetch(markersOver, ivec2(floor(texCoord * relievoSize)), 0);
  if (!(over.a > 0.0))
  {
    discard;
  }
  gl_FragData[0] = over;
}
