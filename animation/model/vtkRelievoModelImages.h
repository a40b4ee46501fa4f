// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Images that are in a model's file.
 */
#ifndef vtkRelievoModelImages_h
#define vtkRelievoModelImages_h

#include "vtkRelievoModel.h"

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <string>

namespace relievo
{
/// The lowest row first, as VTK has images. Null with what is `wrong`.
vtkSmartPointer<vtkImageData> DecodeImage(const ModelImage& image, std::string& wrong);
}

#endif
