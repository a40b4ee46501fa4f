//VTK::System::Dec
//RELIEVO::Include(extensions.glsl)
//RELIEVO::Defines
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// A translucent layer of the delegate, in linear light.
//RELIEVO::Include(formulas/formats/half.glsl)
//RELIEVO::Include(frame/layer.glsl)
in vec2 texCoord;
uniform vec2 relievoSize;
uniform int relievoShines; // the layer may have more light than cover

void main()
{
  vec4 layer = relievoLinearLayerFromSrgb(
    relievoFetchLayer(ivec2(floor(texCoord * relievoSize))), relievoShines != 0);
  gl_FragData[0] = vec4(relievoRoundToHalf(layer.r), relievoRoundToHalf(layer.g),
    relievoRoundToHalf(layer.b), relievoRoundToHalf(layer.a));
}
