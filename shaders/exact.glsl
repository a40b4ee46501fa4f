// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// For formulas that count on each rounding: before a variable, RELIEVO_EXACT forbids that what it is
// computed from is rearranged. Comes after extensions.glsl. GLSL 4.00; without it nothing forbids it.
#extension GL_ARB_gpu_shader5 : enable
#ifdef GL_ARB_gpu_shader5
#define RELIEVO_EXACT precise
#endif
