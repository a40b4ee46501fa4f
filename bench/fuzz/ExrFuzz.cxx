// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ExrFuzz.h"

#include "ExrMutator.h"
#include "ExrSeeds.h"
#include "ImageTools.h"
#include "vtkRelievoEXRReader.h"
#include "vtkRelievoEXRWriter.h"

#include <vtkCallbackCommand.h>
#include <vtkDataArray.h>
#include <vtkErrorCode.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <chrono>
#include <filesystem>

namespace exrFuzz
{
namespace
{
void Keep(vtkObject*, unsigned long, void* clientData, void* callData)
{
  static_cast<std::vector<std::string>*>(clientData)
    ->push_back(callData ? static_cast<const char*>(callData) : "");
}

// Collects an algorithm's messages instead of printing them.
class Listener
{
public:
  explicit Listener(vtkAlgorithm* algorithm)
  {
    this->Command->SetCallback(Keep);
    this->Command->SetClientData(&this->Errors);
    algorithm->AddObserver(vtkCommand::ErrorEvent, this->Command);
    algorithm->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Command);
    this->Ignore->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
    algorithm->AddObserver(vtkCommand::WarningEvent, this->Ignore);
  }

  std::vector<std::string> Errors;

private:
  vtkNew<vtkCallbackCommand> Command;
  vtkNew<vtkCallbackCommand> Ignore;
};

std::string CheckRead(vtkRelievoEXRReader* reader, const Listener& listener)
{
  vtkImageData* image = reader->GetOutput();
  if (!listener.Errors.empty())
  {
    return "was read, but with an error: " + listener.Errors[0];
  }
  if (image->GetNumberOfPoints() == 0)
  {
    return "was read, but is empty";
  }
  if (image->GetPointData()->GetNumberOfArrays() != reader->GetNumberOfLayers())
  {
    return "has other arrays than the reader says";
  }
  for (int i = 0; i < image->GetPointData()->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = image->GetPointData()->GetArray(i);
    if (!array || array->GetNumberOfTuples() != image->GetNumberOfPoints())
    {
      return "has an array without one tuple per pixel";
    }
    // Reads every byte, so that a sanitizer finds missing ones.
    const char* bytes = static_cast<const char*>(array->GetVoidPointer(0));
    volatile char sum = 0;
    for (vtkIdType b = 0; b < array->GetNumberOfValues() * array->GetDataTypeSize(); ++b)
    {
      sum = static_cast<char>(sum ^ bytes[b]);
    }
  }
  return "";
}

std::string CheckRefused(vtkRelievoEXRReader* reader, const Listener& listener)
{
  vtkImageData* image = reader->GetOutput();
  const std::string file = reader->GetFileName();
  if (listener.Errors.size() != 1)
  {
    return "was refused with " + std::to_string(listener.Errors.size()) + " errors instead of one";
  }
  if (listener.Errors[0].find(file) == std::string::npos)
  {
    return "was refused with an error that does not name the file: " + listener.Errors[0];
  }
  if (reader->GetErrorCode() == vtkErrorCode::UnknownError)
  {
    return "was refused for want of memory, or by an unknown exception: " + listener.Errors[0];
  }
  if (image->GetNumberOfPoints() != 0 || image->GetPointData()->GetNumberOfArrays() != 0 ||
    image->GetFieldData()->GetNumberOfArrays() != 0)
  {
    return "was refused, but the output is not empty";
  }
  return "";
}

// Pictures with odd names, sizes and attributes: written or refused, with at most one message.
std::string CheckWrite(vtkImageData* image, const std::string& file)
{
  vtkNew<vtkRelievoEXRWriter> writer;
  const Listener listener(writer);
  writer->SetInputData(image);
  writer->SetFileName(file.c_str());
  const bool written = writer->Write() == 1;
  return listener.Errors.size() == (written ? 0u : 1u)
    ? ""
    : "written again, it gave " + std::to_string(listener.Errors.size()) + " errors";
}
}

//------------------------------------------------------------------------------
Result Run(uint64_t first, uint64_t count, const std::string& folder, double limitSeconds,
  const std::function<void(uint64_t)>& progress)
{
  const Mutator mutator(MakeSeeds(folder));
  const std::string file = folder + "/damaged.exr";
  Result result;
  for (uint64_t index = first; index < first + count; ++index)
  {
    // Removed first: replacing a file's contents makes some file systems wait for the disk.
    std::filesystem::remove(file);
    ioTest::WriteBytes(file, mutator.Make(index));
    const auto start = std::chrono::steady_clock::now();
    vtkNew<vtkRelievoEXRReader> reader;
    const Listener listener(reader);
    reader->SetFileName(file.c_str());
    reader->Update();
    const unsigned long code = reader->GetErrorCode();
    std::string fault;
    if (code == 0)
    {
      ++result.Read;
      fault = CheckRead(reader, listener);
      if (fault.empty() && result.Read % 16 == 0)
      {
        fault = CheckWrite(reader->GetOutput(), folder + "/again.exr");
      }
    }
    else
    {
      ++result.Refused;
      ++result.RefusedByCode[code];
      fault = CheckRefused(reader, listener);
    }
    const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (seconds > result.SlowestSeconds)
    {
      result.SlowestSeconds = seconds;
      result.Slowest = index;
    }
    if (seconds > limitSeconds)
    {
      fault = "took " + std::to_string(seconds) + " s; " + fault;
    }
    if (!fault.empty())
    {
      result.Faults.push_back("file " + std::to_string(index) + " " + fault);
    }
    progress(index - first + 1);
  }
  return result;
}
}
