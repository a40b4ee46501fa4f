// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVRelievoLayers.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPVRelievoCapture.h"
#include "vtkPVView.h"
#include "vtkStreamingDemandDrivenPipeline.h"

vtkStandardNewMacro(vtkPVRelievoLayers);

//------------------------------------------------------------------------------
vtkPVRelievoLayers::vtkPVRelievoLayers()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkPVRelievoLayers::~vtkPVRelievoLayers() = default;

//------------------------------------------------------------------------------
void vtkPVRelievoLayers::SetView(vtkPVView* view)
{
  this->View = view;
}

//------------------------------------------------------------------------------
vtkPVView* vtkPVRelievoLayers::GetView()
{
  return this->View;
}

//------------------------------------------------------------------------------
void vtkPVRelievoLayers::SetCapture(vtkPVRelievoCapture* capture)
{
  if (this->Capture != capture)
  {
    this->Capture = capture;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkPVRelievoLayers::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  int extent[6] = { 0, -1, 0, -1, 0, -1 };
  if (this->Capture)
  {
    this->Capture->GetImage()->GetExtent(extent);
  }
  outputs->GetInformationObject(0)->Set(
    vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  return 1;
}

//------------------------------------------------------------------------------
int vtkPVRelievoLayers::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkImageData* output = vtkImageData::GetData(outputs);
  output->Initialize();
  if (this->Capture)
  {
    output->ShallowCopy(this->Capture->GetImage());
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkPVRelievoLayers::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "View: " << this->View.GetPointer() << "\n";
  os << indent << "Capture: " << this->Capture.GetPointer() << "\n";
}
