// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Spliced into VTK's fragment shaders by vtkRelievoMaterial: discards fragments below a cutoff in
// opacity, and makes the others opaque. Names shared with other splices: splice/contract.glsl.

//RELIEVO::Section(Defines)
#undef RELIEVO_ALPHA
#define RELIEVO_ALPHA(alpha) 1.0

//RELIEVO::Section(FragmentDec)
uniform float relievoAlphaCutoff; // above 0

//RELIEVO::Section(FragmentImpl)
  // After VTK's colours, lights and textures, which have combined all factors of the opacity.
  if (gl_FragData[0].a < relievoAlphaCutoff)
  {
    discard;
  }
  gl_FragData[0].a = 1.0;
