// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoEXRWriter.h"

#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkRelievoEXRAttributes.h"
#include "vtkRelievoEXRErrors.h"
#include "vtkRelievoEXRFailure.h"
#include "vtkRelievoEXROutput.h"
#include "vtkRelievoEXRStream.h"
#include "vtkRelievoEXRThreads.h"
#include "vtkRelievoParameter.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <OpenEXR/Iex.h>

#include <algorithm>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkRelievoEXRWriter);

using relievo::exr::Failure;
using relievo::exr::Output;
using relievo::exr::OutputStream;

namespace
{
const std::vector<std::string> CompressionNames = { "none", "rle", "zips", "zip", "piz", "pxr24",
  "b44", "b44a", "dwaa", "dwab" };
const char* const PixelTypeNames[] = { "UINT", "HALF", "FLOAT" };
}

//------------------------------------------------------------------------------
struct vtkRelievoEXRWriter::Internals
{
  // A file whose rows are not all written.
  struct Unfinished
  {
    Unfinished(const char* name, vtkImageData* image, const Output::Settings& settings, int height)
      : File(image, settings, height)
      , Name(name)
      , Height(height)
    {
      this->Stream = std::make_unique<OutputStream>(name);
    }
    std::unique_ptr<OutputStream> Stream;
    Output File; // uses the stream even when it is destroyed
    std::string Name;
    int Height;
  };

  Output::Settings Settings;
  std::unique_ptr<Unfinished> Rows;
};

//------------------------------------------------------------------------------
vtkRelievoEXRWriter::vtkRelievoEXRWriter()
  : Internal(new Internals)
{
  this->SetNumberOfOutputPorts(0);
  this->Parameters
    .AddChoice("compression", vtkRelievoMember(Compression), CompressionNames,
      "How pixels are packed. None, RLE, ZIPS, ZIP and PIZ are lossless. PXR24 rounds floats to 24 "
      "bits; B44 and B44A lose accuracy in half floats, DWAA and DWAB in channels named R, G, B "
      "and Y.")
    .ChoiceLabels = { "None", "RLE", "ZIPS", "ZIP", "PIZ", "PXR24", "B44", "B44A", "DWAA", "DWAB" };
}

//------------------------------------------------------------------------------
vtkRelievoEXRWriter::~vtkRelievoEXRWriter()
{
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
void vtkRelievoEXRWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "Compression: " << this->GetCompressionName() << "\n";
  os << indent << "DWALevel: " << this->DWALevel << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  os << indent << "SystemError: " << this->SystemError << "\n";
  for (const auto& choice : this->Internal->Settings.PixelTypes)
  {
    os << indent << "PixelType of " << choice.first << ": " << PixelTypeNames[choice.second]
       << "\n";
  }
  for (const auto& attribute : this->Internal->Settings.Strings)
  {
    os << indent << "Attribute " << attribute.first << ": " << attribute.second << "\n";
  }
  for (const auto& attribute : this->Internal->Settings.Doubles)
  {
    os << indent << "Attribute " << attribute.first << ": " << attribute.second << "\n";
  }
}

//------------------------------------------------------------------------------
void vtkRelievoEXRWriter::SetCompression(int compression)
{
  const int count = static_cast<int>(CompressionNames.size());
  if (compression < 0 || compression >= count)
  {
    vtkErrorMacro("SetCompression: " << compression << " is none of the compressions 0 (none) to "
                                     << count - 1 << " (dwab).");
  }
  else if (compression != this->Compression)
  {
    this->Compression = compression;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoEXRWriter::SetCompressionByName(const char* name)
{
  const auto found = std::find(CompressionNames.begin(), CompressionNames.end(), name ? name : "");
  if (found != CompressionNames.end())
  {
    this->SetCompression(static_cast<int>(found - CompressionNames.begin()));
    return true;
  }
  vtkErrorMacro("SetCompressionByName: '"
    << (name ? name : "")
    << "' is none of none, rle, zips, zip, piz, pxr24, b44, b44a, dwaa, dwab.");
  return false;
}

//------------------------------------------------------------------------------
const char* vtkRelievoEXRWriter::GetCompressionName()
{
  return CompressionNames[this->Compression].c_str();
}

//------------------------------------------------------------------------------
void vtkRelievoEXRWriter::SetPixelType(const char* name, int type)
{
  if (!name || !*name || type < UINT || type > FLOAT)
  {
    vtkErrorMacro("SetPixelType: for '" << (name ? name : "") << "' the type " << type
                                        << " is given; give a name, and UINT, HALF or FLOAT.");
    return;
  }
  this->Internal->Settings.PixelTypes[name] = static_cast<Imf::PixelType>(type);
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkRelievoEXRWriter::GetPixelType(const char* name)
{
  const auto& types = this->Internal->Settings.PixelTypes;
  const auto found = types.find(name ? name : "");
  return found == types.end() ? -1 : static_cast<int>(found->second);
}

//------------------------------------------------------------------------------
void vtkRelievoEXRWriter::RemoveAllPixelTypes()
{
  this->Internal->Settings.PixelTypes.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
bool vtkRelievoEXRWriter::AcceptAttribute(const char* name)
{
  const bool accepted = name && relievo::exr::IsFreeAttribute(name);
  if (!accepted)
  {
    vtkErrorMacro("An attribute cannot be named '"
      << (name ? name : "")
      << "': the name is empty, too long (over 255 bytes), or used by the format or by Relievo; "
         "choose another.");
  }
  return accepted;
}

//------------------------------------------------------------------------------
void vtkRelievoEXRWriter::SetStringAttribute(const char* name, const char* value)
{
  if (this->AcceptAttribute(name))
  {
    this->Internal->Settings.Doubles.erase(name);
    this->Internal->Settings.Strings[name] = value ? value : "";
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoEXRWriter::SetDoubleAttribute(const char* name, double value)
{
  if (this->AcceptAttribute(name))
  {
    this->Internal->Settings.Strings.erase(name);
    this->Internal->Settings.Doubles[name] = value;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoEXRWriter::RemoveAllAttributes()
{
  this->Internal->Settings.Strings.clear();
  this->Internal->Settings.Doubles.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkRelievoEXRWriter::Write()
{
  this->SystemError = 0;
  if (this->GetNumberOfInputConnections(0) < 1)
  {
    this->SetErrorCode(vtkErrorCode::UserError);
    vtkErrorMacro("Cannot write '" << (this->FileName ? this->FileName : "")
                                   << "': there is no image; give one with SetInputData or "
                                      "SetInputConnection.");
    return 0;
  }
  // Writes again even if nothing has changed: the file may have been removed.
  this->Modified();
  // Remains if the pipeline fails before RequestData.
  this->SetErrorCode(vtkErrorCode::UnknownError);
  this->UpdateWholeExtent();
  return this->GetErrorCode() == vtkErrorCode::NoError ? 1 : 0;
}

//------------------------------------------------------------------------------
int vtkRelievoEXRWriter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  vtkInformation* info = inputVector[0]->GetInformationObject(0);
  int extent[6] = { 0, -1, 0, -1, 0, -1 };
  info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
  info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent, 6);
  return 1;
}

//------------------------------------------------------------------------------
int vtkRelievoEXRWriter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  vtkImageData* image = vtkImageData::GetData(inputVector[0], 0);
  this->Internal->Rows.reset();
  this->TryRows(image, 0, image->GetDimensions()[1], image->GetDimensions()[1]);
  this->Internal->Rows.reset();
  // 1 also on failure: 0 makes the pipeline add an uninformative message.
  return 1;
}

//------------------------------------------------------------------------------
int vtkRelievoEXRWriter::WriteRows(vtkImageData* image, int lowest, int count, int height)
{
  const std::unique_ptr<Internals::Unfinished>& begun = this->Internal->Rows;
  const bool isOther =
    begun && (begun->Height != height || begun->Name != (this->FileName ? this->FileName : ""));
  if (!image || isOther || lowest < 0 || count < 1 || count > height ||
    lowest > image->GetDimensions()[1] - count)
  {
    this->SetErrorCode(vtkErrorCode::UserError);
    vtkErrorMacro(
      "WriteRows was given " << (!image ? "no image; give it a vtkImageData."
          : isOther ? "another height or file name than for the picture's first rows; give it the "
                      "same ones for all rows."
                    : "rows that the image or the picture does not have; give it the lowest one "
                      "of the image's rows, their number, and the picture's height."));
    this->Internal->Rows.reset();
    return 0;
  }
  this->SystemError = 0;
  this->TryRows(image, lowest, count, height);
  return this->GetErrorCode() == vtkErrorCode::NoError ? 1 : 0;
}

//------------------------------------------------------------------------------
void vtkRelievoEXRWriter::TryRows(vtkImageData* image, int lowest, int count, int height)
{
  std::string warning;
  std::unique_ptr<Internals::Unfinished>& rows = this->Internal->Rows;
  const char* advice = "this should not happen: please report it with the image";
  const Failure failure = relievo::exr::Translate(advice, [&] {
    const bool isNew = !rows;
    if (isNew)
    {
      if (!this->FileName || !*this->FileName)
      {
        throw Failure(
          vtkErrorCode::NoFileNameError, "no file name is given; set it with SetFileName");
      }
      relievo::exr::StartThreads(this->NumberOfThreads);
      Output::Settings settings = this->Internal->Settings;
      settings.Compression = static_cast<Imf::Compression>(this->Compression);
      settings.DWALevel = static_cast<float>(this->DWALevel);
      rows = std::make_unique<Internals::Unfinished>(this->FileName, image, settings, height);
    }
    try
    {
      if (isNew)
      {
        rows->File.Begin(*rows->Stream);
      }
      rows->File.WriteRows(image, lowest, count, [this](double progress) {
        this->UpdateProgress(progress);
        return !this->GetAbortExecute();
      });
      if (rows->File.IsComplete())
      {
        warning = rows->File.End();
      }
    }
    catch (const Iex::BaseExc&)
    {
      rows->Stream->Check(); // the system's message is more specific
      throw;
    }
    if (rows->File.IsComplete())
    {
      rows->Stream->Commit();
      rows.reset();
    }
  });
  this->SetErrorCode(failure.Code);
  this->SystemError = failure.System;
  if (failure.Code != vtkErrorCode::NoError)
  {
    rows.reset();
  }
  const std::string message = failure.what();
  if (!message.empty())
  {
    vtkErrorMacro(
      "Cannot write '" << (this->FileName ? this->FileName : "") << "': " << message << ".");
  }
  if (!warning.empty())
  {
    vtkWarningMacro("In '" << this->FileName << "' " << warning << ".");
  }
}
