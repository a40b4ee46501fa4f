// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoComparisonReport.h"

#include "vtkRelievoCauseList.h"
#include "vtkRelievoComparedFrame.h"
#include "vtkRelievoFrameComparison.h"
#include "vtkRelievoReportPage.h"

#include "vtkBase64Utilities.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"
#include "vtk_zlib.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkRelievoComparisonReport);

using relievo::compare::Frame;
using relievo::compare::WriteCount;
using Json = nlohmann::ordered_json;

namespace
{
// Maximum rows of a Markdown table; a last row counts the others.
constexpr std::size_t MostRows = 50;

std::string Encode(const unsigned char* bytes, std::size_t size)
{
  std::string text((size + 2) / 3 * 4, '\0');
  const auto length = vtkBase64Utilities::Encode(bytes, static_cast<unsigned long>(size),
    reinterpret_cast<unsigned char*>(&text[0])); // NOLINT(*-reinterpret-cast)
  text.resize(static_cast<std::size_t>(length));
  return text;
}

// Compresses bytes for browsers' DecompressionStream("deflate").
std::string Deflate(const std::vector<unsigned char>& bytes)
{
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::vector<unsigned char> packed(size);
  compress2(packed.data(), &size, bytes.data(), static_cast<uLong>(bytes.size()), 6);
  return Encode(packed.data(), size);
}

// Converts a pixel's number from the upper left corner to one from the lower left.
std::size_t Flip(const std::array<int, 2>& size, std::size_t pixel)
{
  const auto width = static_cast<std::size_t>(size[0]);
  return (static_cast<std::size_t>(size[1]) - 1 - pixel / width) * width + pixel % width;
}

// Packs one 32-bit word per pixel, top row first: the lowest bytes of all words, then the next
// ones, because runs of equal bytes compress well.
template <typename GetWord>
std::string PackWords(const std::array<int, 2>& size, const GetWord& get)
{
  const std::size_t pixels = static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]);
  std::vector<unsigned char> bytes(4 * pixels);
  for (std::size_t i = 0; i < pixels; ++i)
  {
    const std::uint32_t word = get(Flip(size, i));
    for (std::size_t b = 0; b < 4; ++b)
    {
      bytes[b * pixels + i] = static_cast<unsigned char>(word >> (8 * b));
    }
  }
  return Deflate(bytes);
}

// Rounds away a float's seven lowest bits, noise that does not compress.
std::uint32_t RoundFloat(double value)
{
  const auto number = static_cast<float>(value);
  std::uint32_t word = 0;
  std::memcpy(&word, &number, sizeof(word));
  return std::isfinite(number) ? (word + 0x40u) & ~0x7Fu : word;
}

unsigned char RoundLevel(float level)
{
  return std::isnan(level)
    ? 0
    : static_cast<unsigned char>(std::lround(std::min(255.f, std::max(0.f, level))));
}

// The picture as PNG, without alpha, so that the page does not show through.
std::string PackPicture(const Frame& frame)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(frame.Size[0], frame.Size[1], 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* to = static_cast<unsigned char*>(image->GetScalarPointer());
  for (std::size_t i = 0; i < frame.Pixels; ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      *to++ = RoundLevel(frame.Level(i, frame.Picture.Components < 3 ? 0 : c));
    }
  }
  vtkNew<vtkPNGWriter> writer;
  writer->WriteToMemoryOn();
  writer->SetInputData(image);
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  return "data:image/png;base64," +
    Encode(bytes->GetPointer(0), static_cast<std::size_t>(bytes->GetNumberOfValues()));
}

// A frame's data for the page.
Json PackFrame(const Frame& frame)
{
  Json json = { { "size", frame.Size } };
  const int components = frame.Picture.Components;
  if (components > 0)
  {
    json["picture"] = PackPicture(frame);
  }
  if (components == 2 || components == 4)
  {
    json["alpha"] = PackWords(frame.Size, [&](std::size_t i) {
      return static_cast<std::uint32_t>(RoundLevel(frame.Level(i, components - 1)));
    });
  }
  if (!frame.Actor.empty())
  {
    json["actor"] = PackWords(
      frame.Size, [&](std::size_t i) { return static_cast<std::uint32_t>(frame.Actor[i]); });
    Json names = Json::array();
    for (const relievo::compare::Object& object : frame.Objects)
    {
      names.push_back(object.Name);
    }
    json["objects"] = names;
  }
  if (!frame.Depth.empty())
  {
    json["depth"] =
      PackWords(frame.Size, [&](std::size_t i) { return RoundFloat(frame.Depth[i]); });
  }
  return json;
}

Json PackFrames(vtkRelievoFrameComparison* comparison)
{
  Json frames = Json::array();
  for (vtkImageData* image : { comparison->GetBaseline(), comparison->GetFrame() })
  {
    Frame frame;
    frames.push_back(image && frame.Read(image).empty() ? PackFrame(frame) : Json::object());
  }
  return frames;
}

// Escapes HTML and Markdown, mentions (@), issues (#), and the borders of table cells.
std::string EscapeMarkdown(const std::string& text)
{
  std::string escaped;
  for (const char c : text)
  {
    if (c == '<' || c == '>' || c == '&')
    {
      escaped += c == '<' ? "&lt;" : c == '>' ? "&gt;" : "&amp;";
    }
    else if (c == '@' || c == '#')
    {
      escaped += std::string(1, c) + "&#8203;";
    }
    else if (c == '\n' || c == '\r')
    {
      escaped += ' ';
    }
    else
    {
      escaped +=
        (std::strchr("\\`*_[]|~", c) && c != '\0') ? "\\" + std::string(1, c) : std::string(1, c);
    }
  }
  return escaped;
}
}

//------------------------------------------------------------------------------
struct vtkRelievoComparisonReport::Internals
{
  Json Entries = Json::array();
};

//------------------------------------------------------------------------------
vtkRelievoComparisonReport::vtkRelievoComparisonReport()
  : Internal(new Internals)
{
}

//------------------------------------------------------------------------------
vtkRelievoComparisonReport::~vtkRelievoComparisonReport() = default;

//------------------------------------------------------------------------------
void vtkRelievoComparisonReport::Add(
  const char* name, vtkRelievoFrameComparison* comparison, bool withFrames)
{
  if (!comparison)
  {
    vtkErrorMacro("Add was given no comparison; give it a vtkRelievoFrameComparison.");
    return;
  }
  const std::string text = comparison->GetText();
  Json entry = { { "name", name ? name : "" }, { "summary", text.substr(0, text.find('\n')) } };
  entry.update(Json::parse(comparison->GetJSON()));
  if (withFrames)
  {
    entry["frames"] = PackFrames(comparison);
    if (vtkImageData* causes = comparison->GetCauses())
    {
      const int* places =
        vtkIntArray::SafeDownCast(causes->GetPointData()->GetScalars())->GetPointer(0);
      const int* size = causes->GetDimensions();
      entry["places"] = PackWords(
        { size[0], size[1] }, [&](std::size_t i) { return static_cast<std::uint32_t>(places[i]); });
    }
  }
  this->Internal->Entries.push_back(entry);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkRelievoComparisonReport::AddNotCompared(const char* name, const char* reason)
{
  this->Internal->Entries.push_back(
    { { "name", name ? name : "" }, { "summary", reason ? reason : "" }, { "alike", false } });
  this->Modified();
}

//------------------------------------------------------------------------------
std::string vtkRelievoComparisonReport::GetHTML()
{
  // Text in a <script> element must not look like markup; JSON can write characters as numbers.
  std::string data;
  for (const char c : this->Internal->Entries.dump(-1, ' ', true, Json::error_handler_t::replace))
  {
    data += c == '<' ? "\\u003c" : c == '>' ? "\\u003e" : c == '&' ? "\\u0026" : std::string(1, c);
  }
  std::string page = relievo::compare::ReportPage;
  // The data, which may contain the other mark, last.
  for (const auto& [mark, value] :
    { std::pair<std::string, std::string>("@COLORS@", Json(relievo::compare::GetColors()).dump()),
      { "@SHARES@",
        Json({ { "behind", BehindCauses }, { "around", AroundChosen }, { "chosen", OfChosen } })
          .dump() },
      { "@DATA@", data } })
  {
    page.replace(page.find(mark), mark.size(), value);
  }
  return page;
}

//------------------------------------------------------------------------------
std::string vtkRelievoComparisonReport::GetMarkdown()
{
  std::string text;
  for (const Json& entry : this->Internal->Entries)
  {
    text += (text.empty() ? "### " : "\n### ") + EscapeMarkdown(entry["name"]) + "\n\n" +
      EscapeMarkdown(entry["summary"]) + "\n";
    const Json causes = entry.value("causes", Json::array());
    if (!causes.empty())
    {
      text += "\n| object | cause | pixels |\n|---|---|---:|\n";
    }
    std::size_t rest = 0;
    for (std::size_t i = 0; i < causes.size(); ++i)
    {
      const Json& cause = causes[i];
      if (i >= MostRows)
      {
        rest += cause["pixels"].get<std::size_t>();
        continue;
      }
      const std::string words = cause["words"];
      text += "| " + EscapeMarkdown(cause["label"]) + " | " +
        EscapeMarkdown(words.empty() ? cause["cause"].get<std::string>() : words) + " | " +
        WriteCount(cause["pixels"]) + " |\n";
    }
    if (causes.size() > MostRows)
    {
      text +=
        "| " + WriteCount(causes.size() - MostRows) + " more | | " + WriteCount(rest) + " |\n";
    }
    if (entry.value("unexplained", 0) > 0)
    {
      text += "\nUnexplained: " + WriteCount(entry["unexplained"]) + " pixels\n";
    }
    const Json within = entry.value("within_limits", Json::object());
    if (within.value("edge", 0) + within.value("rounding", 0) > 0)
    {
      text += "\nWithin limits: " + WriteCount(within["edge"]) + " pixels at smooth edges, " +
        WriteCount(within["rounding"]) + " of rounding\n";
    }
    std::string missing;
    for (const Json& word : entry.value("cannot_be_detected", Json::array()))
    {
      missing += (missing.empty() ? "" : ", ") + word.get<std::string>();
    }
    if (!missing.empty())
    {
      text += "\nCannot be detected in these files: " + missing + "\n";
    }
  }
  return text;
}

//------------------------------------------------------------------------------
void vtkRelievoComparisonReport::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Comparisons: " << this->Internal->Entries.size() << "\n";
}
