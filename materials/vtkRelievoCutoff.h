// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Surfaces that are left out below a cutoff in opacity and opaque elsewhere: text in VTK's shaders,
// and what the actor tells VTK and other passes of it.
#ifndef vtkRelievoCutoff_h
#define vtkRelievoCutoff_h

#include <string>

class vtkActor;

namespace vtkRelievoCutoff
{
void Mark(std::string& fragment);

// Returns what is missing, or nothing.
std::string Fill(std::string& fragment);

// The actor is drawn with this cutoff, 0: without one; it is then as opaque as it was before.
void Tell(vtkActor* actor, double cutoff);
}

#endif
