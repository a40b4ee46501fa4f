// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The layers of processes that each hold a part of the scene, put together: in every pixel the
// process with the least depth gives all layers. Each exchange is of one image; there are as many
// exchanges as the number of processes has binary digits.
#ifndef vtkPVRelievoLayerMerge_h
#define vtkPVRelievoLayerMerge_h

#include <string>
#include <vector>

class vtkImageData;
class vtkMultiProcessController;

namespace vtkPVRelievoLayerMerge
{
// No layer of a frame's, but of processes: which of them a pixel's values come from.
constexpr const char* ProcessLayer = "process";

// Called by all processes, with the same names, `depth` among them. `image` has what the process
// made: no points if it drew nothing, arrays only for layers it has. Afterwards that of process 0
// has all layers that any process had; a layer is empty (as vtkRelievoLayerSource says) where the
// nearest process lacks it. Returns what is wrong, in words, the same on all processes.
std::string Merge(vtkMultiProcessController* controller, const std::vector<std::string>& names,
  vtkImageData* image);

// Adds the array ProcessLayer: the process in every pixel that it has, -1 in the others.
void AddProcess(int process, vtkImageData* image);

// Layers where nothing is, for pictures without any geometry: those that the image lacks and whose
// type is known without it.
void FillBackground(const std::vector<std::string>& names, const int size[2], vtkImageData* image);
}

#endif
