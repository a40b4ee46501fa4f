// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// An OpenEXR file as a picture: which of its channels are the colours, and where its pixels lie in
// the picture that they are a part of.
#ifndef vtkRelievoEXRImage_h
#define vtkRelievoEXRImage_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <string>

class vtkAlgorithm;

namespace relievo::image
{
// The picture that the display window shows, 0 where the data window has no pixels; what lies
// beyond the display window is left out. Of several parts it is the first. The channels, HALF,
// FLOAT or UINT, become floats: R G B [A] or r g b [a]; or else Y [A]; or else the first LAYER.R
// LAYER.G LAYER.B [LAYER.A], large or small; or else the first array of vtkRelievoEXRReader. Arrays
// of unsigned char that vtkRelievoEXRWriter has recorded stay so. Throws Failure. `note`: what was
// left out, in words, or nothing.
vtkSmartPointer<vtkImageData> ReadEXR(
  const std::string& path, std::string& note, const std::function<void(vtkAlgorithm*)>& watch);
}

#endif
