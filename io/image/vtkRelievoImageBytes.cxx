// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoImageBytes.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkRelievoImageFile.h"

#include <cstring>
#include <new>

namespace relievo::image
{
//------------------------------------------------------------------------------
void CheckSize(std::uint64_t width, std::uint64_t height, int components, int bytesOfComponent)
{
  const std::string size = std::to_string(width) + " x " + std::to_string(height) + " texels";
  if (width == 0 || height == 0)
  {
    throw Failure("it has " + size);
  }
  const std::uint64_t texels = vtkRelievoImageFile::MostTexels;
  const std::uint64_t each = static_cast<std::uint64_t>(components) * bytesOfComponent;
  if (width > texels || height > texels / width ||
    width * height > vtkRelievoImageFile::MostBytes / each)
  {
    throw Failure("it has " + size + " of " + std::to_string(each) +
      (each == 1 ? " byte" : " bytes") + "; at most " + std::to_string(texels >> 20) +
      " Mi texels and " + std::to_string(vtkRelievoImageFile::MostBytes >> 30) +
      " GiB are read: make it smaller");
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> MakeImage(
  std::uint64_t width, std::uint64_t height, int type, int components)
{
  CheckSize(width, height, components, vtkDataArray::GetDataTypeSize(type));
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(static_cast<int>(width), static_cast<int>(height), 1);
  try
  {
    image->AllocateScalars(type, components);
  }
  catch (const std::bad_alloc&)
  {
    throw Failure("there is no memory for its " + std::to_string(width) + " x " +
      std::to_string(height) + " texels");
  }
  return image;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> Orient(vtkImageData* image, int orientation)
{
  if (orientation < 2 || orientation > 8)
  {
    return image;
  }
  // With rows counted from the top: 2 to 4 mirror columns, rows or both; 5 to 8 swap rows and
  // columns.
  const bool swaps = orientation >= 5;
  const bool right = orientation == 2 || orientation == 3 || orientation == 6 || orientation == 7;
  const bool bottom = orientation == 3 || orientation == 4 || orientation == 7 || orientation == 8;
  const int width = image->GetDimensions()[0];
  const int height = image->GetDimensions()[1];
  vtkDataArray* from = image->GetPointData()->GetScalars();
  auto turned = MakeImage(swaps ? height : width, swaps ? width : height, from->GetDataType(),
    from->GetNumberOfComponents());
  const int wide = turned->GetDimensions()[0];
  const int high = turned->GetDimensions()[1];
  const std::size_t each =
    static_cast<std::size_t>(from->GetDataTypeSize()) * from->GetNumberOfComponents();
  for (int y = 0; y < high; ++y)
  {
    auto* to = static_cast<char*>(turned->GetScalarPointer(0, high - 1 - y, 0));
    for (int x = 0; x < wide; ++x, to += each)
    {
      const int seenX = right ? wide - 1 - x : x;
      const int seenY = bottom ? high - 1 - y : y;
      const int column = swaps ? seenY : seenX;
      const int row = swaps ? seenX : seenY;
      std::memcpy(to, image->GetScalarPointer(column, height - 1 - row, 0), each);
    }
  }
  return turned;
}
}
