// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The opacity cutoff of props whose shaders discard fragments that are too transparent, for passes
// that draw or trace the mesh themselves.
#ifndef vtkRelievoCutSurface_h
#define vtkRelievoCutSurface_h

#include "vtkRelievoBaseModule.h" // for the export macro

class vtkInformation;
class vtkInformationDoubleKey;

namespace vtkRelievoCutSurface
{
// Key of a prop: the opacity, above 0, below which fragments are discarded.
VTKRELIEVOBASE_EXPORT vtkInformationDoubleKey* CUTOFF();

// The cutoff of a prop with these keys, which may be nullptr; 0: nothing is discarded.
VTKRELIEVOBASE_EXPORT double GetCutoff(vtkInformation* keys);
}

#endif
