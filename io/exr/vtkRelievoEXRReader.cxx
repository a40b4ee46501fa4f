// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoEXRReader.h"

#include "vtkCommand.h"
#include "vtkDataArraySelection.h"
#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkRelievoEXRAttributes.h"
#include "vtkRelievoEXRErrors.h"
#include "vtkRelievoEXRFailure.h"
#include "vtkRelievoEXRInput.h"
#include "vtkRelievoEXRThreads.h"
#include "vtkRelievoLayerCatalogue.h"
#include "vtkRelievoParameter.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <limits>

vtkStandardNewMacro(vtkRelievoEXRReader);

using relievo::exr::Failure;
using relievo::exr::Input;

namespace
{
const char* const Advice = "the file is broken or cut off: write or fetch it again";

const std::string& Picture()
{
  return vtkRelievoLayerCatalogue::GetPicture().Name;
}
}

//------------------------------------------------------------------------------
struct vtkRelievoEXRReader::Internals
{
  vtkNew<vtkDataArraySelection> Selection;
  // The content of the last file.
  std::vector<Input::Part> Parts;
  std::vector<Input::Channel> Channels;
  std::vector<std::string> Layers;
  // The reader's time when reading failed: the error was reported, and stands until something
  // changes.
  vtkMTimeType RefusedAt = 0;

  // Opens the file and chooses parts and channels by the reader's settings, noting all that exist.
  std::unique_ptr<Input> Open(vtkRelievoEXRReader* self);
};

//------------------------------------------------------------------------------
std::unique_ptr<Input> vtkRelievoEXRReader::Internals::Open(vtkRelievoEXRReader* self)
{
  this->Parts.clear();
  this->Channels.clear();
  this->Layers.clear();
  if (!self->FileName || !*self->FileName)
  {
    throw Failure(vtkErrorCode::NoFileNameError, "no file name is given; set it with SetFileName");
  }
  relievo::exr::StartThreads(self->NumberOfThreads);
  auto input = std::make_unique<Input>(self->FileName);
  this->Parts = input->GetParts();
  input->ChoosePart(self->Part);
  this->Channels = input->GetChannels();
  std::vector<int> chosen;
  for (std::size_t i = 0; i < this->Channels.size(); ++i)
  {
    // Keeps earlier choices; new channels are enabled.
    this->Selection->AddArray(this->Channels[i].Name.c_str());
    if (this->Selection->ArrayIsEnabled(this->Channels[i].Name.c_str()))
    {
      chosen.push_back(static_cast<int>(i));
    }
  }
  input->ChooseChannels(chosen);
  for (const relievo::exr::ArrayLayout& array : input->GetArrays())
  {
    this->Layers.push_back(array.Name);
  }
  return input;
}

//------------------------------------------------------------------------------
vtkRelievoEXRReader::vtkRelievoEXRReader()
  : Internal(new Internals)
{
  this->SetNumberOfInputPorts(0);
  vtkRelievoParameter& part = this->Parameters.AddWhole("part", vtkRelievoMember(Part), -1, 0, "",
    "The part to read from a file with several parts, from 0; -1 reads all, which must then have "
    "the same data window.");
  part.Most = std::numeric_limits<double>::infinity();
  part.Advanced = true;
}

//------------------------------------------------------------------------------
vtkRelievoEXRReader::~vtkRelievoEXRReader()
{
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
void vtkRelievoEXRReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "Part: " << this->Part << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  os << indent << "ChannelSelection:\n";
  this->Internal->Selection->PrintSelf(os, indent.GetNextIndent());
}

//------------------------------------------------------------------------------
int vtkRelievoEXRReader::CanReadFile(const char* fileName)
{
  return fileName && relievo::exr::Translate(Advice, [&] { Input input(fileName); }).Code == 0;
}

//------------------------------------------------------------------------------
int vtkRelievoEXRReader::GetNumberOfParts()
{
  return static_cast<int>(this->Internal->Parts.size());
}

//------------------------------------------------------------------------------
const char* vtkRelievoEXRReader::GetPartName(int part)
{
  return part >= 0 && part < this->GetNumberOfParts() ? this->Internal->Parts[part].Name.c_str()
                                                      : nullptr;
}

//------------------------------------------------------------------------------
const char* vtkRelievoEXRReader::GetPartType(int part)
{
  return part >= 0 && part < this->GetNumberOfParts() ? this->Internal->Parts[part].Type.c_str()
                                                      : nullptr;
}

//------------------------------------------------------------------------------
int vtkRelievoEXRReader::GetNumberOfChannels()
{
  return static_cast<int>(this->Internal->Channels.size());
}

//------------------------------------------------------------------------------
const char* vtkRelievoEXRReader::GetChannelName(int channel)
{
  return channel >= 0 && channel < this->GetNumberOfChannels()
    ? this->Internal->Channels[channel].Name.c_str()
    : nullptr;
}

//------------------------------------------------------------------------------
int vtkRelievoEXRReader::GetChannelPixelType(int channel)
{
  return channel >= 0 && channel < this->GetNumberOfChannels()
    ? static_cast<int>(this->Internal->Channels[channel].Type)
    : -1;
}

//------------------------------------------------------------------------------
int vtkRelievoEXRReader::GetNumberOfLayers()
{
  return static_cast<int>(this->Internal->Layers.size());
}

//------------------------------------------------------------------------------
const char* vtkRelievoEXRReader::GetLayerName(int layer)
{
  return layer >= 0 && layer < this->GetNumberOfLayers() ? this->Internal->Layers[layer].c_str()
                                                         : nullptr;
}

//------------------------------------------------------------------------------
vtkDataArraySelection* vtkRelievoEXRReader::GetChannelSelection()
{
  return this->Internal->Selection;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkRelievoEXRReader::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Internal->Selection->GetMTime());
}

//------------------------------------------------------------------------------
int vtkRelievoEXRReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* info = outputVector->GetInformationObject(0);
  int extent[6] = { 0, -1, 0, -1, 0, -1 };
  double origin[3] = { 0, 0, 0 };
  double spacing[3] = { 1, 1, 1 };
  const Failure failure = relievo::exr::Translate(Advice, [&] {
    const std::unique_ptr<Input> input = this->Internal->Open(this);
    const Imath::Box2i data = input->GetDataWindow();
    const Imath::Box2i display = input->GetDisplayWindow();
    extent[1] = data.max.x - data.min.x;
    extent[3] = data.max.y - data.min.y;
    extent[5] = 0;
    origin[0] = static_cast<double>(data.min.x) - display.min.x;
    origin[1] = static_cast<double>(display.max.y) - data.max.y;
    if (!input->GetArrays().empty())
    {
      const relievo::exr::ArrayLayout* scalars = &input->GetArrays().front();
      for (const relievo::exr::ArrayLayout& array : input->GetArrays())
      {
        scalars = array.Name == Picture() ? &array : scalars;
      }
      vtkDataObject::SetPointDataActiveScalarInfo(
        info, scalars->VtkType, static_cast<int>(scalars->Channels.size()));
    }
  });
  this->Report(failure.Code, failure.what());
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  info->Set(vtkDataObject::ORIGIN(), origin, 3);
  info->Set(vtkDataObject::SPACING(), spacing, 3);
  // 1 also on failure: 0 makes the pipeline add an uninformative message.
  return 1;
}

//------------------------------------------------------------------------------
int vtkRelievoEXRReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkImageData* output = vtkImageData::GetData(outputVector, 0);
  output->Initialize();
  vtkInformation* info = outputVector->GetInformationObject(0);
  const bool later = info->Has(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) &&
    info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) > 0;
  if (later || this->Internal->RefusedAt == this->GetMTime())
  {
    return 1;
  }
  std::unique_ptr<Input> input;
  const Failure failure = relievo::exr::Translate(Advice, [&] {
    input = this->Internal->Open(this);
    const Imath::Box2i data = input->GetDataWindow();
    const Imath::Box2i display = input->GetDisplayWindow();
    output->SetExtent(0, data.max.x - data.min.x, 0, data.max.y - data.min.y, 0, 0);
    output->SetOrigin(static_cast<double>(data.min.x) - display.min.x,
      static_cast<double>(display.max.y) - data.max.y, 0);
    output->SetSpacing(1, 1, 1);
    input->Read(output->GetPointData(), [this](double progress) {
      this->UpdateProgress(progress);
      return !this->GetAbortExecute();
    });
    relievo::exr::ReadAttributes(input->GetHeader(), output->GetFieldData());
    vtkPointData* points = output->GetPointData();
    if (points->GetNumberOfArrays() > 0)
    {
      const char* picture = Picture().c_str();
      points->SetActiveScalars(points->HasArray(picture) ? picture : points->GetArrayName(0));
    }
  });
  if (failure.Code != vtkErrorCode::NoError)
  {
    output->Initialize();
  }
  this->Report(failure.Code, failure.what());
  return 1;
}

//------------------------------------------------------------------------------
void vtkRelievoEXRReader::Report(unsigned long code, const std::string& message)
{
  this->SetErrorCode(code);
  this->Internal->RefusedAt = 0;
  if (!message.empty())
  {
    // The pipeline requests missing data again; the error is reported only once.
    this->Internal->RefusedAt = this->GetMTime();
    vtkErrorMacro(
      "Cannot read '" << (this->FileName ? this->FileName : "") << "': " << message << ".");
  }
}
