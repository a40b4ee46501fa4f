//VTK::System::Dec
//RELIEVO::Include(extensions.glsl)
//RELIEVO::Defines
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// A translucent layer of the delegate, over the colour, blended in display values as by VTK. Alpha
// is the cover, even if VTK leaves another value, see relievoAveragedCover.
//RELIEVO::Include(formulas/formats/half.glsl)
//RELIEVO::Include(frame/color.glsl)
//RELIEVO::Include(frame/layer.glsl)
in vec2 texCoord;
uniform vec2 relievoSize;

void main()
{
  ivec2 pixel = ivec2(floor(texCoord * relievoSize));
  vec4 color = relievoFetchColor(pixel);
  vec4 layer = relievoFetchLayer(pixel);
  if (layer != vec4(0.0))
  {
    vec4 drawn = relievoOver(layer, vec4(relievoSrgbColorFromLinear(color.rgb), color.a));
    color = vec4(relievoLinearColorFromSrgb(drawn.rgb), drawn.a);
  }
  gl_FragData[0] = vec4(relievoRoundToHalf(color.r), relievoRoundToHalf(color.g),
    relievoRoundToHalf(color.b), relievoRoundToHalf(color.a));
}
