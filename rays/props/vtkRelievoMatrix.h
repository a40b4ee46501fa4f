// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// VTK's matrices for GLM.
#ifndef vtkRelievoMatrix_h
#define vtkRelievoMatrix_h

#include "vtkRelievoRaysModule.h" // for the export macro

#include <glm/mat4x4.hpp>

class vtkMatrix4x4;

// Column-major, as GLM has it.
VTKRELIEVORAYS_EXPORT glm::dmat4 vtkRelievoToGlm(vtkMatrix4x4* matrix);

// Whether places need a division by w behind it. VTK draws them where they are then, and lights
// them where they are without.
VTKRELIEVORAYS_EXPORT bool vtkRelievoIsProjective(vtkMatrix4x4* matrix);

// The most by which it stretches an axis.
VTKRELIEVORAYS_EXPORT double vtkRelievoGetScale(const glm::dmat4& matrix);

#endif
