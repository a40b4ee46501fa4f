// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Portable Network Graphics (ISO/IEC 15948) by VTK's libpng: all kinds of colour and depth,
// interlaced or not. Transparency of a palette or of one colour becomes an alpha component.
#include "vtkRelievoImageBytes.h"

#include "vtkRelievoImageFile.h"
#include "vtk_png.h"

#include <algorithm>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <vector>

namespace relievo::image
{
namespace
{
struct PNGReader
{
  png_structp Library = nullptr;
  png_infop Info = nullptr;
  const unsigned char* At;
  const unsigned char* End;
  std::size_t RowBytes = 0; // of an unpacked row of the file
  bool Cut = false;
  char Said[200] = ""; // the library's first message
};

void Say(PNGReader* reader, const char* text)
{
  if (reader->Said[0] == '\0')
  {
    std::snprintf(reader->Said, sizeof reader->Said, "%s", text);
  }
}

[[noreturn]] void Leave(png_structp library, png_const_charp text)
{
  Say(static_cast<PNGReader*>(png_get_error_ptr(library)), text);
  png_longjmp(library, 1);
}

void Hear(png_structp library, png_const_charp text)
{
  Say(static_cast<PNGReader*>(png_get_error_ptr(library)), text);
  if (std::strncmp(text, "tRNS", 4) == 0) // the library would draw the image opaque
  {
    Leave(library, text);
  }
}

void Give(png_structp library, png_bytep to, std::size_t size)
{
  auto* reader = static_cast<PNGReader*>(png_get_io_ptr(library));
  if (size > static_cast<std::size_t>(reader->End - reader->At))
  {
    reader->Cut = true;
    png_longjmp(library, 1);
  }
  std::memcpy(to, reader->At, size);
  reader->At += size;
}

// No object with a destructor may live after setjmp: errors jump over destructors.
bool Begin(PNGReader* reader)
{
  png_structp library = reader->Library;
  if (setjmp(png_jmpbuf(library)))
  {
    return false;
  }
  png_set_read_fn(library, reader, Give);
  constexpr auto most = static_cast<png_uint_32>(vtkRelievoImageFile::MostTexels);
  png_set_user_limits(library, most, most);
  png_set_crc_action(library, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
  // The only optional chunk that is read is transparency: neither gamma nor profiles apply.
  png_set_keep_unknown_chunks(library, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
  png_read_info(library, reader->Info);
  reader->RowBytes = png_get_rowbytes(library, reader->Info);
  png_set_packing(library);
  if (png_get_color_type(library, reader->Info) != PNG_COLOR_TYPE_PALETTE)
  {
    png_set_expand(library);
  }
  const std::uint16_t one = 1;
  if (*reinterpret_cast<const unsigned char*>(&one) == 1) // PNG has the high byte first
  {
    png_set_swap(library);
  }
  png_set_interlace_handling(library);
  png_read_update_info(library, reader->Info);
  return true;
}

bool ReadRows(PNGReader* reader, png_bytepp rows)
{
  if (setjmp(png_jmpbuf(reader->Library)))
  {
    return false;
  }
  png_read_image(reader->Library, rows);
  png_read_end(reader->Library, reader->Info);
  return true;
}

[[noreturn]] void ThrowSaid(const PNGReader& reader)
{
  if (reader.Cut)
  {
    ThrowCut();
  }
  throw Failure(std::string("it is damaged (") + reader.Said + ")");
}

// The library does not check the indices of a palette.
vtkSmartPointer<vtkImageData> FromPalette(const PNGReader& reader, vtkImageData* indices)
{
  png_colorp colors = nullptr;
  png_bytep alphas = nullptr;
  int count = 0;
  int alphaCount = 0;
  png_get_PLTE(reader.Library, reader.Info, &colors, &count);
  png_get_tRNS(reader.Library, reader.Info, &alphas, &alphaCount, nullptr);
  const int components = alphas ? 4 : 3;
  const int* size = indices->GetDimensions();
  auto image = MakeImage(size[0], size[1], VTK_UNSIGNED_CHAR, components);
  const auto* from = static_cast<const unsigned char*>(indices->GetScalarPointer());
  auto* to = static_cast<unsigned char*>(image->GetScalarPointer());
  const auto* end = from + indices->GetNumberOfPoints();
  for (; from != end; ++from, to += components)
  {
    if (*from >= count)
    {
      throw Failure("it has colours that are not in its palette");
    }
    const png_color& color = colors[*from];
    to[0] = color.red;
    to[1] = color.green;
    to[2] = color.blue;
    if (alphas)
    {
      to[3] = *from < alphaCount ? alphas[*from] : 255;
    }
  }
  return image;
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> DecodePNG(const Bytes& bytes)
{
  if (!bytes.From(12).BeginsWith("IHDR"))
  {
    throw Failure("it lacks its header");
  }
  CheckSize(bytes.Big32(16), bytes.Big32(20), 1, 1);
  PNGReader reader;
  reader.At = bytes.Data();
  reader.End = bytes.Data() + bytes.Size();
  struct Guard
  {
    PNGReader& Owner;
    ~Guard() { png_destroy_read_struct(&this->Owner.Library, &this->Owner.Info, nullptr); }
  } const guard{ reader };
  reader.Library = png_create_read_struct(PNG_LIBPNG_VER_STRING, &reader, Leave, Hear);
  reader.Info = reader.Library ? png_create_info_struct(reader.Library) : nullptr;
  if (!reader.Info)
  {
    throw Failure("there is no memory for it");
  }
  if (!Begin(&reader))
  {
    ThrowSaid(reader);
  }
  const std::uint64_t width = png_get_image_width(reader.Library, reader.Info);
  const std::uint64_t height = png_get_image_height(reader.Library, reader.Info);
  // Before memory is allocated: deflate packs data to no less than 1/1032 of their size.
  if (reader.RowBytes * height > 1032 * bytes.Size() + height)
  {
    ThrowCut();
  }
  const bool deep = png_get_bit_depth(reader.Library, reader.Info) == 16;
  auto image = MakeImage(width, height, deep ? VTK_UNSIGNED_SHORT : VTK_UNSIGNED_CHAR,
    png_get_channels(reader.Library, reader.Info));
  std::vector<png_bytep> rows(height);
  for (std::size_t y = 0; y < rows.size(); ++y)
  {
    rows[y] = Row<unsigned char>(image, height - 1 - y);
  }
  if (!ReadRows(&reader, rows.data()))
  {
    ThrowSaid(reader);
  }
  const bool palette = png_get_color_type(reader.Library, reader.Info) == PNG_COLOR_TYPE_PALETTE;
  return palette ? FromPalette(reader, image) : image;
}
}
