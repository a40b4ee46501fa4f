//VTK::System::Dec
//RELIEVO::Defines
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The rectangle of each lamp, one per instance, at the front of its sphere. RELIEVO_LAMP_SHADOWS:
// only the lamp selected by a uniform.
//RELIEVO::Include(deferred/occlusion.glsl)
uniform samplerBuffer relievoLamps;
uniform samplerBuffer relievoRectangles; // NDC: x0, y0, x1, y1
uniform float relievoNear;
uniform float relievoFar;
#ifdef RELIEVO_LAMP_SHADOWS
uniform int relievoCastingLamp;
#define RELIEVO_LAMP relievoCastingLamp
#else
#define RELIEVO_LAMP gl_InstanceID
#endif
flat out int relievoLamp;

void main()
{
  vec4 rectangle = texelFetch(relievoRectangles, RELIEVO_LAMP);
  vec4 place = texelFetch(relievoLamps, 2 * RELIEVO_LAMP);
  relievoLamp = RELIEVO_LAMP;
  float front = -place.z - place.w;
  gl_Position = vec4((gl_VertexID & 1) == 0 ? rectangle.x : rectangle.z,
    gl_VertexID < 2 ? rectangle.y : rectangle.w,
    2.0 * relievoLampFrontZ(front, relievoNear, relievoFar) - 1.0, 1.0);
}
