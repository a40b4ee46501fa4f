// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Depth from the delegate's z, with its precision (vtkRelievoFrameContext::GetDrawnDepthError);
// pixel (0, 0) is the viewport's lower left one.
//RELIEVO::Include(formulas/formats/depth.glsl)
//RELIEVO::Include(frame/drawn.glsl)
uniform vec3 relievoDrawnRange; // near, far, 1 if parallel

// World units; +infinity in the background.
float relievoFetchDrawnDepth(ivec2 pixel)
{
  float z = texelFetch(relievoDrawnZ, pixel + relievoDrawnOffset, 0).r;
  float zNear = relievoDrawnRange.x;
  float zFar = relievoDrawnRange.y;
  return z >= 1.0 ? relievoInfinity()
    : relievoDrawnRange.z != 0.0 ? relievoParallelDepth(z, zNear, zFar)
                                 : relievoPerspectiveDepth(z, zNear, zFar);
}
