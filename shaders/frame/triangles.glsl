// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Recognizes shaders of VTK's mappers for which triangles can be left out (texts).

// In vertex shaders that draw the mesh's own points.
//RELIEVO::Section(Position)
gl_Position = MCDCMatrix * vertexMC;

// In those that move the points first.
//RELIEVO::Section(Moved)
#define vertexMC

// In shaders that number triangles.
//RELIEVO::Section(Number)
gl_PrimitiveID
