// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The layer volume_depth; pixel (0, 0) is the viewport's lower left one.
#ifdef RELIEVO_VOLUME_DEPTH
uniform sampler2D relievoVolumeDepths;

// World units; +infinity without a volume.
float relievoFetchVolumeDepth(ivec2 pixel)
{
  return texelFetch(relievoVolumeDepths, pixel, 0).r;
}
#endif
