// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoModelImages.h"

#include "vtkRelievoImageFile.h"

#include <algorithm>
#include <cstddef>

namespace relievo
{
namespace
{
vtkSmartPointer<vtkImageData> MakeImage(const ModelImage& image)
{
  auto made = vtkSmartPointer<vtkImageData>::New();
  made->SetDimensions(image.Width, image.Height, 1);
  made->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  const std::size_t row = 4 * static_cast<std::size_t>(image.Width);
  for (int y = 0; y < image.Height; ++y)
  {
    std::copy_n(image.Bytes.data() + row * static_cast<std::size_t>(image.Height - 1 - y), row,
      static_cast<unsigned char*>(made->GetScalarPointer(0, y, 0)));
  }
  return made;
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> DecodeImage(const ModelImage& image, std::string& error)
{
  error.clear();
  if (image.Width > 0)
  {
    return MakeImage(image);
  }
  return vtkRelievoImageFile::Decode(image.Bytes.data(), image.Bytes.size(), image.Format, error);
}
}
