// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// An OpenEXR file as a picture: selects its colour channels and places its pixels in the picture.
#ifndef vtkRelievoEXRImage_h
#define vtkRelievoEXRImage_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <string>

class vtkAlgorithm;

namespace relievo::image
{
// The picture in the display window, 0 where the data window has no pixels; pixels outside the
// display window are left out. Of several parts, the first is used. The channels, HALF, FLOAT or
// UINT, become floats: R G B [A] or r g b [a]; otherwise Y [A]; otherwise the first LAYER.R LAYER.G
// LAYER.B [LAYER.A], upper or lower case; otherwise the first array of vtkRelievoEXRReader. Arrays
// of unsigned char recorded by vtkRelievoEXRWriter stay so. Throws Failure. `note`: what was left
// out, or empty.
vtkSmartPointer<vtkImageData> ReadEXR(
  const std::string& path, std::string& note, const std::function<void(vtkAlgorithm*)>& watch);
}

#endif
