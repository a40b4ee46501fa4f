// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoFrameReport.h"

#include "vtkRelievoGpuTimer.h"
#include "vtkRelievoParameter.h"
#include "vtkRelievoStage.h"
#include "vtkRenderer.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <locale>
#include <sstream>

namespace
{
using Json = nlohmann::ordered_json;

// Integers with all digits, other numbers with six; null for unknown values.
Json Number(double value)
{
  if (value < 0.0)
  {
    return nullptr;
  }
  if (value == std::floor(value) && std::abs(value) < 1e15)
  {
    return static_cast<long long>(value);
  }
  std::ostringstream rounded;
  rounded.imbue(std::locale::classic());
  rounded << value;
  return Json::parse(rounded.str(), nullptr, false);
}

// One line, with a space after each colon and comma. Invalid UTF-8 in names is replaced.
std::string Write(const Json& value)
{
  if (!value.is_structured())
  {
    return value.dump(-1, ' ', false, Json::error_handler_t::replace);
  }
  std::string line;
  for (const auto& each : value.items())
  {
    line += (line.empty() ? "" : ", ") +
      (value.is_object() ? Write(each.key()) + ": " : std::string()) + Write(each.value());
  }
  return value.is_object() ? "{" + line + "}" : "[" + line + "]";
}

Json Fact(const vtkVariant& fact)
{
  return !fact.IsValid() ? Json(nullptr)
    : fact.IsNumeric()   ? Number(fact.ToDouble())
                         : Json(fact.ToString());
}
}

//------------------------------------------------------------------------------
void vtkRelievoFrameReport::Begin(vtkRenderer* renderer, long long bytes)
{
  this->Lines.clear();
  this->Facts.clear();
  this->Bytes = bytes;
  renderer->GetTiledSize(&this->Size[0], &this->Size[1]);
}

//------------------------------------------------------------------------------
void vtkRelievoFrameReport::Add(
  const std::string& name, bool ran, const std::string& code, const std::string& reason)
{
  Line line;
  line.Name = name;
  line.Label = vtkRelievoCapitalize(name, true);
  line.Ran = ran;
  line.Code = code;
  line.Reason = reason;
  this->Lines.push_back(line);
}

//------------------------------------------------------------------------------
void vtkRelievoFrameReport::Add(vtkRelievoStage* stage, bool ran)
{
  this->Add(stage->GetStageName(), ran, stage->GetReasonCode(), stage->GetReason());
  this->Lines.back().Label = stage->GetDescription().Label;
  this->Lines.back().Bytes = stage->GetBytesHeld();
  this->Lines.back().DrawCalls = ran ? stage->GetDrawCalls() : 0;
  this->Facts.merge(stage->GetFacts());
}

//------------------------------------------------------------------------------
std::string vtkRelievoFrameReport::GetJSON(const vtkRelievoGpuTimer& timer) const
{
  long long bytes = this->Bytes;
  Json stages = Json::array();
  for (const Line& line : this->Lines)
  {
    bytes += line.Bytes;
    stages.push_back({ { "name", line.Name }, { "ran", line.Ran }, { "code", line.Code },
      { "reason", line.Reason },
      { "gpu_ms", Number(line.Ran ? timer.GetMilliseconds(line.Name) : -1.0) },
      { "bytes", line.Bytes }, { "draw_calls", Number(line.DrawCalls) }, { "label", line.Label } });
  }
  Json report = { { "size", { this->Size[0], this->Size[1] } }, { "stages", stages },
    { "gpu_ms", Number(timer.GetMilliseconds("frame")) }, { "bytes", bytes } };
  if (timer.IsUntimed())
  {
    report["untimed"] = "this OpenGL draws when a frame's commands are all there; stages are timed "
                        "in the frames after a report was read";
  }
  for (const auto& fact : this->Facts)
  {
    report[fact.first] = Fact(fact.second);
  }
  std::string text;
  for (const auto& each : report.items())
  {
    text += (text.empty() ? "{\n  " : ",\n  ") + Write(each.key()) + ": ";
    if (each.key() != "stages")
    {
      text += Write(each.value());
      continue;
    }
    text += "[";
    const char* separator = "\n    ";
    for (const Json& stage : each.value())
    {
      text += separator + Write(stage);
      separator = ",\n    ";
    }
    text += "\n  ]";
  }
  return text + "\n}\n";
}
