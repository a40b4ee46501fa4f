// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoImageReader.h"

#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkRelievoImageFile.h"
#include "vtkStreamingDemandDrivenPipeline.h"

vtkStandardNewMacro(vtkRelievoImageReader);

//------------------------------------------------------------------------------
std::string vtkRelievoImageReader::GetExtensions()
{
  return vtkRelievoImageFile::ListExtensions();
}

//------------------------------------------------------------------------------
vtkRelievoImageReader::vtkRelievoImageReader()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkRelievoImageReader::~vtkRelievoImageReader()
{
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
void vtkRelievoImageReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "Colors: " << this->Colors << "\n";
}

//------------------------------------------------------------------------------
vtkImageData* vtkRelievoImageReader::GetImage()
{
  // The size is requested first, then the image; one reading serves both, with one error at most.
  if (this->ImageTime != this->GetMTime())
  {
    const char* name = this->FileName ? this->FileName : "";
    std::string failure = "the name of an image, but got none; set it with SetFileName";
    std::string note;
    this->Image = *name ? vtkRelievoImageFile::Read(name, failure, nullptr, &note) : nullptr;
    this->SetErrorCode(this->Image ? vtkErrorCode::NoError : vtkErrorCode::FileFormatError);
    this->ImageTime = this->GetMTime(); // changed by the error code
    if (!this->Image)
    {
      vtkErrorMacro(<< name << ": expected " << failure << ".");
    }
    if (!note.empty())
    {
      vtkWarningMacro(<< name << ": " << note << ".");
    }
    if (this->Image && this->Colors)
    {
      this->Image = vtkRelievoImageFile::ToColors(this->Image);
    }
  }
  return this->Image;
}

//------------------------------------------------------------------------------
int vtkRelievoImageReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* information = outputVector->GetInformationObject(0);
  int extent[6] = { 0, -1, 0, -1, 0, -1 };
  if (vtkImageData* image = this->GetImage())
  {
    image->GetExtent(extent);
    vtkDataArray* values = image->GetPointData()->GetScalars();
    vtkDataObject::SetPointDataActiveScalarInfo(
      information, values->GetDataType(), values->GetNumberOfComponents());
    information->Set(vtkDataObject::ORIGIN(), image->GetOrigin(), 3);
    information->Set(vtkDataObject::SPACING(), image->GetSpacing(), 3);
  }
  information->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  return 1;
}

//------------------------------------------------------------------------------
int vtkRelievoImageReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkImageData* output = vtkImageData::GetData(outputVector);
  output->Initialize();
  if (vtkImageData* image = this->GetImage())
  {
    output->ShallowCopy(image);
  }
  return 1;
}
