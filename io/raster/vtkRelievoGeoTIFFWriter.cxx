// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoGeoTIFFWriter.h"

#include "vtkRelievoGeoTags.h"
#include "vtkRelievoImageBytes.h"
#include "vtkRelievoRaster.h"
#include "vtkRelievoTemporaryFile.h"

#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <limits>
#include <memory>
#include <system_error>
#include <vector>

vtkStandardNewMacro(vtkRelievoGeoTIFFWriter);

namespace
{
using relievo::image::GeoTags;

// A TIFF in memory, for libtiff.
struct Sink
{
  std::string Data;
  std::size_t At = 0;
};

tmsize_t ReadSink(thandle_t handle, void* to, tmsize_t size)
{
  auto* sink = static_cast<Sink*>(handle);
  const std::size_t left = sink->Data.size() - std::min(sink->At, sink->Data.size());
  const std::size_t count = std::min(left, static_cast<std::size_t>(size));
  std::copy_n(sink->Data.data() + sink->At, count, static_cast<char*>(to));
  sink->At += count;
  return static_cast<tmsize_t>(count);
}

tmsize_t WriteSink(thandle_t handle, void* from, tmsize_t size)
{
  auto* sink = static_cast<Sink*>(handle);
  const auto count = static_cast<std::size_t>(size);
  try
  {
    sink->Data.resize(std::max(sink->Data.size(), sink->At + count));
  }
  catch (const std::exception&) // too large; libtiff is C
  {
    return -1;
  }
  std::copy_n(static_cast<const char*>(from), count, sink->Data.data() + sink->At);
  sink->At += count;
  return size;
}

toff_t SeekSink(thandle_t handle, toff_t offset, int whence)
{
  auto* sink = static_cast<Sink*>(handle);
  sink->At = whence == SEEK_CUR ? sink->At + offset
    : whence == SEEK_END        ? sink->Data.size() + offset
                                : offset;
  return sink->At;
}

int CloseSink(thandle_t)
{
  return 0;
}

toff_t SizeOfSink(thandle_t handle)
{
  return static_cast<Sink*>(handle)->Data.size();
}

struct Closer
{
  void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};

// Throws Failure.
vtkDataArray* NeedField(vtkPolyData* mesh, const char* name, vtkIdType values)
{
  vtkDataArray* array = mesh->GetFieldData()->GetArray(name);
  if (!array || array->GetNumberOfValues() != values)
  {
    throw relievo::image::Failure(std::string("the mesh has no raster: its field data need ") +
      name + " of " + std::to_string(values) + " numbers, as of vtkRelievoTerrain");
  }
  return array;
}

template <typename T>
std::vector<T> GetField(vtkPolyData* mesh, const char* name)
{
  std::vector<T> values;
  if (vtkDataArray* array = mesh->GetFieldData()->GetArray(name))
  {
    for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
    {
      values.push_back(static_cast<T>(array->GetVariantValue(i).ToDouble()));
    }
  }
  return values;
}

// GDAL removes escapes twice.
std::string EscapeXML(const std::string& text)
{
  std::string escaped;
  for (const char letter : text)
  {
    escaped += letter == '&' ? "&amp;"
      : letter == '<'        ? "&lt;"
      : letter == '>'        ? "&gt;"
                             : std::string(1, letter);
  }
  return escaped;
}

GeoTags MakeTags(vtkPolyData* mesh, const std::vector<vtkDataArray*>& bands)
{
  GeoTags tags;
  NeedField(mesh, relievo::raster::Transform, 6);
  const std::vector<double> at = GetField<double>(mesh, relievo::raster::Transform);
  if (at[1] == 0.0 && at[3] == 0.0 && at[0] > 0.0 && at[4] < 0.0)
  {
    tags.Scale = { at[0], -at[4], 0.0 };
    tags.Ties = { 0.0, 0.0, 0.0, at[2], at[5], 0.0 };
  }
  else
  {
    tags.Matrix = { at[0], at[1], 0.0, at[2], at[3], at[4], 0.0, at[5], 0.0, 0.0, 0.0, 0.0, 0.0,
      0.0, 0.0, 1.0 };
  }
  tags.Keys = GetField<unsigned short>(mesh, relievo::raster::Keys);
  if (tags.Keys.empty())
  {
    tags.Keys = { 1, 1, 0, 1, 1025, 0, 1, 1 }; // only that the transform is that of corners
  }
  tags.KeyNumbers = GetField<double>(mesh, relievo::raster::KeyNumbers);
  if (auto* text = vtkStringArray::SafeDownCast(
        mesh->GetFieldData()->GetAbstractArray(relievo::raster::KeyText)))
  {
    tags.KeyText = text->GetNumberOfValues() > 0 ? std::string(text->GetValue(0)) : "";
  }
  tags.NoData = std::to_string(static_cast<int>(vtkRelievoGeoTIFFWriter::GetNoData()));
  tags.Metadata = "<GDALMetadata>\n";
  for (std::size_t i = 0; i < bands.size(); ++i)
  {
    tags.Metadata += "  <Item name=\"DESCRIPTION\" sample=\"" + std::to_string(i) +
      "\" role=\"description\">" + EscapeXML(EscapeXML(bands[i]->GetName())) + "</Item>\n";
  }
  tags.Metadata += "</GDALMetadata>\n";
  return tags;
}

// Writes a band's strips. Throws Failure.
template <typename T>
void WriteBand(TIFF* tiff, vtkPolyData* mesh, vtkDataArray* band, int plane, std::size_t columns,
  std::size_t rows, std::size_t rowsOfStrip)
{
  std::vector<T> values(columns * rows, static_cast<T>(vtkRelievoGeoTIFFWriter::GetNoData()));
  vtkDataArray* cells = mesh->GetPointData()->GetArray(relievo::raster::Cell);
  for (vtkIdType i = 0; i < band->GetNumberOfTuples(); ++i)
  {
    const double cell = cells->GetComponent(i, 0);
    if (!(cell >= 0.0 && cell < static_cast<double>(values.size())))
    {
      throw relievo::image::Failure("the mesh has points outside of its raster");
    }
    values[static_cast<std::size_t>(cell)] = static_cast<T>(band->GetComponent(i, 0));
  }
  for (std::size_t row = 0; row < rows; row += rowsOfStrip)
  {
    const std::size_t count = std::min(rowsOfStrip, rows - row) * columns;
    const std::uint32_t strip =
      TIFFComputeStrip(tiff, static_cast<std::uint32_t>(row), static_cast<std::uint16_t>(plane));
    if (TIFFWriteEncodedStrip(
          tiff, strip, values.data() + row * columns, static_cast<tmsize_t>(count * sizeof(T))) < 0)
    {
      throw relievo::image::Failure("the values cannot be compressed");
    }
  }
}

// Whether an array has only integers from -most - 1 to most.
bool HasIntegers(vtkDataArray* array, double most)
{
  if (array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE)
  {
    return false;
  }
  const double* range = array->GetRange(0);
  return array->GetNumberOfTuples() == 0 || (range[0] >= -most - 1.0 && range[1] <= most);
}

// The bytes of the file. Throws Failure.
std::string MakeFile(vtkPolyData* mesh)
{
  vtkDataArray* size = NeedField(mesh, relievo::raster::Size, 2);
  const double columns = size->GetComponent(0, 0);
  const double rows = size->GetComponent(0, 1);
  if (!(columns >= 1.0 && rows >= 1.0) || columns * rows > 1e9 ||
    !mesh->GetPointData()->GetArray(relievo::raster::Cell))
  {
    throw relievo::image::Failure(
      "the mesh has no raster: expected raster_size of at least 1 x 1, and the point "
      "array raster_cell");
  }
  std::vector<vtkDataArray*> bands;
  bool isWhole = true;
  bool isDouble = false;
  for (int i = 0; i < mesh->GetPointData()->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = mesh->GetPointData()->GetArray(i);
    if (array && array->GetName() && array->GetNumberOfComponents() == 1 &&
      std::strcmp(array->GetName(), relievo::raster::Cell) != 0)
    {
      bands.push_back(array);
      isWhole = isWhole && HasIntegers(array, std::numeric_limits<std::int32_t>::max());
      isDouble = isDouble || !(array->GetDataType() == VTK_FLOAT || HasIntegers(array, 0xffffff));
    }
  }
  if (bands.empty())
  {
    throw relievo::image::Failure(
      "the mesh has no point arrays of one component, expected at least one");
  }
  isDouble = isDouble && !isWhole;
  const GeoTags tags = MakeTags(mesh, bands);
  Sink sink;
  const bool isBig =
    columns * rows * static_cast<double>(bands.size()) * (isDouble ? 8.0 : 4.0) > 4e9;
  const std::unique_ptr<TIFF, Closer> tiff(TIFFClientOpen("raster", isBig ? "w8" : "w", &sink,
    ReadSink, WriteSink, SeekSink, CloseSink, SizeOfSink, nullptr, nullptr));
  if (!tiff)
  {
    throw relievo::image::Failure("the file cannot be begun");
  }
  const auto width = static_cast<std::uint32_t>(columns);
  const auto height = static_cast<std::uint32_t>(rows);
  const int bytes = isDouble ? 8 : 4;
  const std::uint64_t rowBytes = std::uint64_t{ width } * static_cast<std::uint64_t>(bytes);
  const auto rowsOfStrip =
    static_cast<std::uint32_t>(std::clamp<std::uint64_t>((1U << 18) / rowBytes, 1, height));
  TIFFSetField(tiff.get(), TIFFTAG_IMAGEWIDTH, width);
  TIFFSetField(tiff.get(), TIFFTAG_IMAGELENGTH, height);
  TIFFSetField(tiff.get(), TIFFTAG_BITSPERSAMPLE, 8 * bytes);
  TIFFSetField(tiff.get(), TIFFTAG_SAMPLEFORMAT, isWhole ? SAMPLEFORMAT_INT : SAMPLEFORMAT_IEEEFP);
  TIFFSetField(tiff.get(), TIFFTAG_SAMPLESPERPIXEL, static_cast<int>(bands.size()));
  TIFFSetField(tiff.get(), TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
  TIFFSetField(tiff.get(), TIFFTAG_PLANARCONFIG, PLANARCONFIG_SEPARATE);
  TIFFSetField(tiff.get(), TIFFTAG_ROWSPERSTRIP, rowsOfStrip);
  TIFFSetField(tiff.get(), TIFFTAG_COMPRESSION, COMPRESSION_ADOBE_DEFLATE);
  const std::vector<std::uint16_t> extra(bands.size() - 1, EXTRASAMPLE_UNSPECIFIED);
  if (!extra.empty())
  {
    TIFFSetField(
      tiff.get(), TIFFTAG_EXTRASAMPLES, static_cast<std::uint16_t>(extra.size()), extra.data());
  }
  tags.Write(tiff.get());
  for (std::size_t i = 0; i < bands.size(); ++i)
  {
    const auto write = isWhole ? WriteBand<std::int32_t>
      : isDouble               ? WriteBand<double>
                               : WriteBand<float>;
    write(tiff.get(), mesh, bands[i], static_cast<int>(i), width, height, rowsOfStrip);
  }
  if (!TIFFFlush(tiff.get()))
  {
    throw relievo::image::Failure("the file cannot be finished");
  }
  return std::move(sink.Data);
}

// Throws Failure.
void WriteFile(const std::string& path, const std::string& bytes)
{
  std::error_code trouble;
  vtkRelievoTemporaryFile file(std::filesystem::path(path).parent_path().string(), trouble);
  if (!trouble)
  {
    std::ofstream stream(file.GetName(), std::ios::binary);
    errno = 0;
    stream << bytes;
    stream.close();
    trouble.assign(stream ? 0 : errno ? errno : EIO, std::generic_category());
  }
  if (!trouble)
  {
    file.MoveTo(path, trouble);
  }
  if (trouble)
  {
    throw relievo::image::Failure(trouble.message());
  }
}
}

//------------------------------------------------------------------------------
vtkRelievoGeoTIFFWriter::vtkRelievoGeoTIFFWriter()
{
  this->SetNumberOfOutputPorts(0);
}

//------------------------------------------------------------------------------
vtkRelievoGeoTIFFWriter::~vtkRelievoGeoTIFFWriter()
{
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
bool vtkRelievoGeoTIFFWriter::Write()
{
  this->Modified(); // writes also if nothing has changed
  this->SetErrorCode(vtkErrorCode::UserError);
  this->Update();
  return this->GetErrorCode() == vtkErrorCode::NoError;
}

//------------------------------------------------------------------------------
int vtkRelievoGeoTIFFWriter::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  const std::string path = this->FileName ? this->FileName : "";
  try
  {
    if (path.empty())
    {
      throw relievo::image::Failure("no name of a file is set");
    }
    WriteFile(path, MakeFile(vtkPolyData::GetData(inputs[0])));
    this->SetErrorCode(vtkErrorCode::NoError);
  }
  catch (const std::exception& error)
  {
    this->SetErrorCode(vtkErrorCode::CannotOpenFileError);
    vtkErrorMacro(<< path << ": the GeoTIFF is not written: " << error.what() << ".");
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkRelievoGeoTIFFWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
