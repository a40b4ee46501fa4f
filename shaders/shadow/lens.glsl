// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Spliced into VTK's vertex shaders if a user's replacement modifies VTK's gl_Position, as for the
// distortion of a camera's lens: maps are drawn without the modification.

// Detects such a text: VTK's position without an assignment after it (a regular expression).
//RELIEVO::Section(Use)
gl_Position(\s*(\.\w+|\[[^\]]*\]))*\s*([-+*/]?=(?!=))?

//RELIEVO::Section(Dec)
uniform int relievoFromLight; // 1 while a light's map is drawn

//RELIEVO::Section(Keep)
  vec4 relievoUndistorted = gl_Position;

//RELIEVO::Section(Impl)
  if (relievoFromLight > 0)
  {
    gl_Position = relievoUndistorted;
  }
