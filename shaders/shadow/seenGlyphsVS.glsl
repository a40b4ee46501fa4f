//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Positions glyphs like VTK's own shaders, bit for bit.
in vec4 vertexMC;
uniform mat4 MCDCMatrix;
uniform mat4 MCVCMatrix;
uniform samplerBuffer relievoGlyphs; // columns of their matrices, to the actor's coordinates
out vec4 vertexVCVSOutput;
invariant gl_Position;

void main()
{
  int first = 4 * gl_InstanceID;
  mat4 place = mat4(texelFetch(relievoGlyphs, first), texelFetch(relievoGlyphs, first + 1),
    texelFetch(relievoGlyphs, first + 2), texelFetch(relievoGlyphs, first + 3));
  vec4 vertex = place * vertexMC;
  vertexVCVSOutput = MCVCMatrix * vertex;
  gl_Position = MCDCMatrix * vertex;
}
