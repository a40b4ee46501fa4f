//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The rectangle of one lamp, an instance each, at the front of its sphere.
//RELIEVO::Include(deferred/occlusion.glsl)
uniform samplerBuffer relievoLamps;
uniform samplerBuffer relievoRectangles; // NDC: x0, y0, x1, y1
uniform float relievoNear;
uniform float relievoFar;
flat out int relievoLamp;

void main()
{
  vec4 rectangle = texelFetch(relievoRectangles, gl_InstanceID);
  vec4 place = texelFetch(relievoLamps, 2 * gl_InstanceID);
  relievoLamp = gl_InstanceID;
  float front = -place.z - place.w;
  gl_Position = vec4((gl_VertexID & 1) == 0 ? rectangle.x : rectangle.z,
    gl_VertexID < 2 ? rectangle.y : rectangle.w,
    2.0 * relievoLampFrontZ(front, relievoNear, relievoFar) - 1.0, 1.0);
}
