// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The record of a baseline: what drew the frame, as vtkRelievoBaseline describes it.
 */
#ifndef BaselineRecord_h
#define BaselineRecord_h

#include "SceneNames.h"

#include <map>
#include <set>
#include <string>

class vtkImageData;
class vtkRenderer;

namespace scene
{
/// Adds the record of the renderer's last frame to the field data of its image. `names` are those
/// of actors, by their indices in vtkRenderer::GetActors().
void AddRecord(vtkImageData* image, vtkRenderer* renderer, const std::map<int, std::string>& names);

/// Whether there are volumes, and the stage `volumes` can make their layers.
bool HasVolumeLayers(vtkRenderer* renderer);

/// The arrays that colour actors through a colour map; bytes are colours themselves.
std::set<std::string> FindColoringArrays(vtkRenderer* renderer);
}

#endif
