// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Spliced into VTK's vertex shaders where a user's replacement goes on from VTK's gl_Position, as
// the distortion of a camera's lens does: what a light sees goes without.

// How such a text is known: VTK's position without an assignment behind it (a regular expression).
//RELIEVO::Section(Use)
gl_Position(\s*(\.\w+|\[[^\]]*\]))*\s*([-+*/]?=(?!=))?

//RELIEVO::Section(Dec)
uniform int relievoFromLight; // 1 while what a light sees is drawn

//RELIEVO::Section(Keep)
  vec4 relievoUndistorted = gl_Position;

//RELIEVO::Section(Impl)
  if (relievoFromLight != 0)
  {
    gl_Position = relievoUndistorted;
  }
