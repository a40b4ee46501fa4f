// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoGeoTags.h"

#include "vtkRelievoNumberText.h"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdint>
#include <cstring>
#include <system_error>

namespace relievo::image
{
namespace
{
constexpr ttag_t ScaleTag = 33550;
constexpr ttag_t TiesTag = 33922;
constexpr ttag_t MatrixTag = 34264;
constexpr ttag_t KeysTag = 34735;
constexpr ttag_t KeyNumbersTag = 34736;
constexpr ttag_t KeyTextTag = 34737;
constexpr ttag_t MetadataTag = 42112;
constexpr ttag_t NoDataTag = 42113;
constexpr tmsize_t MostOfTags = 1 << 24; // bytes of one

// The values of a tag of this type. How libtiff gives them depends on who has declared the tag: the
// file itself, or a library that extends libtiff in this process, such as GDAL.
const void* Find(TIFF* tiff, ttag_t tag, TIFFDataType type, std::uint32_t& count)
{
  const TIFFField* field = TIFFFindField(tiff, tag, TIFF_ANY);
  const void* data = nullptr;
  if (!field || TIFFFieldDataType(field) != type)
  {
    return nullptr;
  }
  if (!TIFFFieldPassCount(field))
  {
    // Only texts, which end with a zero.
    return type == TIFF_ASCII && TIFFGetField(tiff, tag, &data) ? data : nullptr;
  }
  if (TIFFFieldReadCount(field) == TIFF_VARIABLE2)
  {
    return TIFFGetField(tiff, tag, &count, &data) ? data : nullptr;
  }
  std::uint16_t few = 0;
  const bool isThere = TIFFGetField(tiff, tag, &few, &data) != 0;
  count = few;
  return isThere ? data : nullptr;
}

template <typename T>
void ReadArray(TIFF* tiff, ttag_t tag, TIFFDataType type, std::vector<T>& values)
{
  std::uint32_t count = 0;
  if (const auto* data = static_cast<const T*>(Find(tiff, tag, type, count)))
  {
    values.assign(data, data + count);
  }
}

void ReadText(TIFF* tiff, ttag_t tag, std::string& text)
{
  std::uint32_t count = 0;
  if (const auto* data = static_cast<const char*>(Find(tiff, tag, TIFF_ASCII, count)))
  {
    text = count > 0 ? std::string(data, strnlen(data, count)) : std::string(data);
  }
}

int SayNothing(TIFF*, void*, const char*, const char*, va_list)
{
  return 1;
}

template <typename T>
void WriteArray(TIFF* tiff, ttag_t tag, const std::vector<T>& values)
{
  if (!values.empty())
  {
    TIFFSetField(tiff, tag, static_cast<std::uint32_t>(values.size()), values.data());
  }
}

void WriteText(TIFF* tiff, ttag_t tag, const std::string& text)
{
  if (!text.empty())
  {
    TIFFSetField(tiff, tag, text.c_str());
  }
}
}

//------------------------------------------------------------------------------
std::optional<double> GeoTags::FindNoData() const
{
  const char* end = this->NoData.data() + this->NoData.size();
  const char* begin =
    std::find_if(this->NoData.data(), end, [](char letter) { return letter != ' '; });
  double value = 0.0;
  const std::errc error = vtkRelievoReadNumber(begin, end, value).ec;
  if (error == std::errc::result_out_of_range) // too large
  {
    return *begin == '-' ? -HUGE_VAL : HUGE_VAL;
  }
  return error == std::errc() ? std::optional<double>(value) : std::nullopt;
}

//------------------------------------------------------------------------------
std::optional<GeoTags> GeoTags::Find(const char* file)
{
  TIFFOpenOptions* options = TIFFOpenOptionsAlloc();
  TIFFOpenOptionsSetMaxSingleMemAlloc(options, MostOfTags);
  TIFFOpenOptionsSetErrorHandlerExtR(options, SayNothing, nullptr);
  TIFFOpenOptionsSetWarningHandlerExtR(options, SayNothing, nullptr);
  TIFF* tiff = TIFFOpenExt(file, "r", options);
  TIFFOpenOptionsFree(options);
  if (!tiff)
  {
    return std::nullopt;
  }
  GeoTags tags;
  tags.Read(tiff);
  std::uint16_t samples = 1;
  std::uint16_t bits = 1;
  TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLESPERPIXEL, &samples);
  TIFFGetFieldDefaulted(tiff, TIFFTAG_BITSPERSAMPLE, &bits);
  std::uint16_t kind = samples >= 3 ? PHOTOMETRIC_RGB : PHOTOMETRIC_MINISBLACK;
  TIFFGetField(tiff, TIFFTAG_PHOTOMETRIC, &kind);
  TIFFClose(tiff);
  if (!IsRaster(kind, bits) || !(tags.HasMatrix() || tags.HasTie()))
  {
    return std::nullopt;
  }
  return tags;
}

//------------------------------------------------------------------------------
void GeoTags::Read(TIFF* tiff)
{
  ReadArray(tiff, ScaleTag, TIFF_DOUBLE, this->Scale);
  ReadArray(tiff, TiesTag, TIFF_DOUBLE, this->Ties);
  ReadArray(tiff, MatrixTag, TIFF_DOUBLE, this->Matrix);
  ReadArray(tiff, KeysTag, TIFF_SHORT, this->Keys);
  ReadArray(tiff, KeyNumbersTag, TIFF_DOUBLE, this->KeyNumbers);
  ReadText(tiff, KeyTextTag, this->KeyText);
  ReadText(tiff, MetadataTag, this->Metadata);
  ReadText(tiff, NoDataTag, this->NoData);
}

//------------------------------------------------------------------------------
void GeoTags::Write(TIFF* tiff) const
{
  constexpr short any = TIFF_VARIABLE2;
  constexpr short text = TIFF_VARIABLE;
  static char names[][20] = { "ModelPixelScale", "ModelTiepoint", "ModelTransformation",
    "GeoKeyDirectory", "GeoDoubleParams", "GeoAsciiParams", "GDAL_METADATA", "GDAL_NODATA" };
  static const TIFFFieldInfo fields[] = {
    { ScaleTag, any, any, TIFF_DOUBLE, FIELD_CUSTOM, 1, 1, names[0] },
    { TiesTag, any, any, TIFF_DOUBLE, FIELD_CUSTOM, 1, 1, names[1] },
    { MatrixTag, any, any, TIFF_DOUBLE, FIELD_CUSTOM, 1, 1, names[2] },
    { KeysTag, any, any, TIFF_SHORT, FIELD_CUSTOM, 1, 1, names[3] },
    { KeyNumbersTag, any, any, TIFF_DOUBLE, FIELD_CUSTOM, 1, 1, names[4] },
    { KeyTextTag, text, text, TIFF_ASCII, FIELD_CUSTOM, 1, 0, names[5] },
    { MetadataTag, text, text, TIFF_ASCII, FIELD_CUSTOM, 1, 0, names[6] },
    { NoDataTag, text, text, TIFF_ASCII, FIELD_CUSTOM, 1, 0, names[7] },
  };
  TIFFMergeFieldInfo(tiff, fields, sizeof(fields) / sizeof(fields[0]));
  WriteArray(tiff, ScaleTag, this->Scale);
  WriteArray(tiff, TiesTag, this->Ties);
  WriteArray(tiff, MatrixTag, this->Matrix);
  WriteArray(tiff, KeysTag, this->Keys);
  WriteArray(tiff, KeyNumbersTag, this->KeyNumbers);
  WriteText(tiff, KeyTextTag, this->KeyText);
  WriteText(tiff, MetadataTag, this->Metadata);
  WriteText(tiff, NoDataTag, this->NoData);
}
}
