// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// TIFF by VTK's library: the first image of a file, in strips or tiles, planes together or apart,
// turned by its orientation tag. 1 to 8 bits become unsigned char, 16 bits unsigned short, signed
// and longer numbers float. Grey, RGB and palettes keep their samples; other colour spaces become
// RGB of 8 bits. The values of a raster of the world become double.
#include "vtkRelievoGeoTags.h"
#include "vtkRelievoImageBytes.h"

#include "vtk_tiff.h"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <memory>
#include <vector>

namespace relievo::image
{
namespace
{
constexpr std::int64_t MostAtOnce = std::int64_t(1) << 30; // bytes per strip or tile

// The file in memory, and the library's first message.
struct Source
{
  Bytes File;
  std::uint64_t At = 0;
  std::string Said;
};

tmsize_t ReadBytes(thandle_t handle, void* to, tmsize_t size)
{
  auto* source = static_cast<Source*>(handle);
  const std::uint64_t left =
    source->File.Size() - std::min<std::uint64_t>(source->At, source->File.Size());
  const std::uint64_t count = std::min<std::uint64_t>(left, static_cast<std::uint64_t>(size));
  if (count > 0)
  {
    std::memcpy(to, source->File.Data() + source->At, count);
  }
  source->At += count;
  return static_cast<tmsize_t>(count);
}

tmsize_t WriteBytes(thandle_t, void*, tmsize_t)
{
  return -1;
}

toff_t SeekBytes(thandle_t handle, toff_t offset, int whence)
{
  auto* source = static_cast<Source*>(handle);
  source->At = whence == SEEK_CUR ? source->At + offset
    : whence == SEEK_END          ? source->File.Size() + offset
                                  : offset;
  return source->At;
}

int CloseBytes(thandle_t)
{
  return 0;
}

toff_t SizeOf(thandle_t handle)
{
  return static_cast<Source*>(handle)->File.Size();
}

int Hear(TIFF*, void* kept, const char*, const char* format, va_list arguments)
{
  auto* source = static_cast<Source*>(kept);
  if (source->Said.empty())
  {
    char text[500];
    std::vsnprintf(text, sizeof(text), format, arguments);
    source->Said = text;
    source->Said.erase(source->Said.find_last_not_of(". ") + 1);
  }
  return 1;
}

int Overhear(TIFF*, void*, const char*, const char*, va_list)
{
  return 1;
}

[[noreturn]] void ThrowSaid(const Source& source)
{
  throw Failure(source.Said.empty() ? "it is damaged" : "it is damaged (" + source.Said + ")");
}

struct Closer
{
  void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};
using Handle = std::unique_ptr<TIFF, Closer>;

Handle Open(Source& source)
{
  TIFFOpenOptions* options = TIFFOpenOptionsAlloc();
  TIFFOpenOptionsSetErrorHandlerExtR(options, Hear, &source);
  TIFFOpenOptionsSetWarningHandlerExtR(options, Overhear, nullptr);
  TIFFOpenOptionsSetMaxSingleMemAlloc(options, MostAtOnce);
  Handle tiff(TIFFClientOpenExt("image", "rm", &source, ReadBytes, WriteBytes, SeekBytes,
    CloseBytes, SizeOf, nullptr, nullptr, options));
  TIFFOpenOptionsFree(options);
  if (!tiff)
  {
    ThrowSaid(source);
  }
  return tiff;
}

struct Layout
{
  std::uint32_t Width = 0;
  std::uint32_t Height = 0;
  int Bits = 1;
  int Samples = 1; // per pixel, in the file
  int Format = SAMPLEFORMAT_UINT;
  int Photometric = PHOTOMETRIC_MINISBLACK;
  bool Apart = false; // a plane for each sample
  int Orientation = ORIENTATION_TOPLEFT;
  int Components = 1; // in the output
  int Type = VTK_UNSIGNED_CHAR;
  double Missing = 0.0; // the samples of blocks that a sparse raster lacks

  bool KeepsSamples() const
  {
    return this->Photometric == PHOTOMETRIC_MINISBLACK ||
      this->Photometric == PHOTOMETRIC_MINISWHITE || this->Photometric == PHOTOMETRIC_RGB ||
      this->Photometric == PHOTOMETRIC_PALETTE;
  }
};

int Get16(TIFF* tiff, std::uint32_t tag, int otherwise)
{
  std::uint16_t value = 0;
  return TIFFGetFieldDefaulted(tiff, tag, &value) ? value : otherwise;
}

Layout ReadLayout(TIFF* tiff)
{
  Layout layout;
  TIFFGetField(tiff, TIFFTAG_IMAGEWIDTH, &layout.Width);
  TIFFGetField(tiff, TIFFTAG_IMAGELENGTH, &layout.Height);
  layout.Bits = Get16(tiff, TIFFTAG_BITSPERSAMPLE, 1);
  layout.Samples = Get16(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
  layout.Format = Get16(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT);
  layout.Format = layout.Format == SAMPLEFORMAT_VOID ? SAMPLEFORMAT_UINT : layout.Format;
  layout.Photometric = Get16(
    tiff, TIFFTAG_PHOTOMETRIC, layout.Samples >= 3 ? PHOTOMETRIC_RGB : PHOTOMETRIC_MINISBLACK);
  layout.Apart = Get16(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG) == PLANARCONFIG_SEPARATE;
  layout.Orientation = Get16(tiff, TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);
  if (Get16(tiff, TIFFTAG_COMPRESSION, COMPRESSION_NONE) == COMPRESSION_JPEG && !layout.Apart &&
    layout.Photometric == PHOTOMETRIC_YCBCR)
  {
    TIFFSetField(tiff, TIFFTAG_JPEGCOLORMODE, JPEGCOLORMODE_RGB);
    layout.Photometric = PHOTOMETRIC_RGB;
  }
  if (!layout.KeepsSamples())
  {
    layout.Components = 3;
    return layout;
  }
  const bool whole = layout.Format == SAMPLEFORMAT_UINT;
  const bool known = whole ? layout.Bits == 1 || layout.Bits == 2 || layout.Bits == 4 ||
      layout.Bits == 8 || layout.Bits == 16 || layout.Bits == 32
    : layout.Format == SAMPLEFORMAT_INT
    ? layout.Bits == 8 || layout.Bits == 16 || layout.Bits == 32
    : layout.Format == SAMPLEFORMAT_IEEEFP && (layout.Bits == 32 || layout.Bits == 64);
  const bool palette = layout.Photometric == PHOTOMETRIC_PALETTE;
  const int colors = layout.Photometric == PHOTOMETRIC_RGB ? 3 : 1;
  if (!known || layout.Samples < colors || (palette && (!whole || layout.Bits > 8)))
  {
    throw Failure("it is a kind of TIFF that is not read (" + std::to_string(layout.Samples) +
      " samples of " + std::to_string(layout.Bits) + " bits, format " +
      std::to_string(layout.Format) + ")");
  }
  layout.Components = palette ? 3 : std::min(layout.Samples, colors + 1);
  layout.Type = !whole || layout.Bits > 16 ? VTK_FLOAT
    : layout.Bits == 16                    ? VTK_UNSIGNED_SHORT
                                           : VTK_UNSIGNED_CHAR;
  return layout;
}

template <typename T>
T ReadAs(const unsigned char* from)
{
  T value;
  std::memcpy(&value, from, sizeof(T));
  return value;
}

// A sample as a number, in the machine's byte order thanks to the library.
double SampleOf(const Layout& layout, const unsigned char* row, std::size_t at)
{
  const std::size_t bit = at * layout.Bits;
  const unsigned char* from = row + bit / 8;
  if (layout.Format == SAMPLEFORMAT_IEEEFP)
  {
    return layout.Bits == 32 ? ReadAs<float>(from) : ReadAs<double>(from);
  }
  if (layout.Format == SAMPLEFORMAT_INT)
  {
    return layout.Bits == 8 ? ReadAs<std::int8_t>(from)
      : layout.Bits == 16   ? ReadAs<std::int16_t>(from)
                            : ReadAs<std::int32_t>(from);
  }
  return layout.Bits == 32 ? ReadAs<std::uint32_t>(from)
    : layout.Bits == 16    ? ReadAs<std::uint16_t>(from)
                           : (*from >> (8 - layout.Bits - bit % 8)) & ((1 << layout.Bits) - 1);
}

// Converts samples: palettes to colours, others unchanged.
class Placer
{
public:
  Placer(TIFF* tiff, const Layout& layout)
    : Shape(layout)
  {
    this->Most = layout.Format == SAMPLEFORMAT_UINT ? std::pow(2., layout.Bits) - 1. : 1.;
    if (layout.Photometric != PHOTOMETRIC_PALETTE)
    {
      return;
    }
    std::uint16_t* tables[3] = {};
    if (!TIFFGetField(tiff, TIFFTAG_COLORMAP, &tables[0], &tables[1], &tables[2]))
    {
      throw Failure("it lacks its palette");
    }
    const int colors = 1 << layout.Bits;
    const bool bytes = std::all_of(tables, tables + 3, [colors](const std::uint16_t* table) {
      return std::all_of(table, table + colors, [](std::uint16_t value) { return value < 256; });
    });
    for (int i = 0; i < colors; ++i)
    {
      for (const std::uint16_t* table : tables)
      {
        this->Colors.push_back(static_cast<unsigned char>(bytes ? table[i] : table[i] >> 8));
      }
    }
  }

  template <typename T>
  void Put(const unsigned char* row, std::size_t at, int component, T* to) const
  {
    const double value = SampleOf(this->Shape, row, at);
    if (!this->Colors.empty())
    {
      std::copy_n(this->Colors.data() + 3 * static_cast<std::size_t>(value), 3, to);
      return;
    }
    const bool inverted = this->Shape.Photometric == PHOTOMETRIC_MINISWHITE && component == 0;
    const double kept = inverted ? this->Most - value : value;
    to[component] = static_cast<T>(this->Shape.Bits < 8 ? kept * 255. / this->Most : kept);
  }

private:
  const Layout& Shape;
  double Most; // the largest possible sample
  std::vector<unsigned char> Colors;
};

struct Block
{
  std::uint32_t X, Y, Width, Height;
  std::vector<unsigned char> Data;
  std::size_t RowSize;
};

template <typename T>
void PutBlock(
  const Layout& layout, const Placer& placer, const Block& block, int plane, vtkImageData* image)
{
  const std::uint32_t right = std::min(layout.Width, block.X + block.Width);
  const std::uint32_t bottom = std::min(layout.Height, block.Y + block.Height);
  const int stored = layout.Apart ? 1 : layout.Samples;
  const int kept = layout.Apart                 ? 1
    : layout.Photometric == PHOTOMETRIC_PALETTE ? 1
                                                : layout.Components;
  for (std::uint32_t y = block.Y; y < bottom; ++y)
  {
    const unsigned char* row = block.Data.data() + block.RowSize * (y - block.Y);
    T* to =
      Row<T>(image, layout.Height - 1 - y) + static_cast<std::size_t>(block.X) * layout.Components;
    for (std::uint32_t x = block.X; x < right; ++x, to += layout.Components)
    {
      for (int c = 0; c < kept; ++c)
      {
        placer.Put(
          row, static_cast<std::size_t>(x - block.X) * stored + c, layout.Apart ? plane : c, to);
      }
    }
  }
}

void FillBlock(const Layout& layout, const Block& block, vtkImageData* image)
{
  const std::uint32_t width = std::min(block.Width, layout.Width - block.X);
  const std::uint32_t bottom = std::min(layout.Height, block.Y + block.Height);
  for (std::uint32_t y = block.Y; y < bottom; ++y)
  {
    std::fill_n(Row<double>(image, layout.Height - 1 - y) + block.X, width, layout.Missing);
  }
}

void ReadSamples(TIFF* tiff, const Source& source, const Layout& layout, vtkImageData* image)
{
  const Placer placer(tiff, layout);
  const bool tiled = TIFFIsTiled(tiff) != 0;
  Block block;
  block.Width = layout.Width;
  block.Height = layout.Height;
  TIFFGetFieldDefaulted(tiff, tiled ? TIFFTAG_TILELENGTH : TIFFTAG_ROWSPERSTRIP, &block.Height);
  if (tiled)
  {
    TIFFGetField(tiff, TIFFTAG_TILEWIDTH, &block.Width);
  }
  block.Height = tiled ? block.Height : std::min(block.Height, layout.Height);
  const tmsize_t size = tiled ? TIFFTileSize(tiff) : TIFFStripSize(tiff);
  const tmsize_t rowSize = tiled ? TIFFTileRowSize(tiff) : TIFFScanlineSize(tiff);
  const std::uint64_t rowBits =
    static_cast<std::uint64_t>(block.Width) * layout.Bits * (layout.Apart ? 1 : layout.Samples);
  if (block.Width == 0 || block.Height == 0 || size <= 0 || size > MostAtOnce ||
    static_cast<std::uint64_t>(rowSize) * 8 < rowBits ||
    static_cast<std::uint64_t>(size) < static_cast<std::uint64_t>(rowSize) * block.Height)
  {
    ThrowSaid(source);
  }
  block.RowSize = static_cast<std::size_t>(rowSize);
  block.Data.resize(static_cast<std::size_t>(size));
  const std::uint64_t* offsets = nullptr;
  const std::uint64_t* sizes = nullptr;
  TIFFGetField(tiff, tiled ? TIFFTAG_TILEOFFSETS : TIFFTAG_STRIPOFFSETS, &offsets);
  TIFFGetField(tiff, tiled ? TIFFTAG_TILEBYTECOUNTS : TIFFTAG_STRIPBYTECOUNTS, &sizes);
  const std::uint32_t stored = tiled ? TIFFNumberOfTiles(tiff) : TIFFNumberOfStrips(tiff);
  for (int plane = 0; plane < (layout.Apart ? layout.Components : 1); ++plane)
  {
    for (std::uint64_t y = 0; y < layout.Height; y += block.Height)
    {
      for (std::uint64_t x = 0; x < layout.Width; x += block.Width)
      {
        block.X = static_cast<std::uint32_t>(x);
        block.Y = static_cast<std::uint32_t>(y);
        const auto sample = static_cast<std::uint16_t>(plane);
        const std::uint32_t index = tiled ? TIFFComputeTile(tiff, block.X, block.Y, 0, sample)
                                          : TIFFComputeStrip(tiff, block.Y, sample);
        if (offsets && index < stored && offsets[index] == 0) // the library would read the header
        {
          if (!sizes || sizes[index] != 0)
          {
            ThrowSaid(source);
          }
          if (layout.Type != VTK_DOUBLE)
          {
            throw Failure("it is sparse, without some of its blocks; fill them by gdal_translate");
          }
          FillBlock(layout, block, image);
          continue;
        }
        const tmsize_t got = tiled ? TIFFReadEncodedTile(tiff, index, block.Data.data(), size)
                                   : TIFFReadEncodedStrip(tiff, index, block.Data.data(), size);
        const std::uint64_t rows = std::min<std::uint64_t>(block.Height, layout.Height - y);
        if (got < 0 || static_cast<std::uint64_t>(got) < rows * block.RowSize)
        {
          ThrowSaid(source);
        }
        if (layout.Type == VTK_DOUBLE)
        {
          PutBlock<double>(layout, placer, block, plane, image);
        }
        else if (layout.Type == VTK_FLOAT)
        {
          PutBlock<float>(layout, placer, block, plane, image);
        }
        else if (layout.Type == VTK_UNSIGNED_SHORT)
        {
          PutBlock<unsigned short>(layout, placer, block, plane, image);
        }
        else
        {
          PutBlock<unsigned char>(layout, placer, block, plane, image);
        }
      }
    }
  }
}

// A value as a sample, by GDAL's rules: rounded and clamped, and NaN as the integer 0.
double ToSample(const Layout& layout, double value)
{
  if (layout.Format == SAMPLEFORMAT_IEEEFP)
  {
    return layout.Bits == 32 ? static_cast<float>(value) : value;
  }
  const double count = std::pow(2., layout.Bits);
  const double least = layout.Format == SAMPLEFORMAT_INT ? -count / 2. : 0.;
  return std::isnan(value) ? 0. : std::clamp(std::round(value), least, least + count - 1.);
}

// CMYK, L*a*b*, YCbCr, logarithms: converted by the library.
void ReadColors(TIFF* tiff, const Source& source, const Layout& layout, vtkImageData* image)
{
  char text[1024] = {};
  TIFFRGBAImage shown{};
  if (!TIFFRGBAImageOK(tiff, text) || !TIFFRGBAImageBegin(&shown, tiff, 1, text))
  {
    throw Failure(std::string("it is a kind of TIFF that is not read (") + text + ")");
  }
  shown.orientation = ORIENTATION_TOPLEFT; // we turn it: our code knows all eight
  shown.req_orientation = ORIENTATION_BOTLEFT;
  std::vector<std::uint32_t> texels(static_cast<std::size_t>(layout.Width) * layout.Height);
  const bool read = TIFFRGBAImageGet(&shown, texels.data(), layout.Width, layout.Height) != 0;
  TIFFRGBAImageEnd(&shown);
  if (!read)
  {
    ThrowSaid(source);
  }
  auto* to = static_cast<unsigned char*>(image->GetScalarPointer());
  for (const std::uint32_t texel : texels)
  {
    *to++ = static_cast<unsigned char>(TIFFGetR(texel));
    *to++ = static_cast<unsigned char>(TIFFGetG(texel));
    *to++ = static_cast<unsigned char>(TIFFGetB(texel));
  }
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> DecodeTIFF(const Bytes& bytes)
{
  Source source{ bytes, 0, {} };
  const Handle tiff = Open(source);
  const Layout layout = ReadLayout(tiff.get());
  auto image = MakeImage(layout.Width, layout.Height, layout.Type, layout.Components);
  if (layout.KeepsSamples())
  {
    ReadSamples(tiff.get(), source, layout, image);
  }
  else
  {
    ReadColors(tiff.get(), source, layout, image);
  }
  return Orient(image, layout.Orientation);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> DecodeRaster(const Bytes& bytes, GeoTags& tags)
{
  Source source{ bytes, 0, {} };
  const Handle tiff = Open(source);
  Layout layout = ReadLayout(tiff.get());
  if (!GeoTags::IsRaster(layout.Photometric, layout.Bits))
  {
    throw Failure("it is a picture, in colours or of few bits");
  }
  layout.Components = 1;
  layout.Type = VTK_DOUBLE;
  tags.Read(tiff.get());
  layout.Missing = ToSample(layout, tags.FindNoData().value_or(0.));
  auto image = MakeImage(layout.Width, layout.Height, layout.Type, layout.Components);
  ReadSamples(tiff.get(), source, layout, image);
  return image;
}
}
