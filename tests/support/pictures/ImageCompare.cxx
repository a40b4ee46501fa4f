// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ImageCompare.h"

#include "Check.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPNGWriter.h>

#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iostream>
#include <sstream>

namespace relievoTest
{
namespace
{
// Why an image cannot be compared; empty if it can.
std::string Complaint(vtkImageData* image, const char* which)
{
  std::ostringstream text;
  if (!image)
  {
    text << "there is no " << which << " image";
    return text.str();
  }
  const int* size = image->GetDimensions();
  if (size[0] < 1 || size[1] < 1 || size[2] != 1 || !image->GetScalarPointer())
  {
    text << "the " << which << " image is empty or not flat (" << size[0] << "x" << size[1] << "x"
         << size[2] << ")";
  }
  else if (image->GetScalarType() != VTK_UNSIGNED_CHAR)
  {
    text << "the " << which << " image holds " << image->GetScalarTypeAsString()
         << ", not unsigned char";
  }
  else if (image->GetNumberOfScalarComponents() != 3 && image->GetNumberOfScalarComponents() != 4)
  {
    text << "the " << which << " image has " << image->GetNumberOfScalarComponents()
         << " components, not 3 or 4";
  }
  return text.str();
}

// Why two images cannot be compared; empty if they can.
std::string Complaint(vtkImageData* actual, vtkImageData* expected)
{
  std::string text = Complaint(actual, "actual");
  if (text.empty())
  {
    text = Complaint(expected, "expected");
  }
  if (text.empty())
  {
    const int* a = actual->GetDimensions();
    const int* e = expected->GetDimensions();
    if (a[0] != e[0] || a[1] != e[1])
    {
      std::ostringstream sizes;
      sizes << "sizes differ: actual " << a[0] << "x" << a[1] << ", expected " << e[0] << "x"
            << e[1];
      text = sizes.str();
    }
  }
  return text;
}

// Reads the pixels of a comparable image one by one, as RGBA.
class Pixels
{
public:
  explicit Pixels(vtkImageData* image)
    : Data(static_cast<const unsigned char*>(image->GetScalarPointer()))
    , Components(image->GetNumberOfScalarComponents())
    , Count(static_cast<long long>(image->GetDimensions()[0]) * image->GetDimensions()[1])
  {
  }
  int Get(long long pixel, int channel) const
  {
    return channel < this->Components ? this->Data[pixel * this->Components + channel] : 255;
  }
  const unsigned char* const Data;
  const int Components;
  const long long Count;
};

void RemovePictures(const std::string& stem)
{
  for (const char* kind : { ".actual.png", ".expected.png", ".difference.png" })
  {
    vtksys::SystemTools::RemoveFile(stem + kind);
  }
}
}

//------------------------------------------------------------------------------
ImageDifference CompareImages(
  vtkImageData* actual, vtkImageData* expected, const ImageLimits& limits)
{
  ImageDifference result;
  result.Summary = Complaint(actual, expected);
  if (!result.Summary.empty())
  {
    return result;
  }
  const Pixels a(actual);
  const Pixels e(expected);
  const int channels = std::max(a.Components, e.Components);
  long long sum = 0;
  result.Largest = 0;
  for (long long pixel = 0; pixel < a.Count; ++pixel)
  {
    int largest = 0;
    for (int channel = 0; channel < channels; ++channel)
    {
      const int difference = std::abs(a.Get(pixel, channel) - e.Get(pixel, channel));
      sum += difference;
      largest = std::max(largest, difference);
    }
    result.Pixels += largest > limits.Threshold ? 1 : 0;
    result.Largest = std::max(result.Largest, largest);
  }
  result.Comparable = true;
  result.Share = static_cast<double>(result.Pixels) / a.Count;
  result.Mean = static_cast<double>(sum) / (a.Count * channels);
  result.Passed = result.Share <= limits.MaxShare && result.Mean <= limits.MaxMean;

  std::ostringstream text;
  text << (result.Passed ? "same" : "differs") << ": " << result.Pixels << " of " << a.Count
       << " pixels (" << 100. * result.Share << " %, limit " << 100. * limits.MaxShare
       << " %) differ by more than " << limits.Threshold << "/255; mean " << result.Mean
       << "/255 (limit " << limits.MaxMean << "), largest " << result.Largest;
  result.Summary = text.str();
  return result;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> TenfoldDifference(vtkImageData* actual, vtkImageData* expected)
{
  if (!Complaint(actual, expected).empty())
  {
    return nullptr;
  }
  const Pixels a(actual);
  const Pixels e(expected);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(actual->GetDimensions());
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* out = static_cast<unsigned char*>(image->GetScalarPointer());
  for (long long pixel = 0; pixel < a.Count; ++pixel)
  {
    // A difference only in alpha must be visible, too: it is shown in all three channels.
    const int alpha = std::abs(a.Get(pixel, 3) - e.Get(pixel, 3));
    for (int channel = 0; channel < 3; ++channel)
    {
      const int difference = std::abs(a.Get(pixel, channel) - e.Get(pixel, channel));
      *out++ = static_cast<unsigned char>(std::min(255, 10 * std::max(difference, alpha)));
    }
  }
  return image;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> ReadImage(const std::string& path, std::string* reason)
{
  std::string text;
  vtkSmartPointer<vtkImageData> image;
  if (!vtksys::SystemTools::FileExists(path, true))
  {
    text = "there is no file " + path;
  }
  else
  {
    vtkNew<vtkPNGReader> reader;
    if (!reader->CanReadFile(path.c_str()))
    {
      text = path + " is not a PNG image";
    }
    else
    {
      reader->SetFileName(path.c_str());
      reader->Update();
      image = reader->GetOutput();
      text = Complaint(image, path.c_str());
    }
  }
  if (!text.empty())
  {
    image = nullptr;
  }
  if (reason)
  {
    *reason = text;
  }
  return image;
}

//------------------------------------------------------------------------------
bool IsSame(vtkImageData* a, vtkImageData* b)
{
  const vtkIdType bytes = a->GetNumberOfPoints() * a->GetNumberOfScalarComponents();
  return bytes == b->GetNumberOfPoints() * b->GetNumberOfScalarComponents() &&
    std::memcmp(a->GetScalarPointer(), b->GetScalarPointer(), static_cast<std::size_t>(bytes)) == 0;
}

//------------------------------------------------------------------------------
bool WriteImage(const std::string& path, vtkImageData* image)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(image);
  writer->Write();
  return writer->GetErrorCode() == 0;
}

//------------------------------------------------------------------------------
ImageDifference CompareAndReport(const std::string& name, vtkImageData* actual,
  vtkImageData* expected, const std::string& folder, const ImageLimits& limits)
{
  const std::string stem = folder + "/" + name;
  RemovePictures(stem);
  ImageDifference result = CompareImages(actual, expected, limits);
  result.Summary = name + " " + result.Summary;
  if (result.Passed)
  {
    return result;
  }
  const vtkSmartPointer<vtkImageData> difference = TenfoldDifference(actual, expected);
  bool written = true;
  if (Complaint(actual, "actual").empty())
  {
    written = WriteImage(stem + ".actual.png", actual) && written;
  }
  if (Complaint(expected, "expected").empty())
  {
    written = WriteImage(stem + ".expected.png", expected) && written;
  }
  if (difference)
  {
    written = WriteImage(stem + ".difference.png", difference) && written;
  }
  result.Summary += (written ? "; pictures: " : "; its pictures could not be written: ") + stem +
    ".{actual,expected,difference}.png";
  return result;
}

//------------------------------------------------------------------------------
bool CheckBaseline(const std::string& name, vtkImageData* actual, const ImageLimits& limits)
{
  std::string folder;
  if (!vtksys::SystemTools::GetEnv("RELIEVO_BASELINES", folder) || folder.empty())
  {
    Fail(__FILE__, __LINE__,
      name + ": RELIEVO_BASELINES is not set; run the test by ctest, or set it to tests/baselines");
    return false;
  }
  std::string reason;
  const std::string path = folder + "/" + name + ".png";
  const vtkSmartPointer<vtkImageData> expected = ReadImage(path, &reason);
  ImageDifference result = CompareAndReport(name, actual, expected, OutputFolder(), limits);
  if (!expected)
  {
    result.Summary = name + " has no baseline: " + reason + "; look at " + OutputFolder() + "/" +
      name + ".actual.png and, if it is right, copy it to " + path +
      " (target update-baselines does so)";
  }
  if (result.Passed)
  {
    std::cout << result.Summary << std::endl;
  }
  return Check(result.Passed, __FILE__, __LINE__, result.Summary);
}
}
