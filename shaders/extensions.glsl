// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Extensions that formulas/ needs beyond GLSL 1.50; comes right after the #version line.
// floatBitsToUint, uintBitsToFloat: GLSL 3.30.
#extension GL_ARB_shader_bit_encoding : enable
// packHalf2x16, unpackHalf2x16: GLSL 4.20.
#extension GL_ARB_shading_language_packing : enable
