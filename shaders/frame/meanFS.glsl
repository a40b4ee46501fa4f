//VTK::System::Dec
//RELIEVO::Include(extensions.glsl)
//RELIEVO::Defines
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The linear colour as the mean of the gathered samples.
//RELIEVO::Include(formulas/formats/half.glsl)
in vec2 texCoord;
uniform vec2 relievoSize;
uniform sampler2D relievoGathered;
uniform float relievoCount;

void main()
{
  vec4 mean = texelFetch(relievoGathered, ivec2(floor(texCoord * relievoSize)), 0) / relievoCount;
  gl_FragData[0] = vec4(relievoRoundToHalf(mean.r), relievoRoundToHalf(mean.g),
    relievoRoundToHalf(mean.b), relievoRoundToHalf(mean.a));
}
