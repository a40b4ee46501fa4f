// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Shared by the image decoders: bytes with checked ends, images of limited size, and errors as
// text.
#ifndef vtkRelievoImageBytes_h
#define vtkRelievoImageBytes_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace relievo::image
{
// The problem of an image, as the end of a sentence whose subject is the image.
struct Failure : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

[[noreturn]] inline void ThrowCut()
{
  throw Failure("it ends too early");
}

// A part of a file in memory, without ownership.
class Bytes
{
public:
  Bytes(const unsigned char* data, std::size_t size)
    : First(data)
    , Length(size)
  {
  }

  const unsigned char* Data() const { return this->First; }
  std::size_t Size() const { return this->Length; }
  unsigned char operator[](std::size_t at) const
  {
    return at < this->Length ? this->First[at] : (ThrowCut(), '\0');
  }
  // Throws Failure if the part exceeds the bytes.
  Bytes Part(std::size_t at, std::size_t size) const
  {
    if (at > this->Length || size > this->Length - at)
    {
      ThrowCut();
    }
    return { this->First + at, size };
  }
  Bytes From(std::size_t at) const
  {
    return at > this->Length ? (ThrowCut(), *this) : Bytes(this->First + at, this->Length - at);
  }
  bool BeginsWith(const std::string& text) const
  {
    return this->Length >= text.size() &&
      std::equal(text.begin(), text.end(), reinterpret_cast<const char*>(this->First));
  }
  std::uint32_t Little16(std::size_t at) const
  {
    const Bytes two = this->Part(at, 2);
    return two.First[0] | (two.First[1] << 8);
  }
  std::uint32_t Little32(std::size_t at) const
  {
    return this->Little16(at) | (this->Part(at, 4).Little16(2) << 16);
  }
  std::uint32_t Big16(std::size_t at) const
  {
    const Bytes two = this->Part(at, 2);
    return (two.First[0] << 8) | two.First[1];
  }
  std::uint32_t Big32(std::size_t at) const
  {
    return (this->Big16(at) << 16) | this->Part(at, 4).Big16(2);
  }

private:
  const unsigned char* First;
  std::size_t Length;
};

// Throws Failure for sizes of 0 and for images beyond the limits of vtkRelievoImageFile.
void CheckSize(std::uint64_t width, std::uint64_t height, int components, int bytesOfComponent);

// An image of this size with uninitialised scalars. Throws as CheckSize does.
vtkSmartPointer<vtkImageData> MakeImage(
  std::uint64_t width, std::uint64_t height, int type, int components);

// The scalars of a row; row 0 is at the bottom.
template <typename T>
T* Row(vtkImageData* image, std::uint64_t row)
{
  return static_cast<T*>(image->GetScalarPointer(0, static_cast<int>(row), 0));
}

// The image turned by the orientation of TIFF and EXIF, 1 to 8: the sides of its row 0 and column 0
// (1: top and left). Other numbers count as 1.
vtkSmartPointer<vtkImageData> Orient(vtkImageData* image, int orientation);

// One for each format. They throw Failure. VTK's libpng, libjpeg and libtiff decode the first
// three. VTK's readers of the others cannot replace these: of the files of testImageFiles.py,
// vtkBMPReader decodes 3 of 8 right (VTK 9.2 crashes on palettes of 1 and 4 bits), vtkTGAReader 4
// of 11, and vtkHDRReader 6 of 11 with VTK 9.2 and none with 9.7. They also read only files, and
// images within a model are bytes.
vtkSmartPointer<vtkImageData> DecodePNG(const Bytes& bytes);
vtkSmartPointer<vtkImageData> DecodeJPEG(const Bytes& bytes);
vtkSmartPointer<vtkImageData> DecodeTIFF(const Bytes& bytes);
vtkSmartPointer<vtkImageData> DecodeBMP(const Bytes& bytes);
vtkSmartPointer<vtkImageData> DecodeTGA(const Bytes& bytes);
vtkSmartPointer<vtkImageData> DecodeHDR(const Bytes& bytes);

// The first band of a raster of the world, in double, and its tags. Throws Failure.
struct GeoTags;
vtkSmartPointer<vtkImageData> DecodeRaster(const Bytes& bytes, GeoTags& tags);
}

#endif
