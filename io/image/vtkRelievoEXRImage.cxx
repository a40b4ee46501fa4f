// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoEXRImage.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkDataArraySelection.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRelievoEXRReader.h"
#include "vtkRelievoImageBytes.h"
#include "vtkRelievoMessageText.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <set>
#include <vector>

namespace relievo::image
{
namespace
{
// Keeps the reader's first message instead of printing it.
void Keep(vtkObject*, unsigned long, void* words, void* text)
{
  auto* kept = static_cast<std::string*>(words);
  if (kept->empty() && text)
  {
    *kept = vtkRelievoMessageText::OfMessage(static_cast<const char*>(text));
  }
}

using Names = std::vector<std::string>;

// These channels after the prefix, if all but the last, which is alpha, exist.
Names FindColors(const std::set<std::string>& there, const std::string& prefix, const Names& colors)
{
  Names found;
  for (std::size_t i = 0; i < colors.size(); ++i)
  {
    const std::string name = prefix + colors[i];
    if (there.count(name) > 0)
    {
      found.push_back(name);
    }
    else if (i + 1 < colors.size())
    {
      return {};
    }
  }
  return found;
}

Names FindColors(const std::set<std::string>& there, const std::string& prefix)
{
  for (const Names& colors : { Names{ "R", "G", "B", "A" }, Names{ "r", "g", "b", "a" },
         Names{ "red", "green", "blue", "alpha" } }) // the last of Nuke's layers
  {
    if (const Names found = FindColors(there, prefix, colors); !found.empty())
    {
      return found;
    }
  }
  return {};
}

// Empty if there are no colours. `note` names layers that are not used.
Names ChooseChannels(const Names& channels, std::string& note)
{
  const std::set<std::string> there(channels.begin(), channels.end());
  Names chosen = FindColors(there, "");
  if (!chosen.empty())
  {
    return chosen;
  }
  if (there.count("RY") > 0 || there.count("BY") > 0)
  {
    throw Failure("it has luminance and chroma (Y RY BY), which are not read: write it as R G B");
  }
  chosen = FindColors(there, "", { "Y", "A" });
  if (!chosen.empty())
  {
    return chosen;
  }
  Names layers;
  for (const std::string& channel : channels)
  {
    const std::size_t dot = channel.rfind('.');
    const std::string prefix = dot == std::string::npos ? "" : channel.substr(0, dot + 1);
    if (!prefix.empty() && std::find(layers.begin(), layers.end(), prefix) == layers.end() &&
      !FindColors(there, prefix).empty())
    {
      layers.push_back(prefix);
    }
  }
  if (layers.empty())
  {
    return {};
  }
  if (layers.size() > 1)
  {
    note = "of its " + std::to_string(layers.size()) + " layers of colours " +
      layers.front().substr(0, layers.front().size() - 1) + " is taken";
  }
  return FindColors(there, layers.front());
}

Names ReadNames(vtkRelievoEXRReader* reader, int part)
{
  reader->SetPart(part);
  reader->UpdateInformation();
  Names names;
  for (int i = 0; i < reader->GetNumberOfChannels(); ++i)
  {
    names.emplace_back(reader->GetChannelName(i));
  }
  return names;
}

struct Source
{
  vtkDataArray* Array;
  int Component;
};

// The reader's arrays for these channels: one for each, or one for all.
std::vector<Source> FindSources(vtkPointData* points, const Names& channels)
{
  std::vector<Source> sources;
  for (std::size_t i = 0; i < channels.size(); ++i)
  {
    vtkDataArray* own = points->GetArray(channels[i].c_str());
    vtkDataArray* all = points->GetArray(0);
    if (own && own->GetNumberOfComponents() == 1)
    {
      sources.push_back({ own, 0 });
    }
    else if (all && points->GetNumberOfArrays() == 1 &&
      all->GetNumberOfComponents() == static_cast<int>(channels.size()))
    {
      sources.push_back({ all, static_cast<int>(i) });
    }
  }
  return sources.size() == channels.size() ? sources : std::vector<Source>();
}

struct Window
{
  double Left, Top, Right, Bottom; // pixel indices, both ends included
};

Window GetWindow(vtkImageData* image, const char* name)
{
  vtkDataArray* array = image->GetFieldData()->GetArray(name);
  if (!array || array->GetNumberOfValues() != 4)
  {
    throw Failure("it lacks its " + std::string(name));
  }
  const auto value = [array](int i) {
    const int components = array->GetNumberOfComponents();
    return array->GetComponent(i / components, i % components);
  };
  return { value(0), value(1), value(2), value(3) };
}

template <typename T>
void Place(vtkImageData* read, const std::vector<Source>& sources, const Window& data,
  const Window& display, vtkImageData* picture)
{
  const int components = static_cast<int>(sources.size());
  const int* size = picture->GetDimensions();
  const vtkIdType stride = read->GetDimensions()[0];
  for (int y = 0; y < size[1]; ++y)
  {
    T* to = Row<T>(picture, static_cast<std::uint64_t>(y));
    std::fill_n(to, static_cast<std::size_t>(size[0]) * components, T(0));
    const double line = display.Bottom - y;
    if (line < data.Top || line > data.Bottom)
    {
      continue;
    }
    const auto row = static_cast<vtkIdType>(data.Bottom - line);
    const double first = std::max(display.Left, data.Left);
    const double last = std::min(display.Right, data.Right);
    to += static_cast<std::size_t>(std::max(0.0, first - display.Left)) * components;
    for (double x = first; x <= last; ++x, to += components)
    {
      const vtkIdType from = row * stride + static_cast<vtkIdType>(x - data.Left);
      for (int c = 0; c < components; ++c)
      {
        to[c] = static_cast<T>(sources[c].Array->GetComponent(from, sources[c].Component));
      }
    }
  }
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> ReadEXR(
  const std::string& path, std::string& note, const std::function<void(vtkAlgorithm*)>& watch)
{
  std::string said;
  vtkNew<vtkCallbackCommand> keep;
  keep->SetCallback(Keep);
  keep->SetClientData(&said);
  vtkNew<vtkRelievoEXRReader> reader;
  for (vtkObject* speaker :
    { static_cast<vtkObject*>(reader.Get()), static_cast<vtkObject*>(reader->GetExecutive()) })
  {
    speaker->AddObserver(vtkCommand::ErrorEvent, keep);
    speaker->AddObserver(vtkCommand::WarningEvent, keep);
  }
  if (watch)
  {
    watch(reader);
  }
  reader->SetFileName(path.c_str());
  // The first part with colours, otherwise the first.
  Names channels = ReadNames(reader, 0);
  Names chosen = ChooseChannels(channels, note);
  const int parts = reader->GetNumberOfParts();
  int part = 0;
  while (chosen.empty() && ++part < parts)
  {
    chosen = ChooseChannels(ReadNames(reader, part), note);
  }
  if (chosen.empty() && parts > 1)
  {
    part = 0;
    said.clear();
    channels = ReadNames(reader, part);
  }
  // Reports no problems of channels that are not requested.
  if (!chosen.empty())
  {
    said.clear();
    reader->GetChannelSelection()->DisableAllArrays();
    for (const std::string& channel : chosen)
    {
      reader->GetChannelSelection()->EnableArray(channel.c_str());
    }
    reader->UpdateInformation();
  }
  if (said.empty())
  {
    const int* extent =
      reader->GetOutputInformation(0)->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT());
    CheckSize(static_cast<std::uint64_t>(std::int64_t(extent[1]) - extent[0] + 1),
      static_cast<std::uint64_t>(std::int64_t(extent[3]) - extent[2] + 1),
      static_cast<int>(chosen.empty() ? channels.size() : chosen.size()), sizeof(float));
    reader->Update();
  }
  if (!said.empty() || reader->GetErrorCode() != 0)
  {
    // The caller names the file in its message.
    const std::string named = "Cannot read '" + path + "': ";
    said = said.compare(0, named.size(), named) == 0 ? said.substr(named.size()) : said;
    throw Failure(said.empty() ? "it is damaged" : said);
  }
  vtkImageData* read = reader->GetOutput();
  std::vector<Source> sources = FindSources(read->GetPointData(), chosen);
  if (sources.empty())
  {
    vtkDataArray* scalars = read->GetPointData()->GetScalars();
    for (int c = 0; scalars && c < std::min(4, scalars->GetNumberOfComponents()); ++c)
    {
      sources.push_back({ scalars, c });
    }
  }
  if (sources.empty() || read->GetNumberOfPoints() == 0)
  {
    throw Failure("it has no channels");
  }
  if (parts > 1)
  {
    note = "of its " + std::to_string(parts) + " parts " +
      (part == 0 ? "the first"
                 : "number " + std::to_string(part + 1) + ", the first with colours,") +
      " is taken";
  }
  else if (chosen.empty() && channels.size() > sources.size())
  {
    note = "it has no colours, and of its " + std::to_string(channels.size()) + " channels " +
      read->GetPointData()->GetScalars()->GetName() + " is taken";
  }
  const Window data = GetWindow(read, "dataWindow");
  const Window display = GetWindow(read, "displayWindow");
  if (data.Left > display.Right || data.Right < display.Left || data.Top > display.Bottom ||
    data.Bottom < display.Top)
  {
    throw Failure("its data window has no pixels of its display window");
  }
  const bool bytes = sources.front().Array->GetDataType() == VTK_UNSIGNED_CHAR;
  auto picture = MakeImage(static_cast<std::uint64_t>(display.Right - display.Left + 1),
    static_cast<std::uint64_t>(display.Bottom - display.Top + 1),
    bytes ? VTK_UNSIGNED_CHAR : VTK_FLOAT, static_cast<int>(sources.size()));
  if (bytes)
  {
    Place<unsigned char>(read, sources, data, display, picture);
  }
  else
  {
    Place<float>(read, sources, data, display, picture);
  }
  return picture;
}
}
