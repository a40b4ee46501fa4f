// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoWholeImage.h
 * @brief RequestUpdateExtent of filters that need their whole input image.
 */
#ifndef vtkRelievoWholeImage_h
#define vtkRelievoWholeImage_h

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkStreamingDemandDrivenPipeline.h"

namespace relievo
{
/** Requests the whole image of input 0, whatever part of the output is requested. Returns 1. */
inline int RequestWholeImage(vtkInformationVector** inputs)
{
  vtkInformation* info = inputs[0]->GetInformationObject(0);
  int whole[6];
  info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole);
  info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), whole, 6);
  return 1;
}
}

#endif
