// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// A depth to begin with, for shaders of VTK's that ask for the slope of gl_FragDepth before they
// write it.

//RELIEVO::Section(UniformFlow)
  gl_FragDepth = gl_FragCoord.z;
