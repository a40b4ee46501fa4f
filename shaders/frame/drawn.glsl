// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The delegate's drawing, in VTK's display colours, and its window z.
uniform sampler2D relievoDrawn;
uniform sampler2D relievoDrawnZ;
uniform ivec2 relievoDrawnOffset; // of the viewport in both textures
