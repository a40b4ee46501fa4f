// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoFrameComparison.h"

#include "vtkRelievoCauseList.h"
#include "vtkRelievoComparedFrame.h"
#include "vtkRelievoComparisonLimits.h"
#include "vtkRelievoEXRReader.h"
#include "vtkRelievoImageFile.h"
#include "vtkRelievoMessageText.h"
#include "vtkRelievoObjectChanges.h"
#include "vtkRelievoPixelCauses.h"
#include "vtkRelievoReaderProcess.h"

#include "vtkCallbackCommand.h"
#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <set>
#include <system_error>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkRelievoFrameComparison);

using relievo::compare::Cause;
using relievo::compare::CauseWords;
using relievo::compare::Finding;
using relievo::compare::Frame;
using relievo::compare::Join;
using relievo::compare::PixelCauses;
using relievo::compare::WriteCount;
using Json = nlohmann::ordered_json;

namespace
{
// Maximum causes in the text; a last line counts the others.
constexpr std::size_t MostLines = 18;

// The layers of an OpenEXR file, or why it cannot be read.
struct Layers
{
  std::string Failure;
  vtkSmartPointer<vtkImageData> Image;
};

template <typename Visit>
void VisitFields(Layers& layers, Visit&& visit)
{
  visit(layers.Failure, layers.Image);
}

// Runs in the process of the file.
void ReadLayers(const std::string& path, const vtkRelievoReaderProcess::Say&, Layers& made)
{
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  vtkRelievoReaderProcess::Allow(error ? 0 : size);
  vtkNew<vtkRelievoEXRReader> reader;
  vtkNew<vtkCallbackCommand> keep;
  keep->SetClientData(&made.Failure);
  keep->SetCallback([](vtkObject*, unsigned long, void* kept, void* text) {
    *static_cast<std::string*>(kept) =
      vtkRelievoMessageText::OfMessage(static_cast<const char*>(text));
  });
  reader->AddObserver(vtkCommand::ErrorEvent, keep);
  reader->SetFileName(path.c_str());
  reader->UpdateInformation();
  int extent[6] = { 0, -1, 0, -1, 0, -1 };
  reader->GetOutputInformation(0)->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
  // Smooth layers compress well: the values need more memory than the file's size lets expect.
  // Allow() permits 32 bytes per byte, so this is four times their size as floats.
  const double values = std::max(0.0, double(extent[1]) - extent[0] + 1) *
    std::max(0.0, double(extent[3]) - extent[2] + 1) * reader->GetNumberOfChannels();
  constexpr double MostValues = 4e9; // damaged headers promise more
  vtkRelievoReaderProcess::Allow(static_cast<std::uint64_t>(std::min(values, MostValues) / 2.0));
  reader->Update();
  if (reader->GetErrorCode() == vtkErrorCode::NoError)
  {
    made.Failure.clear();
    made.Image = reader->GetOutput();
  }
  else if (made.Failure.empty())
  {
    made.Failure = path + ": cannot be read";
  }
}

// Reads an image file; on failure returns null, and `failure` names the file and the reason.
vtkSmartPointer<vtkImageData> ReadImage(const std::string& path, std::string& failure)
{
  const std::size_t dot = path.rfind('.');
  std::string extension = dot == std::string::npos ? "" : path.substr(dot + 1);
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  if (extension != "exr")
  {
    vtkSmartPointer<vtkImageData> image = vtkRelievoImageFile::Read(path, failure);
    failure = image ? std::string() : path + ": expected " + failure;
    return image;
  }
  Layers made;
  const std::string end = vtkRelievoReaderProcess::Do<ReadLayers>(
    path, [](const std::string&, double) { return true; }, made);
  failure = end.empty() ? made.Failure : path + ": its reader " + end;
  if (end.rfind("used more than", 0) == 0)
  {
    failure += "; write it with fewer layers or pixels";
  }
  if (failure.empty() && !made.Image)
  {
    failure = path + ": its reader crashed: its result is damaged";
  }
  return failure.empty() ? made.Image : nullptr;
}

// The causes that cannot be detected, because a frame lacks data.
std::vector<std::string> ListUndetectable(const Frame& a, const Frame& b)
{
  std::set<Cause> missing;
  const auto lacks = [&](bool isThere, std::initializer_list<Cause> causes) {
    if (!isThere)
    {
      missing.insert(causes);
    }
  };
  lacks(a.HasCamera && b.HasCamera, { Cause::Camera });
  lacks(!a.Actor.empty() && !b.Actor.empty(),
    { Cause::Removed, Cause::Added, Cause::Moved, Cause::Visibility });
  lacks(a.HasPositions() && b.HasPositions() && a.HasDepths() && b.HasDepths(),
    { Cause::Moved, Cause::Shape });
  lacks(a.Surface.count("normal") != 0 && b.Surface.count("normal") != 0, { Cause::Normal });
  lacks(a.Surface.count("albedo") != 0 && b.Surface.count("albedo") != 0, { Cause::Color });
  lacks(a.HasLights && b.HasLights, { Cause::Light });
  // A frame with a record has layers for every stage and every casting light in its picture.
  const bool recorded = a.HasRecord && b.HasRecord;
  lacks(recorded || (!a.Shadow.empty() && !b.Shadow.empty()), { Cause::Shadow });
  lacks(recorded, { Cause::Overlay, Cause::Tone, Cause::Settings });
  const std::pair<const char*, Cause> stages[] = { { "light", Cause::Lamps }, { "fog", Cause::Fog },
    { "ambient", Cause::Ambient }, { "marker", Cause::Markers }, { "blend", Cause::Translucent } };
  for (const auto& [name, cause] : stages)
  {
    lacks(recorded || (a.Stages.count(name) != 0 && b.Stages.count(name) != 0), { cause });
  }
  for (const Frame* frame : { &a, &b })
  {
    for (const auto& [name, layer] : frame->Surface)
    {
      lacks(a.Surface.count(name) != 0 && b.Surface.count(name) != 0,
        { name == "normal"     ? Cause::Normal
            : name == "albedo" ? Cause::Color
                               : Cause::Array });
    }
  }
  std::vector<std::string> words;
  for (const Cause cause : missing)
  {
    words.emplace_back(CauseWords[static_cast<std::size_t>(cause)]);
  }
  return words;
}

// Names and values come from files: replaces control characters by question marks, because they
// could steer the terminal or end the line.
std::string Show(std::string text)
{
  const auto steers = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; };
  std::replace_if(text.begin(), text.end(), steers, '?');
  return text;
}

std::string Pad(const std::string& text, std::size_t width, bool toRight = false)
{
  // Continuation bytes of UTF-8 add no width.
  const auto length = static_cast<std::size_t>(std::count_if(text.begin(), text.end(),
    [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
  const std::string blanks(width > length ? width - length : 0, ' ');
  return toRight ? blanks + text : text + blanks;
}
}

//------------------------------------------------------------------------------
struct vtkRelievoFrameComparison::Internals
{
  vtkSmartPointer<vtkImageData> Baseline, Frame, Causes;
  std::vector<Finding> Findings;
  std::array<int, 2> Size{};
  std::size_t Pixels = 0, Unexplained = 0, Edge = 0, Rounding = 0;
  std::size_t Objects = 0, Lights = 0;
  std::vector<std::string> Undetectable, Versions[2];
  bool IsCompared = false;

  void Reset()
  {
    this->Causes = nullptr;
    this->Findings.clear();
    this->Pixels = this->Unexplained = this->Edge = this->Rounding = 0;
    this->Objects = this->Lights = 0;
    this->Undetectable.clear();
    this->IsCompared = false;
  }

  void Compare(const relievo::compare::Frame& a, const relievo::compare::Frame& b,
    const relievo::compare::Limits& limits);
  std::size_t CountDifferent(const std::string& kind) const;
};

//------------------------------------------------------------------------------
void vtkRelievoFrameComparison::Internals::Compare(const relievo::compare::Frame& a,
  const relievo::compare::Frame& b, const relievo::compare::Limits& limits)
{
  this->Size = a.Size;
  this->Versions[0] = a.Versions;
  this->Versions[1] = b.Versions;
  this->IsCompared = true;
  relievo::compare::CauseList list;
  if (a.Size != b.Size)
  {
    Finding& size = list.At(list.Find(Cause::Size, "picture"));
    size.Words = "size: " + std::to_string(a.Size[0]) + " x " + std::to_string(a.Size[1]) +
      ", now " + std::to_string(b.Size[0]) + " x " + std::to_string(b.Size[1]);
    size.More["size"] = b.Size;
    this->Findings = list.Get();
    return;
  }
  this->Undetectable = ListUndetectable(a, b);
  if (a.HasCamera && b.HasCamera && !a.SeesAs(b))
  {
    list.Find(Cause::Camera, "picture");
    this->Findings = list.Get();
    return;
  }
  const relievo::compare::ObjectChanges objects(a, b, limits, list);
  const PixelCauses causes(a, b, limits, objects, list);
  this->Objects = objects.GetNumber();
  this->Lights = a.Lights.size();
  this->Findings = list.Get();
  this->Unexplained = causes.Count(PixelCauses::Unexplained);
  this->Edge = causes.Count(PixelCauses::WithinEdge);
  this->Rounding = causes.Count(PixelCauses::WithinRounding);
  this->Pixels = this->Unexplained;

  std::vector<int> order(this->Findings.size());
  std::vector<std::size_t> sorted(this->Findings.size());
  for (std::size_t i = 0; i < sorted.size(); ++i)
  {
    sorted[i] = i;
    this->Pixels += this->Findings[i].Pixels;
  }
  std::stable_sort(sorted.begin(), sorted.end(), [this](std::size_t x, std::size_t y) {
    return this->Findings[x].Pixels > this->Findings[y].Pixels;
  });
  std::vector<Finding> findings;
  for (std::size_t i = 0; i < sorted.size(); ++i)
  {
    order[sorted[i]] = static_cast<int>(i);
    findings.push_back(this->Findings[sorted[i]]);
  }
  this->Findings = findings;

  this->Causes = vtkSmartPointer<vtkImageData>::New();
  this->Causes->SetDimensions(a.Size[0], a.Size[1], 1);
  vtkNew<vtkIntArray> array;
  array->SetName("cause");
  array->SetNumberOfTuples(static_cast<vtkIdType>(a.Pixels));
  std::transform(causes.Get().begin(), causes.Get().end(), array->GetPointer(0),
    [&](int cause) { return cause < 0 ? cause : order[static_cast<std::size_t>(cause)]; });
  this->Causes->GetPointData()->SetScalars(array);
}

//------------------------------------------------------------------------------
std::size_t vtkRelievoFrameComparison::Internals::CountDifferent(const std::string& kind) const
{
  std::set<std::pair<std::string, int>> different;
  for (const Finding& finding : this->Findings)
  {
    if (finding.Kind == kind)
    {
      different.insert({ finding.Name, finding.Id });
    }
  }
  return different.size();
}

//------------------------------------------------------------------------------
vtkRelievoFrameComparison::vtkRelievoFrameComparison()
  : Internal(new Internals)
{
  const relievo::compare::Limits limits;
  this->ColorLevels = limits.ColorLevels;
  this->NormalAngle = limits.NormalAngle;
  this->DepthPixels = limits.DepthPixels;
}

//------------------------------------------------------------------------------
vtkRelievoFrameComparison::~vtkRelievoFrameComparison() = default;

//------------------------------------------------------------------------------
bool vtkRelievoFrameComparison::Fail(const std::string& text)
{
  this->FailureText = text;
  vtkErrorMacro(<< text << ".");
  return false;
}

//------------------------------------------------------------------------------
void vtkRelievoFrameComparison::SetBaseline(vtkImageData* image)
{
  if (this->Internal->Baseline != image)
  {
    this->Internal->Baseline = image;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkImageData* vtkRelievoFrameComparison::GetBaseline()
{
  return this->Internal->Baseline;
}

//------------------------------------------------------------------------------
void vtkRelievoFrameComparison::SetFrame(vtkImageData* image)
{
  if (this->Internal->Frame != image)
  {
    this->Internal->Frame = image;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkImageData* vtkRelievoFrameComparison::GetFrame()
{
  return this->Internal->Frame;
}

//------------------------------------------------------------------------------
bool vtkRelievoFrameComparison::ReadBaseline(const char* path)
{
  this->FailureText.clear();
  this->SetBaseline(ReadImage(path ? path : "", this->FailureText));
  return this->FailureText.empty() || this->Fail(std::string(this->FailureText));
}

//------------------------------------------------------------------------------
bool vtkRelievoFrameComparison::ReadFrame(const char* path)
{
  this->FailureText.clear();
  this->SetFrame(ReadImage(path ? path : "", this->FailureText));
  return this->FailureText.empty() || this->Fail(std::string(this->FailureText));
}

//------------------------------------------------------------------------------
bool vtkRelievoFrameComparison::Compare()
{
  this->FailureText.clear();
  this->Internal->Reset();
  relievo::compare::Frame frames[2];
  const std::pair<const char*, vtkImageData*> given[2] = {
    { "the baseline", this->Internal->Baseline }, { "the frame", this->Internal->Frame }
  };
  for (int i = 0; i < 2; ++i)
  {
    if (!given[i].second)
    {
      return this->Fail(std::string(given[i].first) + " is missing; set or read it first");
    }
    const std::string message = frames[i].Read(given[i].second);
    if (!message.empty())
    {
      return this->Fail(std::string(given[i].first) + " " + message);
    }
  }
  if (frames[0].HasRecord && frames[1].HasRecord && frames[0].IsPortable != frames[1].IsPortable)
  {
    const int portable = frames[0].IsPortable ? 0 : 1;
    return this->Fail(std::string(given[portable].first) + " is portable, but " +
      given[1 - portable].first + " is not; draw both in the same way");
  }
  const relievo::compare::Limits limits = { this->ColorLevels, this->NormalAngle,
    this->DepthPixels };
  this->Internal->Compare(frames[0], frames[1], limits);
  return true;
}

//------------------------------------------------------------------------------
bool vtkRelievoFrameComparison::GetAlike()
{
  return this->Internal->IsCompared && this->Internal->Findings.empty() &&
    this->Internal->Pixels == 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoFrameComparison::GetNumberOfDifferentPixels()
{
  return static_cast<vtkIdType>(this->Internal->Pixels);
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoFrameComparison::GetNumberOfUnexplainedPixels()
{
  return static_cast<vtkIdType>(this->Internal->Unexplained);
}

//------------------------------------------------------------------------------
vtkImageData* vtkRelievoFrameComparison::GetCauses()
{
  return this->Internal->Causes;
}

//------------------------------------------------------------------------------
std::string vtkRelievoFrameComparison::GetText()
{
  const Internals& self = *this->Internal;
  if (!self.IsCompared)
  {
    return "not compared\n";
  }
  std::string text = this->GetAlike() ? "alike" : "different";
  std::string counts;
  for (const auto& [kind, all] :
    { std::pair("actor", self.Objects), std::pair("light", self.Lights) })
  {
    const std::size_t different = self.CountDifferent(kind);
    if (different > 0)
    {
      const std::size_t most = std::max(all, different); // an added one is not among all
      counts += (counts.empty() ? "" : ", ") + std::to_string(different) + " of " +
        std::to_string(most) + (std::string(kind) == "actor" ? " object" : " light") +
        (most == 1 ? "" : "s");
    }
  }
  const std::size_t all =
    static_cast<std::size_t>(self.Size[0]) * static_cast<std::size_t>(self.Size[1]);
  text += ": " + counts + (counts.empty() ? "" : "; ") + WriteCount(self.Pixels) + " of " +
    WriteCount(all) + " pixels\n";
  std::size_t labels = 0, words = 0;
  std::vector<std::array<std::string, 3>> lines;
  std::size_t rest = 0, restPixels = 0;
  for (const Finding& finding : self.Findings)
  {
    if (lines.size() == MostLines)
    {
      ++rest;
      restPixels += finding.Pixels;
      continue;
    }
    const std::string said = finding.Words.empty()
      ? std::string(CauseWords[static_cast<std::size_t>(finding.Is)])
      : finding.Words;
    lines.push_back({ Show(finding.GetLabel()), Show(said), WriteCount(finding.Pixels) });
    labels = std::max(labels, std::min<std::size_t>(28, lines.back()[0].size()));
    words = std::max(words, std::min<std::size_t>(60, said.size()));
  }
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    text += "  " + Pad(lines[i][0], labels) + "  " + Pad(lines[i][1], words) + "  " +
      Pad(lines[i][2], 9, true) + (i == 0 ? " pixels" : "") + "\n";
  }
  if (rest > 0)
  {
    text += "  " + WriteCount(rest) + " more causes, in the JSON" + "  " + WriteCount(restPixels) +
      " pixels\n";
  }
  if (self.Unexplained > 0)
  {
    text += "  unexplained: " + WriteCount(self.Unexplained) + " pixels\n";
  }
  if (self.Edge + self.Rounding > 0)
  {
    text += "within limits: " + WriteCount(self.Edge) + " pixels at smooth edges, " +
      WriteCount(self.Rounding) + " of rounding\n";
  }
  if (!self.Undetectable.empty())
  {
    text += "cannot be detected in these files: " + Join(self.Undetectable) + "\n";
  }
  return text;
}

//------------------------------------------------------------------------------
std::string vtkRelievoFrameComparison::GetJSON()
{
  const Internals& self = *this->Internal;
  Json causes = Json::array();
  for (const Finding& finding : self.Findings)
  {
    Json entry = { { "cause", CauseWords[static_cast<std::size_t>(finding.Is)] },
      { "kind", finding.Kind } };
    if (!finding.Name.empty())
    {
      entry["name"] = finding.Name;
    }
    if (finding.Id >= 0)
    {
      entry["id"] = finding.Id;
    }
    entry["label"] = finding.GetLabel();
    entry["pixels"] = finding.Pixels;
    entry["words"] = finding.Words;
    entry.update(finding.More);
    causes.push_back(entry);
  }
  const Json all = { { "alike", this->GetAlike() }, { "pixels", self.Pixels },
    { "size", self.Size }, { "causes", causes },
    { "within_limits", { { "edge", self.Edge }, { "rounding", self.Rounding } } },
    { "unexplained", self.Unexplained }, { "cannot_be_detected", self.Undetectable },
    { "limits",
      { { "color_levels", this->ColorLevels }, { "normal_angle", this->NormalAngle },
        { "depth_pixels", this->DepthPixels } } },
    { "versions", { { "baseline", self.Versions[0] }, { "frame", self.Versions[1] } } } };
  return all.dump(2, ' ', false, Json::error_handler_t::replace);
}

//------------------------------------------------------------------------------
int vtkRelievoFrameComparison::GetRecordVersion()
{
  return relievo::compare::RecordVersion;
}

//------------------------------------------------------------------------------
std::string vtkRelievoFrameComparison::GetCauseWords()
{
  return Join({ CauseWords.begin(), CauseWords.end() });
}

//------------------------------------------------------------------------------
std::string vtkRelievoFrameComparison::GetCauseColor(const char* word)
{
  const auto& colors = relievo::compare::GetColors();
  const auto found = colors.find(word ? word : "");
  return found == colors.end() ? std::string() : found->second;
}

//------------------------------------------------------------------------------
void vtkRelievoFrameComparison::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Baseline: " << this->Internal->Baseline << "\n";
  os << indent << "Frame: " << this->Internal->Frame << "\n";
  os << indent << "ColorLevels: " << this->ColorLevels << "\n";
  os << indent << "NormalAngle: " << this->NormalAngle << "\n";
  os << indent << "DepthPixels: " << this->DepthPixels << "\n";
  os << indent << "Alike: " << this->GetAlike() << "\n";
  os << indent << "FailureText: " << this->FailureText << "\n";
}
