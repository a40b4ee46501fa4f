// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoFrameReport.h"

#include "vtkRelievoGpuTimer.h"
#include "vtkRelievoStage.h"
#include "vtkRenderer.h"

#include <cmath>
#include <cstdio>
#include <sstream>

namespace
{
std::string Quote(const std::string& text)
{
  std::string out = "\"";
  for (unsigned char c : text)
  {
    if (c == '"' || c == '\\')
    {
      out += '\\';
    }
    if (c < 0x20)
    {
      char escape[8];
      std::snprintf(escape, sizeof escape, "\\u%04x", c);
      out += escape;
    }
    else
    {
      out += static_cast<char>(c);
    }
  }
  return out + "\"";
}

std::string Number(double value)
{
  if (value < 0.0)
  {
    return "null";
  }
  std::ostringstream out;
  if (value == std::floor(value) && std::abs(value) < 1e15)
  {
    out << static_cast<long long>(value); // bytes and counts with all digits
  }
  else
  {
    out << value;
  }
  return out.str();
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
  std::ostringstream out;
  long long bytes = this->Bytes;
  out << "{\n  \"size\": [" << this->Size[0] << ", " << this->Size[1] << "],\n  \"stages\": [";
  const char* separator = "\n";
  for (const Line& line : this->Lines)
  {
    bytes += line.Bytes;
    out << separator << "    {\"name\": " << Quote(line.Name)
        << ", \"ran\": " << (line.Ran ? "true" : "false") << ", \"code\": " << Quote(line.Code)
        << ", \"reason\": " << Quote(line.Reason)
        << ", \"gpu_ms\": " << (line.Ran ? Number(timer.GetMilliseconds(line.Name)) : "null")
        << ", \"bytes\": " << line.Bytes << ", \"draw_calls\": " << Number(line.DrawCalls)
        << ", \"label\": " << Quote(line.Label) << "}";
    separator = ",\n";
  }
  out << "\n  ],\n  \"gpu_ms\": " << Number(timer.GetMilliseconds("frame"))
      << ",\n  \"bytes\": " << bytes;
  if (timer.IsUntimed())
  {
    out << ",\n  \"untimed\": "
        << Quote("this OpenGL draws when a frame's commands are all there; stages are timed in the "
                 "frames after a report was read");
  }
  for (const auto& fact : this->Facts)
  {
    out << ",\n  " << Quote(fact.first) << ": "
        << (!fact.second.IsValid()       ? "null"
               : fact.second.IsNumeric() ? Number(fact.second.ToDouble())
                                         : Quote(fact.second.ToString()));
  }
  out << "\n}\n";
  return out.str();
}
