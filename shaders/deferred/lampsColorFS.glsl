//VTK::System::Dec
//RELIEVO::Include(extensions.glsl)
//RELIEVO::Defines
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The lamps' addition to the linear colour: their light times the surface's colour, and the gloss.
//RELIEVO::Include(gbuffer/read.glsl)
//RELIEVO::Include(deferred/light.glsl)
//RELIEVO::Include(deferred/matte.glsl)
in vec2 texCoord;
uniform vec2 relievoSize;
#ifdef RELIEVO_GLOSS
uniform sampler2D relievoGlossSum;
#endif

void main()
{
  ivec2 pixel = ivec2(floor(texCoord * relievoSize));
  vec3 sum = relievoMatte(relievoFetchSurface(pixel)) * relievoFetchLight(pixel);
#ifdef RELIEVO_GLOSS
  sum += texelFetch(relievoGlossSum, pixel, 0).rgb;
#endif
  gl_FragData[0] = vec4(sum, 0.0);
}
