//VTK::System::Dec
//RELIEVO::Include(extensions.glsl)
//RELIEVO::Defines
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The summand for a sum over samples: the linear colour; with RELIEVO_GATHERED_PLACE, the
// visibility of the light with that index among the stored ones; with RELIEVO_GATHERED_TEXTURE, a
// stage's texture, whose sampler is RELIEVO_GATHERED.
#ifdef RELIEVO_GATHERED_TEXTURE
uniform sampler2D RELIEVO_GATHERED;
#elif defined(RELIEVO_GATHERED_PLACE)
//RELIEVO::Include(gbuffer/read.glsl)
#else
//RELIEVO::Include(frame/color.glsl)
#endif
in vec2 texCoord;
uniform vec2 relievoSize;

void main()
{
  ivec2 pixel = ivec2(floor(texCoord * relievoSize));
#ifdef RELIEVO_GATHERED_TEXTURE
  gl_FragData[0] = texelFetch(RELIEVO_GATHERED, pixel, 0);
#elif defined(RELIEVO_GATHERED_PLACE)
  gl_FragData[0] = vec4(relievoFetchVisibility(pixel, RELIEVO_GATHERED_PLACE));
#else
  gl_FragData[0] = relievoFetchColor(pixel);
#endif
}
