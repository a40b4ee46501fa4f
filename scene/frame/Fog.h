// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Fog_h
#define Fog_h

#include "FogOptions.h"

#include "vtkSmartPointer.h"

#include <vector>

class vtkRelievoFogSpheres;
class vtkRelievoPass;

namespace scene
{
class Progress;

/// The points of each file as spheres of fog. Throws WorkError with the file's name: what cannot be
/// read, arrays that do not fit, files without a point that is a sphere of fog.
std::vector<vtkSmartPointer<vtkRelievoFogSpheres>> ReadFogs(
  const std::vector<FogChoice>& choices, Progress& progress);

/// Puts the fog into the frame.
void AddFogs(vtkRelievoPass* pass, const std::vector<FogChoice>& choices,
  const std::vector<vtkSmartPointer<vtkRelievoFogSpheres>>& fogs);
}

#endif
