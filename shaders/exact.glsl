// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// For formulas that rely on exact rounding: RELIEVO_EXACT before a variable forbids the compiler to
// rearrange its computation. Comes after extensions.glsl. Needs GLSL 4.00; without it nothing
// forbids the rearrangement.
#extension GL_ARB_gpu_shader5 : enable
#ifdef GL_ARB_gpu_shader5
#define RELIEVO_EXACT precise
#endif
