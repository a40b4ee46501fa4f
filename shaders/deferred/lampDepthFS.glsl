//VTK::System::Dec
//RELIEVO::Include(extensions.glsl)
//RELIEVO::Defines
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The surfaces' window z for the rectangles of lamps.
//RELIEVO::Include(gbuffer/read.glsl)
//RELIEVO::Include(deferred/occlusion.glsl)
in vec2 texCoord;
uniform vec2 relievoSize;

void main()
{
  gl_FragData[0] = vec4(0.0);
  gl_FragDepth = relievoLampSurfaceZ(
    relievoFetchDepth(ivec2(floor(texCoord * relievoSize))), relievoNear, relievoFar);
}
