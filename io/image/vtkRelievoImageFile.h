// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Pictures in files and in memory, for maps, textures and environments: PNG, JPEG, TIFF, BMP, TGA,
// Radiance (hdr) and OpenEXR, detected by their first bytes. A damaged image is refused with a
// message, never read in part.
//
// Images have one slice, row 0 at the bottom, and the numbers of the file: unsigned char for up to
// 8 bits, unsigned short for 16, float for others; 1 component (grey), 2 (and alpha), 3 (RGB) or 4.
// Palettes become RGB or RGBA. TIFF is turned by its orientation; EXIF's in JPEG is not applied, as
// texture coordinates are made for the texels as stored. CMYK becomes RGB.
#ifndef vtkRelievoImageFile_h
#define vtkRelievoImageFile_h

#include "vtkImageData.h"
#include "vtkRelievoIOModule.h" // for the export macro
#include "vtkSmartPointer.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

namespace vtkRelievoImageFile
{
// Larger images are refused before memory is allocated for them.
constexpr std::uint64_t MostTexels = std::uint64_t(1) << 28; // as many as 16384 x 16384
constexpr std::uint64_t MostBytes = std::uint64_t(1) << 31;  // of the image, and of a file

// The extensions of image files, with `before` and `between` added: "*.png *.jpg".
VTKRELIEVOIO_EXPORT std::string ListExtensions(
  const std::string& before = "", const std::string& between = " ");

// Reads the image in a file. OpenEXR gives the picture of the display window, 0 where there are no
// data, from the channels R G B [A], r g b [a], Y [A] (grey) or else those of the first layer, of
// the first part. A file that is already in use as an image gives that image again, unless the file
// has changed since. nullptr if it cannot be read; `failure` then gives the expectation and the
// problem. `progress` gets the share of an OpenEXR file that is read, and returns whether to go on.
// `note`: what was left out, or empty. In our programs another process reads the file
// (vtkRelievoReaderProcess), and decodes Decode's bytes.
VTKRELIEVOIO_EXPORT vtkSmartPointer<vtkImageData> Read(const std::string& path,
  std::string& failure, const std::function<bool(double)>& progress = nullptr,
  std::string* note = nullptr);

// The image in memory, of any format but OpenEXR. `name` is that of a file, a MIME type, or empty:
// it is needed only for TGA, which cannot be detected by its first bytes. nullptr if it cannot be
// read; `failure` is then as for Read.
VTKRELIEVOIO_EXPORT vtkSmartPointer<vtkImageData> Decode(
  const void* bytes, std::size_t size, const std::string& name, std::string& failure);

// The image as colours for vtkTexture, which maps all types but unsigned char through a table of
// colours: the image itself if it is unsigned char; 16 bits rounded to 8; floats, which are linear
// light, clamped to 0 .. 1 and encoded by the sRGB curve (alpha only rounded).
VTKRELIEVOIO_EXPORT vtkSmartPointer<vtkImageData> ToColors(vtkImageData* image);

// Whether the image is a cut-out: its alpha is 0 somewhere and maximal everywhere else.
VTKRELIEVOIO_EXPORT bool IsCutOut(vtkImageData* image);
}

#endif
