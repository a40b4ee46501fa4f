// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Merges the layers of processes that each hold a part of the scene: in every pixel, the process
// with the smallest depth gives all layers. Each exchange transfers one image; the number of
// exchanges is the number of binary digits of the number of processes.
#ifndef vtkPVRelievoLayerMerge_h
#define vtkPVRelievoLayerMerge_h

#include <string>
#include <vector>

class vtkImageData;
class vtkMultiProcessController;

namespace vtkPVRelievoLayerMerge
{
// A layer of the merge, not of a frame: the process from which a pixel's values come.
constexpr const char* ProcessLayer = "process";

// Called by all processes, with equal names, `depth` among them. `image` has this process's layers:
// no points if it drew nothing, and arrays only for its layers. Afterwards the image of process 0
// has all layers of any process; a layer is empty (see vtkRelievoLayerSource) where the nearest
// process lacks it. Returns an error, equal on all processes, or "".
std::string Merge(vtkMultiProcessController* controller, const std::vector<std::string>& names,
  vtkImageData* image);

// Adds the array ProcessLayer: this process in every pixel with a surface, -1 in the others.
void AddProcess(int process, vtkImageData* image);

// Background layers for pictures without any geometry: those missing from the image whose type is
// known.
void FillBackground(const std::vector<std::string>& names, const int size[2], vtkImageData* image);
}

#endif
