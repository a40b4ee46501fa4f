// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/** Images inside a model's file. */
#ifndef vtkRelievoModelImages_h
#define vtkRelievoModelImages_h

#include "vtkRelievoModel.h"

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <string>

namespace relievo
{
/// The image with the lowest row first, as in VTK. Null, with the problem in `error`, if it is
/// damaged.
vtkSmartPointer<vtkImageData> DecodeImage(const ModelImage& image, std::string& error);
}

#endif
