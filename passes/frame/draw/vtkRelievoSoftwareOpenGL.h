// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkRelievoSoftwareOpenGL_h
#define vtkRelievoSoftwareOpenGL_h

#include "vtkRelievoFrameModule.h" // for the export macro

// Whether the current OpenGL draws with the processor (Mesa's llvmpipe and softpipe).
VTKRELIEVOFRAME_EXPORT bool vtkRelievoIsSoftwareOpenGL();

#endif
