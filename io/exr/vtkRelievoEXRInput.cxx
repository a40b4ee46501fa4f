// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoEXRInput.h"

#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkPointData.h"
#include "vtkRelievoEXRConvert.h"
#include "vtkRelievoEXRFailure.h"
#include "vtkRelievoEXRFields.h"
#include "vtkRelievoEXRHeaderScan.h"
#include "vtkSmartPointer.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStringVectorAttribute.h>
#include <OpenEXR/ImfThreading.h>
#include <OpenEXR/ImfTileDescription.h>

#include <algorithm>
#include <set>

namespace relievo::exr
{
namespace
{
std::string PartTitle(int index, const Input::Part& part)
{
  return "part " + std::to_string(index) + (part.Name.empty() ? "" : " (" + Shown(part.Name) + ")");
}

bool IsFlat(const Input::Part& part)
{
  return part.Type == Imf::SCANLINEIMAGE || part.Type == Imf::TILEDIMAGE;
}
}

//------------------------------------------------------------------------------
Input::Input(const std::string& fileName)
  : Stream(fileName)
{
  ScanHeaders(this->Stream);
  // Damaged tables of offsets are not reconstructed: that would read pixels of unknown position.
  const bool reconstruct = false;
  this->File =
    std::make_unique<Imf::MultiPartInputFile>(this->Stream, Imf::globalThreadCount(), reconstruct);
  for (int i = 0; i < this->File->parts(); ++i)
  {
    const Imf::Header& header = this->File->header(i);
    // Names become names of arrays, which end at a zero byte. Cutting them here prevents two
    // different names from becoming one.
    const std::string name = header.hasName() ? header.name().c_str() : "";
    this->Parts.push_back({ name, header.type() });
  }
}

//------------------------------------------------------------------------------
void Input::ChoosePart(int part)
{
  const int count = static_cast<int>(this->Parts.size());
  if (part < -1 || part >= count)
  {
    throw Failure(vtkErrorCode::UserError,
      "it has " + std::to_string(count) + " part(s), but part " + std::to_string(part) +
        " is asked for; give SetPart a number from 0 to " + std::to_string(count - 1) +
        ", or -1 for all");
  }
  this->ChosenParts.clear();
  std::vector<const Imf::Header*> headers;
  for (int i = std::max(part, 0); i < (part < 0 ? count : part + 1); ++i)
  {
    if (!IsFlat(this->Parts[i]))
    {
      throw Failure(vtkErrorCode::FileFormatError,
        PartTitle(i, this->Parts[i]) + " is of type " + Shown(this->Parts[i].Type) +
          ", but only flat images (scanlineimage, tiledimage) are read; " +
          (count > 1
              ? "choose another part with SetPart, or flatten it with a program for deep data"
              : "flatten it with a program for deep data"));
    }
    const Imf::Header& header = this->File->header(i);
    if (!headers.empty() && header.dataWindow() != headers.front()->dataWindow())
    {
      throw Failure(vtkErrorCode::FileFormatError,
        PartTitle(i, this->Parts[i]) +
          " covers other pixels than the parts before it; read the parts one by one with SetPart");
    }
    headers.push_back(&header);
    this->ChosenParts.push_back(i);
  }
  CheckPlausible(headers, this->Stream.GetSize());

  this->Channels.clear();
  std::set<std::string> names;
  for (const int chosen : this->ChosenParts)
  {
    const Imf::ChannelList& list = this->File->header(chosen).channels();
    for (auto channel = list.begin(); channel != list.end(); ++channel)
    {
      std::string name = channel.name();
      while (!names.insert(name).second)
      {
        name = this->Parts[chosen].Name + "." + name;
      }
      const bool subsampled = channel.channel().xSampling != 1 || channel.channel().ySampling != 1;
      this->Channels.push_back(
        { name, channel.name(), chosen, channel.channel().type, subsampled });
    }
  }
}

//------------------------------------------------------------------------------
void Input::ChooseChannels(const std::vector<int>& channels)
{
  this->ChosenChannels = channels;
  std::vector<NamedChannel> named;
  for (const int index : channels)
  {
    const Channel& channel = this->Channels[index];
    if (channel.Subsampled)
    {
      throw Failure(vtkErrorCode::FileFormatError,
        "channel " + Shown(channel.Name) +
          " is subsampled (it has a value for only some of the pixels); leave it out with "
          "GetChannelSelection()->DisableArray, or store it at full size");
    }
    named.push_back({ channel.Name, channel.Type == Imf::UINT });
  }
  const Imf::StringVector* record = ValueOf<Imf::StringVector>(this->GetHeader(), ArraysAttribute);
  this->Arrays = GroupChannels(named, record ? *record : Imf::StringVector());
  const bool relative = ValueOf<Imath::V3d>(this->GetHeader(), "relievo:origin") != nullptr;
  for (ArrayLayout& array : this->Arrays)
  {
    // Without a record of the type, a position relative to an origin needs double.
    if (!record && relative &&
      IsPosition(array.Name, array.VtkType, static_cast<int>(array.Channels.size())))
    {
      array.VtkType = VTK_DOUBLE;
    }
  }
}

//------------------------------------------------------------------------------
int Input::GetBlockLines(uint64_t width) const
{
  // Reads whole chunks, several at once while their memory stays small.
  uint64_t lines = 1;
  for (const int part : this->ChosenParts)
  {
    const Imf::Header& header = this->File->header(part);
    const uint64_t chunk = header.type() == Imf::TILEDIMAGE ? header.tileDescription().ySize
                                                            : LinesPerChunk(header.compression());
    lines = std::max(lines, chunk);
  }
  const uint64_t smallBytes = 16 * 1024 * 1024;
  const uint64_t bytesPerLine = 4 * width * std::max<uint64_t>(1, this->ChosenChannels.size());
  const uint64_t chunks = std::max<uint64_t>(1, smallBytes / bytesPerLine / lines);
  const Imath::Box2i window = this->GetDataWindow();
  const uint64_t height = static_cast<int64_t>(window.max.y) - window.min.y + 1;
  return static_cast<int>(std::min(height, lines * chunks));
}

//------------------------------------------------------------------------------
void Input::Read(vtkPointData* points, const std::function<bool(double)>& progress)
{
  const Imath::Box2i window = this->GetDataWindow();
  const int64_t width = static_cast<int64_t>(window.max.x) - window.min.x + 1;
  const int64_t height = static_cast<int64_t>(window.max.y) - window.min.y + 1;

  std::vector<vtkSmartPointer<vtkDataArray>> arrays;
  for (const ArrayLayout& layout : this->Arrays)
  {
    auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(layout.VtkType));
    array->SetName(layout.Name.c_str());
    array->SetNumberOfComponents(static_cast<int>(layout.Channels.size()));
    array->SetNumberOfTuples(width * height);
    points->AddArray(array);
    arrays.push_back(array);
  }

  const int blockLines = this->GetBlockLines(width);
  std::vector<std::unique_ptr<char[]>> pixels;
  for (std::size_t i = 0; i < this->ChosenChannels.size(); ++i)
  {
    pixels.emplace_back(new char[4 * width * blockLines]());
  }
  std::vector<Imf::InputPart> parts;
  for (const int part : this->ChosenParts)
  {
    parts.emplace_back(*this->File, part);
  }

  for (int64_t y = window.min.y; y <= window.max.y; y += blockLines)
  {
    const int first = static_cast<int>(y);
    const int last = static_cast<int>(std::min<int64_t>(y + blockLines - 1, window.max.y));
    for (std::size_t p = 0; p < parts.size(); ++p)
    {
      Imf::FrameBuffer buffer;
      for (std::size_t i = 0; i < this->ChosenChannels.size(); ++i)
      {
        const Channel& channel = this->Channels[this->ChosenChannels[i]];
        if (channel.Part == this->ChosenParts[p])
        {
          // OpenEXR converts halfs to floats, exactly.
          buffer.insert(channel.NameInPart,
            Imf::Slice::Make(channel.Type == Imf::UINT ? Imf::UINT : Imf::FLOAT, pixels[i].get(),
              Imath::V2i(window.min.x, first), width, blockLines));
        }
      }
      if (buffer.begin() != buffer.end())
      {
        parts[p].setFrameBuffer(buffer);
        parts[p].readPixels(first, last);
      }
    }
    this->DecodeBlock(arrays, pixels, first, last);
    if (!progress(static_cast<double>(static_cast<int64_t>(last) - window.min.y + 1) / height))
    {
      throw Aborted();
    }
  }
}

//------------------------------------------------------------------------------
void Input::DecodeBlock(const std::vector<vtkSmartPointer<vtkDataArray>>& arrays,
  const std::vector<std::unique_ptr<char[]>>& pixels, int firstLine, int lastLine) const
{
  const Imath::Box2i window = this->GetDataWindow();
  const vtkIdType width = static_cast<vtkIdType>(window.max.x) - window.min.x + 1;
  const Imath::V3d* attribute = ValueOf<Imath::V3d>(this->GetHeader(), "relievo:origin");
  const Imath::V3d origin = attribute ? *attribute : Imath::V3d(0);
  const auto isUint = [&](int chosen) {
    return this->Channels[this->ChosenChannels[chosen]].Type == Imf::UINT;
  };

  for (std::size_t a = 0; a < arrays.size(); ++a)
  {
    const ArrayLayout& layout = this->Arrays[a];
    const int components = static_cast<int>(layout.Channels.size());
    const bool position = IsPosition(layout.Name, layout.VtkType, components);
    const bool normalized = IsNormalized(layout.Name, layout.VtkType, components);
    for (int y = firstLine; y <= lastLine; ++y)
    {
      // The top line of the file is the last row of the image.
      const vtkIdType first = (static_cast<vtkIdType>(window.max.y) - y) * width;
      const vtkIdType offset = 4 * width * (static_cast<vtkIdType>(y) - firstLine);
      const auto line = [&](int c) { return pixels[layout.Channels[c]].get() + offset; };
      if (position)
      {
        const float* const xyz[3] = { reinterpret_cast<const float*>(line(0)),
          reinterpret_cast<const float*>(line(1)), reinterpret_cast<const float*>(line(2)) };
        DecodePosition(xyz, arrays[a], &origin[0], first, width);
        continue;
      }
      for (int c = 0; c < components; ++c)
      {
        const bool uint = isUint(layout.Channels[c]);
        const Coding code = normalized && !uint ? Coding::Normalized : Coding::Plain;
        Decode(line(c), uint, { arrays[a], c, code, {} }, first, width);
      }
    }
  }
}
}
