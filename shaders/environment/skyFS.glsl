//VTK::System::Dec
//RELIEVO::Defines
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The environment as the background.
//RELIEVO::Include(environment/lookup.glsl)
in vec2 texCoord;
uniform mat3 relievoEnvironmentFromScreen; // transforms (x, y, 1), x and y from -1 to 1
uniform float relievoIntensity;

void main()
{
  vec3 direction = normalize(relievoEnvironmentFromScreen * vec3(2.0 * texCoord - 1.0, 1.0));
  float footprint = max(length(dFdx(direction)), length(dFdy(direction)));
  vec3 light = relievoIntensity * relievoEnvironmentLight(direction, footprint);
#ifdef RELIEVO_ENCODED
  light = pow(max(light, vec3(0.0)), vec3(1.0 / 2.2));
#endif
  gl_FragData[0] = vec4(light, 1.0);
}
