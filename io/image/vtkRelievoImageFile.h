// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Pictures in files, for maps and environments. Whoever asks for a file that another holds already
// gets the same image, unless the file has changed since.
#ifndef vtkRelievoImageFile_h
#define vtkRelievoImageFile_h

#include "vtkImageData.h"
#include "vtkRelievoIOModule.h" // for the export macro
#include "vtkSmartPointer.h"

#include <functional>
#include <string>

class vtkAlgorithm;

namespace vtkRelievoImageFile
{
// The image, row 0 at the bottom, with the numbers of the file: of OpenEXR files `color`, or else
// the first layer. nullptr if it cannot be read; then `failure` says what was expected and what is
// wrong. `watch` is called with the reader before it reads.
VTKRELIEVOIO_EXPORT vtkSmartPointer<vtkImageData> Read(const std::string& path,
  std::string& failure, const std::function<void(vtkAlgorithm*)>& watch = nullptr);
}

#endif
