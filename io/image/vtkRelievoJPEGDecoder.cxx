// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// JPEG by VTK's library: grey, colour and CMYK, which becomes RGB as if inks were ideal. EXIF's
// orientation is not applied: maps are placed by texture coordinates, which are made for the texels
// as stored (glTF 2.0 requires this of its images).
#include "vtkRelievoImageBytes.h"

#include "vtk_jpeg.h"

#include <csetjmp>
#include <cstring>
#include <memory>
#include <vector>

namespace relievo::image
{
namespace
{
constexpr int MostScans = 500; // a small progressive image could otherwise take endlessly to decode

struct Reader
{
  jpeg_decompress_struct Info;
  jpeg_error_mgr Errors;
  jpeg_progress_mgr Progress;
  std::jmp_buf Jump;
  char Text[JMSG_LENGTH_MAX];
  bool Warned;
};

Reader* ReaderOf(j_common_ptr info)
{
  return static_cast<Reader*>(info->client_data);
}

void Leave(j_common_ptr info)
{
  Reader* reader = ReaderOf(info);
  if (!reader->Warned)
  {
    info->err->format_message(info, reader->Text);
  }
  std::longjmp(reader->Jump, 1);
}

// Levels below 0 are warnings of damaged data, which would be drawn grey.
void Hear(j_common_ptr info, int level)
{
  Reader* reader = ReaderOf(info);
  if (level < 0 && !reader->Warned)
  {
    info->err->format_message(info, reader->Text);
    reader->Warned = true;
  }
}

void Print(j_common_ptr) {}

void CountScans(j_common_ptr info)
{
  Reader* reader = ReaderOf(info);
  if (reader->Info.input_scan_number > MostScans)
  {
    std::strcpy(reader->Text, "more than 500 scans");
    reader->Warned = true;
    std::longjmp(reader->Jump, 1);
  }
}

// No object with a destructor may live after setjmp: errors jump over destructors.
bool Begin(Reader* reader, const Bytes& bytes)
{
  if (setjmp(reader->Jump))
  {
    return false;
  }
  jpeg_create_decompress(&reader->Info);
  reader->Info.client_data = reader;
  reader->Info.progress = &reader->Progress;
  // The parameter is not const in some versions.
  jpeg_mem_src(&reader->Info, const_cast<unsigned char*>(bytes.Data()),
    static_cast<unsigned long>(bytes.Size()));
  jpeg_read_header(&reader->Info, TRUE);
  return true;
}

bool ReadRows(Reader* reader, JSAMPROW* rows)
{
  if (setjmp(reader->Jump))
  {
    return false;
  }
  jpeg_start_decompress(&reader->Info);
  while (reader->Info.output_scanline < reader->Info.output_height)
  {
    jpeg_read_scanlines(&reader->Info, rows + reader->Info.output_scanline, 1);
  }
  jpeg_finish_decompress(&reader->Info);
  return true;
}

[[noreturn]] void ThrowSaid(const Reader& reader)
{
  const std::string text = reader.Text;
  if (text.find("Premature end") != std::string::npos)
  {
    ThrowCut();
  }
  throw Failure("it is damaged (" + text + ")");
}

// Adobe's programs, and others that mark their files alike, write inverted inks.
vtkSmartPointer<vtkImageData> FromInks(vtkImageData* inks, bool inverted)
{
  const int* size = inks->GetDimensions();
  auto image = MakeImage(size[0], size[1], VTK_UNSIGNED_CHAR, 3);
  const vtkIdType texels = image->GetNumberOfPoints();
  const auto* from = static_cast<const unsigned char*>(inks->GetScalarPointer());
  auto* to = static_cast<unsigned char*>(image->GetScalarPointer());
  for (vtkIdType i = 0; i < texels; ++i, from += 4, to += 3)
  {
    const int white = inverted ? from[3] : 255 - from[3];
    for (int c = 0; c < 3; ++c)
    {
      const int paper = inverted ? from[c] : 255 - from[c];
      to[c] = static_cast<unsigned char>((paper * white + 127) / 255);
    }
  }
  return image;
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> DecodeJPEG(const Bytes& bytes)
{
  const auto reader = std::make_unique<Reader>();
  std::memset(static_cast<void*>(reader.get()), 0, sizeof(Reader));
  reader->Info.err = jpeg_std_error(&reader->Errors);
  reader->Info.client_data = reader.get();
  reader->Errors.error_exit = Leave;
  reader->Errors.emit_message = Hear;
  reader->Errors.output_message = Print;
  reader->Progress.progress_monitor = CountScans;
  struct Guard
  {
    Reader* Owner;
    ~Guard() { jpeg_destroy_decompress(&this->Owner->Info); }
  } const guard{ reader.get() };
  if (!Begin(reader.get(), bytes))
  {
    ThrowSaid(*reader);
  }
  jpeg_decompress_struct& info = reader->Info;
  const bool inks = info.jpeg_color_space == JCS_CMYK || info.jpeg_color_space == JCS_YCCK;
  info.out_color_space = inks ? JCS_CMYK : info.num_components == 1 ? JCS_GRAYSCALE : JCS_RGB;
  const int components = inks ? 4 : info.num_components == 1 ? 1 : 3;
  auto image = MakeImage(info.image_width, info.image_height, VTK_UNSIGNED_CHAR, components);
  std::vector<JSAMPROW> rows(info.image_height);
  for (std::size_t y = 0; y < rows.size(); ++y)
  {
    rows[y] = Row<unsigned char>(image, rows.size() - 1 - y);
  }
  if (!ReadRows(reader.get(), rows.data()) || reader->Warned)
  {
    ThrowSaid(*reader);
  }
  return inks ? FromInks(image, info.saw_Adobe_marker != 0) : image;
}
}
