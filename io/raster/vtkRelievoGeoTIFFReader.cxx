// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoGeoTIFFReader.h"

#include "vtkRelievoFileKind.h"
#include "vtkRelievoGeoTags.h"
#include "vtkRelievoImageBytes.h"
#include "vtkRelievoImageFile.h"
#include "vtkRelievoRaster.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"
#include "vtkUnsignedShortArray.h"

#include <array>
#include <cmath>
#include <exception>
#include <new>
#include <optional>
#include <string>

#include <vtksys/SystemTools.hxx>

vtkStandardNewMacro(vtkRelievoGeoTIFFReader);

namespace
{
using relievo::image::GeoTags;

// Keys of the coordinate system (OGC 19-008).
constexpr unsigned short ModelType = 1024;
constexpr unsigned short Geographic = 2;
constexpr unsigned short RasterType = 1025;
constexpr unsigned short PixelIsArea = 1;
constexpr unsigned short PixelIsPoint = 2;

// The value of a key that is stored in the directory; nullptr: the file has none. The directory is
// a head of four numbers and then four numbers for each key: itself, where its values are, their
// count, and the value or its index.
unsigned short* FindKey(std::vector<unsigned short>& keys, unsigned short key)
{
  for (std::size_t i = 4; i + 3 < keys.size(); i += 4)
  {
    if (keys[i] == key && keys[i + 1] == 0)
    {
      return &keys[i + 3];
    }
  }
  return nullptr;
}

// Throws Failure.
std::array<double, 6> MakeTransform(GeoTags& tags)
{
  std::array<double, 6> at{};
  if (tags.HasMatrix())
  {
    const std::vector<double>& m = tags.Matrix;
    at = { m[0], m[1], m[3], m[4], m[5], m[7] };
  }
  else if (tags.HasTie())
  {
    const double a = tags.Scale[0];
    const double e = -tags.Scale[1];
    at = { a, 0.0, tags.Ties[3] - a * tags.Ties[0], 0.0, e, tags.Ties[4] - e * tags.Ties[1] };
  }
  else
  {
    throw relievo::image::Failure("it does not say where its cells are in the world");
  }
  unsigned short* type = FindKey(tags.Keys, RasterType);
  if (type && *type == PixelIsPoint) // the centres are given, not the corners
  {
    at[2] -= 0.5 * (at[0] + at[1]);
    at[5] -= 0.5 * (at[3] + at[4]);
    *type = PixelIsArea;
  }
  for (const double number : at)
  {
    if (!std::isfinite(number))
    {
      throw relievo::image::Failure("its place in the world is not finite");
    }
  }
  return at;
}

// Whether GDAL's metadata give the first band a scale or an offset.
bool HasScale(const std::string& metadata)
{
  for (std::size_t begin = metadata.find('<'); begin != std::string::npos;
       begin = metadata.find('<', begin + 1))
  {
    const std::string tag = metadata.substr(begin, metadata.find('>', begin) - begin);
    const auto has = [&tag](const char* text) { return tag.find(text) != std::string::npos; };
    if (has("sample=\"0\"") && (has("role=\"scale\"") || has("role=\"offset\"")))
    {
      return true;
    }
  }
  return false;
}

// Why the values or their places cannot be used; empty: they can.
std::string FindFault(GeoTags& tags)
{
  const unsigned short* model = FindKey(tags.Keys, ModelType);
  if (model && *model == Geographic)
  {
    return "its coordinates are degrees; convert it to coordinates with lengths, such as "
           "UTM, by gdalwarp -t_srs EPSG:CODE";
  }
  return HasScale(tags.Metadata)
    ? "its values have a scale or an offset; apply them by gdal_translate -unscale"
    : "";
}

template <typename Array, typename Values>
void AddField(vtkImageData* image, const char* name, const Values& values)
{
  if (values.size() > 0)
  {
    vtkNew<Array> array;
    array->SetName(name);
    for (const auto& value : values)
    {
      array->InsertNextValue(value);
    }
    image->GetFieldData()->AddArray(array);
  }
}

// Throws Failure.
vtkSmartPointer<vtkImageData> ReadRaster(const std::string& path)
{
  std::string file;
  const std::string problem =
    vtkRelievoFileKind::ReadWhole(path, vtkRelievoImageFile::MostBytes, file);
  if (!problem.empty())
  {
    throw relievo::image::Failure(problem);
  }
  GeoTags tags;
  const relievo::image::Bytes bytes(
    reinterpret_cast<const unsigned char*>(file.data()), file.size());
  auto image = relievo::image::DecodeRaster(bytes, tags);
  image->GetPointData()->GetScalars()->SetName("height");
  const std::string fault = FindFault(tags);
  if (!fault.empty())
  {
    throw relievo::image::Failure(fault);
  }
  AddField<vtkDoubleArray>(image, relievo::raster::Transform, MakeTransform(tags));
  const std::optional<double> value = tags.FindNoData();
  if (value && std::isfinite(*value)) // other values are no data anyway
  {
    AddField<vtkDoubleArray>(image, relievo::raster::NoData, std::array<double, 1>{ *value });
  }
  AddField<vtkUnsignedShortArray>(image, relievo::raster::Keys, tags.Keys);
  AddField<vtkDoubleArray>(image, relievo::raster::KeyNumbers, tags.KeyNumbers);
  if (!tags.KeyText.empty())
  {
    AddField<vtkStringArray>(
      image, relievo::raster::KeyText, std::array<std::string, 1>{ tags.KeyText });
  }
  return image;
}
}

//------------------------------------------------------------------------------
vtkRelievoGeoTIFFReader::vtkRelievoGeoTIFFReader()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkRelievoGeoTIFFReader::~vtkRelievoGeoTIFFReader()
{
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
int vtkRelievoGeoTIFFReader::CanReadFile(const char* name)
{
  auto tags = name ? GeoTags::Find(name) : std::nullopt;
  return tags && FindFault(*tags).empty() ? 1 : 0;
}

//------------------------------------------------------------------------------
vtkImageData* vtkRelievoGeoTIFFReader::GetImage()
{
  if (this->ImageTime != this->GetMTime())
  {
    this->Image = nullptr;
    std::string problem;
    const char* name = this->FileName ? this->FileName : "";
    try
    {
      if (*name == '\0')
      {
        throw relievo::image::Failure("no name of a file is set");
      }
      this->Image = ReadRaster(name);
    }
    catch (const std::bad_alloc&)
    {
      problem = "it would take at least " + std::to_string(vtksys::SystemTools::FileLength(name)) +
        " bytes, and memory ran out";
    }
    catch (const std::exception& error)
    {
      problem = error.what();
    }
    this->SetErrorCode(this->Image ? vtkErrorCode::NoError : vtkErrorCode::FileFormatError);
    this->ImageTime = this->GetMTime(); // changed by the error code
    if (!this->Image)
    {
      vtkErrorMacro(<< name << ": expected a GeoTIFF of heights, but " << problem << ".");
    }
  }
  return this->Image;
}

//------------------------------------------------------------------------------
int vtkRelievoGeoTIFFReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  int extent[6] = { 0, -1, 0, -1, 0, -1 };
  if (vtkImageData* image = this->GetImage())
  {
    image->GetExtent(extent);
  }
  outputs->GetInformationObject(0)->Set(
    vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  return 1;
}

//------------------------------------------------------------------------------
int vtkRelievoGeoTIFFReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkImageData* output = vtkImageData::GetData(outputs);
  output->Initialize();
  if (vtkImageData* image = this->GetImage())
  {
    output->ShallowCopy(image);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkRelievoGeoTIFFReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
