// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoModelImages.h"

#include "vtkRelievoPngDamage.h"
#include "vtkRelievoVTKVersions.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkImageReader2.h"
#include "vtkJPEGReader.h"
#ifdef RELIEVO_VTK_IMAGE_STREAMS
#include "vtkMemoryResourceStream.h"
#endif
#include "vtkNew.h"
#include "vtkPNGReader.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <sstream>
#include <vector>

namespace relievo
{
namespace
{
bool Begins(const std::vector<unsigned char>& bytes, const std::vector<unsigned char>& with)
{
  return bytes.size() >= with.size() && std::equal(with.begin(), with.end(), bytes.begin());
}

// What the reader has against the bytes is not printed: whoever asked says it.
void Hear(vtkObject*, unsigned long, void* heard, void*)
{
  *static_cast<bool*>(heard) = true;
}

vtkSmartPointer<vtkImageData> Read(
  vtkImageReader2* reader, const std::vector<unsigned char>& bytes, std::string& wrong)
{
  bool trouble = false;
  vtkNew<vtkCallbackCommand> hear;
  hear->SetCallback(Hear);
  hear->SetClientData(&trouble);
  for (vtkObject* speaker :
    { static_cast<vtkObject*>(reader), static_cast<vtkObject*>(reader->GetExecutive()) })
  {
    speaker->AddObserver(vtkCommand::ErrorEvent, hear);
  }
#ifdef RELIEVO_VTK_IMAGE_STREAMS
  vtkNew<vtkMemoryResourceStream> stream;
  stream->SetBuffer(bytes.data(), bytes.size());
  reader->SetStream(stream);
#else
  reader->SetMemoryBuffer(bytes.data());
  reader->SetMemoryBufferLength(static_cast<vtkIdType>(bytes.size()));
#endif
  try
  {
    reader->Update();
  }
  catch (const std::exception&) // sizes that there is no memory for
  {
    trouble = true;
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->ShallowCopy(reader->GetOutput());
  if (trouble || image->GetNumberOfPoints() == 0 || !image->GetPointData()->GetScalars())
  {
    wrong = "it is damaged";
    return nullptr;
  }
  return image;
}

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
vtkSmartPointer<vtkImageData> DecodeImage(const ModelImage& image, std::string& wrong)
{
  wrong.clear();
  if (image.Width > 0)
  {
    return MakeImage(image);
  }
  if (Begins(image.Bytes, { 0x89, 'P', 'N', 'G', 0x0D, 0x0A, 0x1A, 0x0A }))
  {
    std::istringstream stream(std::string(image.Bytes.begin(), image.Bytes.end()));
    wrong = vtkRelievoFindPngDamage(stream);
    return wrong.empty() ? Read(vtkNew<vtkPNGReader>(), image.Bytes, wrong) : nullptr;
  }
  if (Begins(image.Bytes, { 0xFF, 0xD8, 0xFF }))
  {
    return Read(vtkNew<vtkJPEGReader>(), image.Bytes, wrong);
  }
  wrong = "it is neither PNG nor JPEG";
  return nullptr;
}
}
