// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Of a prop whose shaders leave out what is too transparent: passes that draw or follow its mesh
// themselves ask for it.
#ifndef vtkRelievoCutSurface_h
#define vtkRelievoCutSurface_h

#include "vtkRelievoShadersModule.h" // for the export macro

class vtkInformation;
class vtkInformationDoubleKey;

namespace vtkRelievoCutSurface
{
// Among a prop's keys: the opacity, above 0, below which nothing is drawn.
VTKRELIEVOSHADERS_EXPORT vtkInformationDoubleKey* CUTOFF();

// Of a prop with these keys, which may be nullptr; 0: nothing is left out.
VTKRELIEVOSHADERS_EXPORT double GetCutoff(vtkInformation* keys);
}

#endif
