//VTK::System::Dec
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Writes depth only.

void main()
{
  gl_FragData[0] = vec4(0.0);
}
