// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Light transmitted by surfaces, as a share. With RELIEVO_SHADOW_COLORED: the shares of red, green
// and blue, and last the share without the surfaces' colours.
#ifdef RELIEVO_SHADOW_COLORED
#define RELIEVO_PASSES vec4
#define RELIEVO_PASSES_WHOLE(passes) (passes).w
#define RELIEVO_PASSES_OF_TEXEL(texel) (texel)
#define RELIEVO_PASSES_TEXEL(passes) (passes)
#else
#define RELIEVO_PASSES float
#define RELIEVO_PASSES_WHOLE(passes) (passes)
#define RELIEVO_PASSES_OF_TEXEL(texel) (texel).x
#define RELIEVO_PASSES_TEXEL(passes) vec4(passes, 0.0, 0.0, 0.0)
#endif
