// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Depth of the nearest translucent surface; pixel (0, 0) is the viewport's lower left one.
//RELIEVO::Include(formulas/formats/depth.glsl)
#ifdef RELIEVO_TRANSLUCENT_DEPTH
uniform sampler2D relievoTranslucentZ;
uniform vec3 relievoTranslucentRange; // near, far, 1 if parallel

// World units; +infinity without a translucent surface.
float relievoFetchTranslucentDepth(ivec2 pixel)
{
  float z = texelFetch(relievoTranslucentZ, pixel, 0).r;
  float zNear = relievoTranslucentRange.x;
  float zFar = relievoTranslucentRange.y;
  return z >= 1.0 ? relievoInfinity()
    : relievoTranslucentRange.z != 0.0 ? relievoParallelDepth(z, zNear, zFar)
                                       : relievoPerspectiveDepth(z, zNear, zFar);
}
#endif
