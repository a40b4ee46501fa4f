// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// An initial depth for VTK's shaders that read the slope of gl_FragDepth before they write it.

//RELIEVO::Section(UniformFlow)
  gl_FragDepth = gl_FragCoord.z;
