// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Eye-space position for primitives that VTK draws without light, and so without vertexVC; for all
// splices. RELIEVO_VERTEX_MC: VTK's name of the vertex, model coordinates (vec4); filled by
// vtkRelievoSpliceText.

//RELIEVO::Section(VertexDec)
uniform mat4 MCVCMatrix;
out vec4 vertexVCVSOutput;

//RELIEVO::Section(VertexImpl)
  vertexVCVSOutput = MCVCMatrix * RELIEVO_VERTEX_MC;

//RELIEVO::Section(GeometryDec)
in vec4 vertexVCVSOutput[];
out vec4 vertexVCGSOutput;

//RELIEVO::Section(GeometryImpl)
  vertexVCGSOutput = vertexVCVSOutput[i];

//RELIEVO::Section(FragmentDec)
in vec4 vertexVCVSOutput;

//RELIEVO::Section(FragmentImpl)
  vec4 vertexVC = vertexVCVSOutput;
