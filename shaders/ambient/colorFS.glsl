//VTK::System::Dec
//RELIEVO::Include(extensions.glsl)
//RELIEVO::Defines
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The factors by which the linear colour is multiplied: casting lights, whose light the scene
// already blocks in shadows, are not darkened.
//RELIEVO::Include(gbuffer/read.glsl)
in vec2 texCoord;
uniform vec2 relievoSize;
uniform sampler2D ambientShare;
uniform float ambientStrength;

void main()
{
  ivec2 pixel = ivec2(floor(texCoord * relievoSize));
  float hidden = ambientStrength * (1.0 - texelFetch(ambientShare, pixel, 0).x);
#ifdef RELIEVO_DIRECT_LIGHT_WORD
  vec3 direct = relievoFetchDirectLight(pixel);
#else
  vec3 direct = vec3(0.0);
#endif
  gl_FragData[0] = vec4(1.0 - hidden * (1.0 - direct), 1.0);
}
