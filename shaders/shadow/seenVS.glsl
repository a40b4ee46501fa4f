//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Positions a mesh like VTK's own shaders, bit for bit.
in vec4 vertexMC;
uniform mat4 MCDCMatrix;
uniform mat4 MCVCMatrix;
out vec4 vertexVCVSOutput;
invariant gl_Position;

void main()
{
  vertexVCVSOutput = MCVCMatrix * vertexMC;
  gl_Position = MCDCMatrix * vertexMC;
}
