// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoEXROutput.h"

#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkRelievoEXRAttributes.h"
#include "vtkRelievoEXRChannels.h"
#include "vtkRelievoEXRFailure.h"
#include "vtkRelievoEXRFields.h"
#include "vtkRelievoEXRHeaderScan.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfStringVectorAttribute.h>
#include <OpenEXR/ImfThreading.h>
#include <OpenEXR/ImfVecAttribute.h>

#include <Imath/half.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <set>

namespace relievo::exr
{
namespace
{
Failure Unfit(const std::string& what)
{
  return Failure(vtkErrorCode::UserError, what);
}

bool IsInteger(vtkDataArray* array)
{
  return array->GetDataType() != VTK_FLOAT && array->GetDataType() != VTK_DOUBLE;
}

const char* TypeName(Imf::PixelType type)
{
  return type == Imf::UINT ? "UINT" : type == Imf::HALF ? "HALF" : "FLOAT";
}

const char* CompressionName(Imf::Compression compression)
{
  switch (compression)
  {
    case Imf::B44_COMPRESSION:
      return "b44";
    case Imf::B44A_COMPRESSION:
      return "b44a";
    case Imf::DWAA_COMPRESSION:
      return "dwaa";
    default:
      return "dwab";
  }
}

bool IsDWA(Imf::Compression compression)
{
  return compression == Imf::DWAA_COMPRESSION || compression == Imf::DWAB_COMPRESSION;
}

// Whether compression changes the channel's pixels. PXR24 keeps infinities and NaN.
bool IsLossy(Imf::Compression compression, const std::string& channel, Imf::PixelType type)
{
  if (compression == Imf::B44_COMPRESSION || compression == Imf::B44A_COMPRESSION)
  {
    return type == Imf::HALF;
  }
  static const std::set<std::string> colors = { "R", "G", "B", "Y", "RY", "BY" };
  const std::string last = channel.substr(channel.rfind('.') + 1);
  return IsDWA(compression) && type != Imf::UINT && colors.count(last) > 0;
}

void CountExtremes(const char* line, Imf::PixelType type, vtkIdType width, Losses& losses)
{
  for (vtkIdType i = 0; i < width; ++i)
  {
    const float value = type == Imf::HALF
      ? static_cast<float>(reinterpret_cast<const half*>(line)[i])
      : reinterpret_cast<const float*>(line)[i];
    losses.Infinite += std::isfinite(value) ? 0 : 1;
    losses.Clipped += std::isfinite(value) && std::abs(value) > HALF_MAX ? 1 : 0;
  }
}

bool IsBackground(const double p[3])
{
  return p[0] == 0 && p[1] == 0 && p[2] == 0;
}

// The origin that keeps float differences small if the image names none: (0, 0, 0) if it loses
// nothing, otherwise the middle of the positions. Background pixels have no position.
Imath::V3d ChooseOrigin(vtkDataArray* positions)
{
  bool exact = true;
  Imath::V3d low(std::numeric_limits<double>::max());
  Imath::V3d high(-std::numeric_limits<double>::max());
  for (vtkIdType i = 0; i < positions->GetNumberOfTuples(); ++i)
  {
    double p[3];
    positions->GetTuple(i, p);
    for (int c = 0; c < 3 && !IsBackground(p); ++c)
    {
      if (std::isfinite(p[c]))
      {
        exact = exact && static_cast<double>(static_cast<float>(p[c])) == p[c];
        low[c] = std::min(low[c], p[c]);
        high[c] = std::max(high[c], p[c]);
      }
    }
  }
  Imath::V3d origin(0);
  for (int c = 0; c < 3 && !exact; ++c)
  {
    origin[c] = low[c] <= high[c] ? low[c] / 2 + high[c] / 2 : 0;
  }
  return origin;
}

Imath::V3d PositionOrigin(vtkImageData* image, vtkDataArray* positions)
{
  const std::vector<double> given = FieldNumbers(image->GetFieldData(), "relievo:origin", 3);
  // Floats are stored unchanged: subtracting an origin could lose bits.
  if (!positions || positions->GetDataType() != VTK_DOUBLE)
  {
    return Imath::V3d(0);
  }
  if (given.empty())
  {
    return ChooseOrigin(positions);
  }
  if (!std::isfinite(given[0]) || !std::isfinite(given[1]) || !std::isfinite(given[2]))
  {
    throw Unfit("the field data array 'relievo:origin' is not finite; give three finite numbers");
  }
  return { given[0], given[1], given[2] };
}

bool ReadWindow(vtkFieldData* fields, const char* name, Imath::Box2i& window)
{
  vtkDataArray* array = fields->GetArray(name);
  if (!array || array->GetNumberOfValues() != 4 || array->GetNumberOfComponents() != 4)
  {
    return false;
  }
  double v[4];
  array->GetTuple(0, v);
  const int most = std::numeric_limits<int>::max() / 2; // OpenEXR's own limit
  for (const double value : v)
  {
    if (!(std::abs(value) < most))
    {
      return false;
    }
  }
  window = Imath::Box2i(Imath::V2i(static_cast<int>(v[0]), static_cast<int>(v[1])),
    Imath::V2i(static_cast<int>(v[2]), static_cast<int>(v[3])));
  return !window.isEmpty();
}
}

//------------------------------------------------------------------------------
Output::Output(vtkImageData* image, const Settings& settings, int height)
{
  this->PlanWindows(image, height);
  this->Header.compression() = settings.Compression;
  if (settings.Compression == Imf::DWAA_COMPRESSION ||
    settings.Compression == Imf::DWAB_COMPRESSION)
  {
    this->Header.dwaCompressionLevel() = settings.DWALevel;
  }
  // Names of the user's own attributes, which are not replaced later because Imf::Header::erase
  // leaks.
  std::set<std::string> names;
  for (const auto& attribute : settings.Strings)
  {
    names.insert(attribute.first);
    Insert(this->Header, attribute.first, Imf::StringAttribute(attribute.second));
  }
  for (const auto& attribute : settings.Doubles)
  {
    names.insert(attribute.first);
    Insert(this->Header, attribute.first, Imf::DoubleAttribute(attribute.second));
  }
  WriteAttributes(image->GetFieldData(), names, this->Header);
  this->PlanArrays(image, settings); // last, because it may replace the field data's origin
}

//------------------------------------------------------------------------------
void Output::PlanWindows(vtkImageData* image, int height)
{
  int size[3];
  image->GetDimensions(size);
  if (size[0] < 1 || size[1] < 1 || size[2] != 1)
  {
    throw Unfit("the image has " + std::to_string(size[0]) + " x " + std::to_string(size[1]) +
      " x " + std::to_string(size[2]) +
      " points, but an EXR file holds one picture in the xy plane; give W x H x 1 points");
  }
  Imath::Box2i data(Imath::V2i(0, 0), Imath::V2i(size[0] - 1, height - 1));
  Imath::Box2i display = data;
  // An image read from a file with its own windows keeps them if its size still fits.
  Imath::Box2i oldData;
  Imath::Box2i oldDisplay;
  if (ReadWindow(image->GetFieldData(), "dataWindow", oldData) &&
    ReadWindow(image->GetFieldData(), "displayWindow", oldDisplay) && oldData.size() == data.size())
  {
    data = oldData;
    display = oldDisplay;
  }
  this->Header = Imf::Header(display, data);
}

//------------------------------------------------------------------------------
void Output::PlanArrays(vtkImageData* image, const Settings& settings)
{
  vtkPointData* points = image->GetPointData();
  if (points->GetNumberOfArrays() == 0)
  {
    throw Unfit("the image has no point arrays; give it at least one");
  }
  vtkDataArray* positions = FindPositions(points);
  const Imath::V3d origin = PositionOrigin(image, positions);
  if (positions)
  {
    this->Header.insert("relievo:origin", Imf::V3dAttribute(origin));
  }

  std::set<std::string> names;
  std::string list;
  for (int i = 0; i < points->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = points->GetAbstractArray(i);
    const std::string name = array->GetName() ? array->GetName() : "";
    if (name.empty())
    {
      throw Unfit("point array " + std::to_string(i) + " has no name; give it one with SetName");
    }
    const std::string entry =
      RecordEntry(name, array->GetDataType(), array->GetNumberOfComponents());
    vtkDataArray* values = vtkDataArray::SafeDownCast(array);
    if (entry.empty() || !values)
    {
      throw Unfit("the array '" + name + "' is of type " + array->GetDataTypeAsString() +
        ", which EXR cannot hold; remove or convert it");
    }
    if (array->GetNumberOfTuples() != image->GetNumberOfPoints() ||
      array->GetNumberOfComponents() < 1)
    {
      throw Unfit("the array '" + name + "' has " + std::to_string(array->GetNumberOfTuples()) +
        " tuples, but the image has " + std::to_string(image->GetNumberOfPoints()) +
        " points; give it one for each");
    }
    this->PlanArray(values, settings, &origin[0]);
    this->Record.push_back(entry);
    if (!names.insert(name).second)
    {
      throw Unfit("two arrays have the name '" + name + "'; rename one");
    }
    list += (list.empty() ? "" : ", ") + name;
  }
  if (this->Channels.size() > static_cast<std::size_t>(MostChannels))
  {
    throw Unfit("the arrays make " + std::to_string(this->Channels.size()) +
      " channels, but only " + std::to_string(MostChannels) + " can be read back; remove some");
  }
  for (const auto& choice : settings.PixelTypes)
  {
    const bool known = names.count(choice.first) > 0 ||
      std::any_of(this->Channels.begin(), this->Channels.end(),
        [&](const Channel& channel) { return channel.Name == choice.first; });
    if (!known)
    {
      throw Unfit("a pixel type is set for '" + choice.first +
        "', but the image has no such array or channel; it has the arrays " + list);
    }
  }
  this->Header.insert(ArraysAttribute, Imf::StringVectorAttribute(this->Record));
}

//------------------------------------------------------------------------------
void Output::PlanArray(vtkDataArray* array, const Settings& settings, const double origin[3])
{
  const std::string name = array->GetName();
  const int components = array->GetNumberOfComponents();
  const int type = array->GetDataType();
  const bool normalized = IsNormalized(name, type, components);
  const Imf::PixelType usual = normalized ? Imf::HALF : IsInteger(array) ? Imf::UINT : Imf::FLOAT;
  for (int c = 0; c < components; ++c)
  {
    const std::string channel = ChannelName(name, components, IsInteger(array), c);
    if (channel.size() > LongestName)
    {
      throw Unfit("the array name '" + name + "' is too long: its channels' names may have " +
        std::to_string(LongestName) + " bytes; shorten it");
    }
    auto choice = settings.PixelTypes.find(channel);
    choice = choice == settings.PixelTypes.end() ? settings.PixelTypes.find(name) : choice;
    const Imf::PixelType pixel = choice == settings.PixelTypes.end() ? usual : choice->second;
    if (pixel == Imf::UINT && !IsInteger(array))
    {
      throw Unfit("the array '" + name + "' holds " + array->GetDataTypeAsString() +
        " values, which UINT cannot; choose FLOAT or HALF with SetPixelType");
    }
    const Coding code = IsPosition(name, type, components) ? Coding::Position
      : normalized && pixel != Imf::UINT                   ? Coding::Normalized
                                                           : Coding::Plain;
    this->Header.channels().insert(channel, Imf::Channel(pixel));
    this->Channels.push_back(
      { channel, pixel, { array, c, code, { origin[0], origin[1], origin[2] } }, {} });
  }
}

//------------------------------------------------------------------------------
void Output::Begin(Imf::OStream& stream)
{
  const Imath::Box2i window = this->Header.dataWindow();
  const int64_t width = static_cast<int64_t>(window.max.x) - window.min.x + 1;
  const int64_t height = static_cast<int64_t>(window.max.y) - window.min.y + 1;
  // Writes whole chunks, as many at once as fit into a small buffer.
  const int64_t smallBytes = 16 * 1024 * 1024;
  const int64_t chunk = LinesPerChunk(this->Header.compression());
  const int64_t bytesPerLine = 4 * width * static_cast<int64_t>(this->Channels.size());
  this->BlockLines = static_cast<int>(
    std::min(height, chunk * std::max<int64_t>(1, smallBytes / bytesPerLine / chunk)));
  for (std::size_t i = 0; i < this->Channels.size(); ++i)
  {
    this->Pixels.emplace_back(new char[4 * width * this->BlockLines]);
  }
  this->File = std::make_unique<Imf::OutputFile>(stream, this->Header, Imf::globalThreadCount());
  this->Next = window.min.y;
}

//------------------------------------------------------------------------------
void Output::TakeArrays(vtkImageData* image)
{
  this->Arrays.clear();
  auto channel = this->Channels.begin();
  vtkPointData* points = image->GetPointData();
  bool fits = points->GetNumberOfArrays() == static_cast<int>(this->Record.size()) &&
    image->GetDimensions()[0] == this->Header.dataWindow().size().x + 1;
  for (int i = 0; fits && i < points->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = points->GetArray(i);
    const std::size_t place = static_cast<std::size_t>(i);
    fits = array && array->GetName() &&
      RecordEntry(array->GetName(), array->GetDataType(), array->GetNumberOfComponents()) ==
        this->Record[place] &&
      array->GetNumberOfTuples() == image->GetNumberOfPoints();
    if (!fits)
    {
      break;
    }
    this->Arrays.emplace_back(array);
    if (!array->HasStandardMemoryLayout())
    {
      this->Arrays.back().TakeReference(vtkDataArray::CreateDataArray(array->GetDataType()));
      this->Arrays.back()->DeepCopy(array);
    }
    for (int c = 0; c < array->GetNumberOfComponents(); ++c, ++channel)
    {
      channel->Source.Array = this->Arrays.back();
    }
  }
  if (!fits)
  {
    throw Unfit("the rows' arrays or width differ from those of the first rows; give all of them "
                "the same");
  }
}

//------------------------------------------------------------------------------
void Output::WriteRows(vtkImageData* image, int lowest, int count, const Progress& progress)
{
  this->TakeArrays(image);
  const Imath::Box2i window = this->Header.dataWindow();
  if (count > static_cast<int64_t>(window.max.y) - this->Next + 1)
  {
    throw Unfit("there are " + std::to_string(count) + " more rows, but the picture lacks only " +
      std::to_string(static_cast<int64_t>(window.max.y) - this->Next + 1));
  }
  const int64_t width = static_cast<int64_t>(window.max.x) - window.min.x + 1;
  const int64_t height = static_cast<int64_t>(window.max.y) - window.min.y + 1;
  for (int done = 0; done < count; done += this->BlockLines)
  {
    const int lines = std::min(this->BlockLines, count - done);
    this->EncodeBlock(lines, lowest + count - 1 - done);
    Imf::FrameBuffer buffer;
    for (std::size_t i = 0; i < this->Channels.size(); ++i)
    {
      buffer.insert(this->Channels[i].Name,
        Imf::Slice::Make(this->Channels[i].Type, this->Pixels[i].get(),
          Imath::V2i(window.min.x, this->Next), width, this->BlockLines));
    }
    this->File->setFrameBuffer(buffer);
    this->File->writePixels(lines);
    this->Next += lines;
    if (!progress(static_cast<double>(static_cast<int64_t>(this->Next) - window.min.y) / height))
    {
      throw Aborted();
    }
  }
}

//------------------------------------------------------------------------------
bool Output::IsComplete() const
{
  return this->Next > this->Header.dataWindow().max.y;
}

//------------------------------------------------------------------------------
std::string Output::End()
{
  this->File.reset(); // writes the table of offsets
  this->Warn();
  return this->Warning;
}

//------------------------------------------------------------------------------
void Output::Warn()
{
  const auto add = [this](const std::string& text) {
    this->Warning += (this->Warning.empty() ? "" : "; ") + text;
  };
  const bool dwa = IsDWA(this->Header.compression());
  std::string rounded;
  for (const Channel& channel : this->Channels)
  {
    if (channel.Lost.Overflows > 0)
    {
      add(std::to_string(channel.Lost.Overflows) + " values of " + channel.Name +
        " are beyond the range of " + TypeName(channel.Type) +
        " and were written as infinity, the first is " + channel.Lost.First);
    }
    if (channel.Lost.Rounded > 0)
    {
      add(std::to_string(channel.Lost.Rounded) + " whole numbers of " + channel.Name +
        " do not fit into " + TypeName(channel.Type) + " and were rounded, the first is " +
        channel.Lost.First);
    }
    if (channel.Lost.Clipped > 0)
    {
      add(std::to_string(channel.Lost.Clipped) + " values of " + channel.Name +
        " are beyond 65504 and were clamped to it by " +
        CompressionName(this->Header.compression()) + " compression; zip and piz keep them");
    }
    // DWA treats any channel named Y as luminance.
    const std::size_t size = channel.Name.size();
    if (dwa && channel.Type != Imf::UINT && size > 2 && channel.Name.substr(size - 2) == ".Y")
    {
      rounded += (rounded.empty() ? "" : ", ") + channel.Name;
    }
  }
  if (!rounded.empty())
  {
    add("DWA compression has lost accuracy in " + rounded +
      ", as it does in every channel named R, G, B or Y; zip and piz lose nothing");
  }
}

//------------------------------------------------------------------------------
// The last row of an image is its top line.
void Output::EncodeBlock(int lines, int topRow)
{
  const Imath::Box2i window = this->Header.dataWindow();
  const vtkIdType width = static_cast<vtkIdType>(window.max.x) - window.min.x + 1;
  for (std::size_t i = 0; i < this->Channels.size(); ++i)
  {
    Channel& channel = this->Channels[i];
    const vtkIdType lineBytes = width * (channel.Type == Imf::HALF ? 2 : 4);
    for (int y = 0; y < lines; ++y)
    {
      char* line = this->Pixels[i].get() + lineBytes * y;
      Encode(channel.Source, width * (topRow - y), width, channel.Type, line, channel.Lost);
      if (IsLossy(this->Header.compression(), channel.Name, channel.Type))
      {
        CountExtremes(line, channel.Type, width, channel.Lost);
      }
    }
    this->CheckLosses(channel);
  }
}

//------------------------------------------------------------------------------
void Output::CheckLosses(const Channel& channel) const
{
  if (channel.Lost.Inexact > 0)
  {
    throw Unfit("the array '" + std::string(channel.Source.Array->GetName()) + "' holds " +
      channel.Lost.First + ", which " + TypeName(channel.Type) + " cannot hold exactly; " +
      (channel.Type == Imf::UINT ? "EXR has 32 bits for integers: convert the array"
                                 : "choose UINT with SetPixelType"));
  }
  if (channel.Lost.Infinite > 0)
  {
    throw Unfit("the array '" + std::string(channel.Source.Array->GetName()) +
      "' holds infinities or NaN in the channel " + channel.Name + ", of which " +
      CompressionName(this->Header.compression()) +
      " compression makes numbers; choose zip or piz, which keep them");
  }
}
}
