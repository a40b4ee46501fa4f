// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ImageCompare.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>

namespace relievoTest
{
namespace
{
bool IsPicture(vtkImageData* image)
{
  return image && image->GetNumberOfPoints() > 0 && image->GetScalarPointer() &&
    image->GetScalarType() == VTK_UNSIGNED_CHAR &&
    (image->GetNumberOfScalarComponents() == 3 || image->GetNumberOfScalarComponents() == 4);
}

int GetLevel(vtkImageData* image, vtkIdType pixel, int channel)
{
  const int components = image->GetNumberOfScalarComponents();
  return channel < components
    ? static_cast<const unsigned char*>(image->GetScalarPointer())[pixel * components + channel]
    : 255;
}
}

//------------------------------------------------------------------------------
int GetLargestDifference(vtkImageData* a, vtkImageData* b)
{
  if (!IsPicture(a) || !IsPicture(b) ||
    !std::equal(a->GetDimensions(), a->GetDimensions() + 3, b->GetDimensions()))
  {
    return 256;
  }
  int largest = 0;
  for (vtkIdType pixel = 0; pixel < a->GetNumberOfPoints(); ++pixel)
  {
    for (int channel = 0; channel < 4; ++channel)
    {
      largest =
        std::max(largest, std::abs(GetLevel(a, pixel, channel) - GetLevel(b, pixel, channel)));
    }
  }
  return largest;
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
}
