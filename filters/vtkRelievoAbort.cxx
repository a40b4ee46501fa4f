// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoAbort.h"

#include "vtkRelievoVTKVersions.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"

namespace relievo
{
//------------------------------------------------------------------------------
bool IsStopped(vtkAlgorithm* filter)
{
  bool stopped = filter->GetAbortExecute() != 0;
#ifdef RELIEVO_VTK_CHECK_ABORT
  stopped = filter->CheckAbort() || stopped;
#endif
  return stopped;
}

//------------------------------------------------------------------------------
void Begin(vtkInformationVector* outputs)
{
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    outputs->GetInformationObject(port)->Remove(vtkDemandDrivenPipeline::DATA_NOT_GENERATED());
  }
}

//------------------------------------------------------------------------------
void Discard(vtkInformationVector* outputs)
{
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    if (vtkDataObject* data = vtkDataObject::GetData(outputs, port))
    {
      data->ReleaseData();
    }
    outputs->GetInformationObject(port)->Set(vtkDemandDrivenPipeline::DATA_NOT_GENERATED(), 1);
  }
}
}
