// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// What the delegate drew, as VTK makes it for display, and its window z.
uniform sampler2D relievoDrawn;
uniform sampler2D relievoDrawnZ;
uniform ivec2 relievoDrawnOffset; // of the viewport within both
