// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Pictures in files, for maps and environments. Whoever asks for a file that another holds already
// gets the same image, unless the file has changed since.
#ifndef vtkPVRelievoImageFile_h
#define vtkPVRelievoImageFile_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <string>

namespace vtkPVRelievoImageFile
{
// The image, row 0 at the bottom: of OpenEXR files `color`, or else the first layer. nullptr if it
// cannot be read; then `failure` tells what was expected, and what is in the way.
vtkSmartPointer<vtkImageData> Read(const std::string& path, std::string& failure);
}

#endif
