//VTK::System::Dec
//RELIEVO::Include(extensions.glsl)
//RELIEVO::Defines
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Composites the translucent layer over the colour.
//RELIEVO::Include(formulas/formats/half.glsl)
//RELIEVO::Include(formulas/color/blend.glsl)
//RELIEVO::Include(frame/color.glsl)
in vec2 texCoord;
uniform vec2 relievoSize;
uniform sampler2D blendLayer;

void main()
{
  ivec2 pixel = ivec2(floor(texCoord * relievoSize));
  vec4 color = relievoOver(texelFetch(blendLayer, pixel, 0), relievoFetchColor(pixel));
  gl_FragData[0] = vec4(relievoRoundToHalf(color.r), relievoRoundToHalf(color.g),
    relievoRoundToHalf(color.b), relievoRoundToHalf(color.a));
}
