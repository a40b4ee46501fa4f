// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Point normals for surfaces that VTK draws without light; named and oriented as in VTK's shaders.

//RELIEVO::Section(VertexDec)
in vec3 normalMC;
uniform mat3 normalMatrix;
out vec3 normalVCVSOutput;

//RELIEVO::Section(VertexImpl)
  normalVCVSOutput = normalMatrix * normalMC;

//RELIEVO::Section(GeometryDec)
in vec3 normalVCVSOutput[];
out vec3 normalVCGSOutput;

//RELIEVO::Section(GeometryImpl)
  normalVCGSOutput = normalVCVSOutput[i];

//RELIEVO::Section(FragmentDec)
in vec3 normalVCVSOutput;

//RELIEVO::Section(FragmentImpl)
  vec3 normalVCVSOutput = normalize(normalVCVSOutput);
  if (gl_FrontFacing == false)
  {
    normalVCVSOutput = -normalVCVSOutput;
  }
