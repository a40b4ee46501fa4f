//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The depth of a mesh, from a mapper's own vertex buffer.
in vec4 vertexMC;
uniform mat4 MCDCMatrix;

void main()
{
  gl_Position = MCDCMatrix * vertexMC;
}
