//VTK::System::Dec
//RELIEVO::Include(extensions.glsl)
//RELIEVO::Defines
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Window z of the visible surface, at which VTK ends the rays through volumes.
//RELIEVO::Include(formulas/formats/depth.glsl)
//RELIEVO::Include(gbuffer/read.glsl)
in vec2 texCoord;
uniform vec2 relievoSize;

void main()
{
  float depth = relievoFetchDepth(ivec2(floor(texCoord * relievoSize)));
  float z = relievoParallel != 0 ? relievoParallelWindowZ(depth, relievoNear, relievoFar)
                                 : relievoPerspectiveWindowZ(depth, relievoNear, relievoFar);
  gl_FragDepth = isinf(depth) ? 1.0 : clamp(z, 0.0, 1.0);
}
