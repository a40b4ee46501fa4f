// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Surfaces that are discarded below a cutoff in opacity and opaque elsewhere: text for VTK's
// shaders, and the actor's settings for VTK and other passes.
#ifndef vtkRelievoCutoff_h
#define vtkRelievoCutoff_h

#include <string>

class vtkActor;

namespace vtkRelievoCutoff
{
void Mark(std::string& fragment);

// Returns an error message, or an empty string.
std::string Fill(std::string& fragment);

// Sets the actor's cutoff; 0 removes it and restores the actor's former opacity.
void Tell(vtkActor* actor, double cutoff);
}

#endif
