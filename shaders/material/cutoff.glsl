// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Spliced into VTK's fragment shaders by vtkRelievoMaterial: what is below a cutoff in opacity is
// left out, all else is opaque. What it shares with other splices: splice/contract.glsl.

//RELIEVO::Section(Defines)
#undef RELIEVO_ALPHA
#define RELIEVO_ALPHA(alpha) 1.0

//RELIEVO::Section(FragmentDec)
uniform float relievoAlphaCutoff; // above 0

//RELIEVO::Section(FragmentImpl)
  // Behind VTK's colours, lights and textures, which have put all parts of the opacity together.
  if (gl_FragData[0].a < relievoAlphaCutoff)
  {
    discard;
  }
  gl_FragData[0].a = 1.0;
