// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoFrameReport.h"

#include "vtkRelievoGpuTimer.h"

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
  out << value;
  return out.str();
}
}

//------------------------------------------------------------------------------
std::string vtkRelievoFrameReport::GetJSON(const vtkRelievoGpuTimer& timer) const
{
  std::ostringstream out;
  long long bytes = 0;
  out << "{\n  \"size\": [" << this->Size[0] << ", " << this->Size[1] << "],\n  \"stages\": [";
  const char* separator = "\n";
  for (const Line& line : this->Lines)
  {
    bytes += line.Bytes;
    out << separator << "    {\"name\": " << Quote(line.Name)
        << ", \"ran\": " << (line.Ran ? "true" : "false") << ", \"reason\": " << Quote(line.Reason)
        << ", \"gpu_ms\": " << (line.Ran ? Number(timer.GetMilliseconds(line.Name)) : "null")
        << ", \"bytes\": " << line.Bytes << ", \"draw_calls\": " << Number(line.DrawCalls) << "}";
    separator = ",\n";
  }
  out << "\n  ],\n  \"gpu_ms\": " << Number(timer.GetMilliseconds("frame"))
      << ",\n  \"bytes\": " << bytes;
  if (timer.IsUntimed())
  {
    out << ",\n  \"untimed\": "
        << Quote("this OpenGL draws when a frame's commands are all there; stages are timed in the "
                 "frames "
                 "after a report was read");
  }
  out << "\n}\n";
  return out.str();
}
