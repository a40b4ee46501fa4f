// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Layers of a frame, as far as they can be read: a process lacks the arrays of what others hold.
#ifndef vtkPVRelievoLayerRead_h
#define vtkPVRelievoLayerRead_h

#include <string>
#include <vector>

class vtkImageData;
class vtkRelievoPass;

namespace vtkPVRelievoLayerRead
{
// Reads the named layers of the last picture into the image; those that cannot be read are left
// out. Returns what was wrong with the first of these, in words, and prints nothing.
std::string ReadSome(
  vtkRelievoPass* frame, const std::vector<std::string>& names, vtkImageData* image);
}

#endif
