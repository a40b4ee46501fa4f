// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Conversion of VTK's matrices to GLM.
#ifndef vtkRelievoMatrix_h
#define vtkRelievoMatrix_h

#include "vtkRelievoRaysModule.h" // for the export macro

#include <glm/mat4x4.hpp>

class vtkMatrix4x4;

// Column-major, the layout of GLM.
VTKRELIEVORAYS_EXPORT glm::dmat4 vtkRelievoToGlm(vtkMatrix4x4* matrix);

// Whether positions need a division by w after the transform. VTK draws them at the divided
// position, but lights them at the undivided one.
VTKRELIEVORAYS_EXPORT bool vtkRelievoIsProjective(vtkMatrix4x4* matrix);

// The largest factor by which the matrix stretches an axis.
VTKRELIEVORAYS_EXPORT double vtkRelievoGetScale(const glm::dmat4& matrix);

#endif
