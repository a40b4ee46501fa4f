// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// For formulas that count on each rounding: before a variable, RELIEVO_EXACT forbids the compiler
// to rearrange what it is computed from. Comes after extensions.glsl. GLSL 4.00; nothing forbids it
// where that is missing.
#extension GL_ARB_gpu_shader5 : enable
#ifdef GL_ARB_gpu_shader5
#define RELIEVO_EXACT precise
#endif
