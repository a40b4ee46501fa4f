//VTK::System::Dec
//RELIEVO::Include(extensions.glsl)
//RELIEVO::Defines
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The depth of a volume, for the least of several; nothing where it has none.
in vec2 texCoord;
uniform vec2 relievoSize;
uniform sampler2D relievoVolumeTexels; // z: depth; w: 1 where there is one (layers.glsl)

void main()
{
  vec4 place = texelFetch(relievoVolumeTexels, ivec2(floor(texCoord * relievoSize)), 0);
  if (place.w == 0.0)
  {
    discard;
  }
  gl_FragData[0] = vec4(place.z);
}
