// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FrameTimes.h"

#include <sstream>

namespace
{
double GetTime(const std::string& line)
{
  const std::string key = "\"gpu_ms\": ";
  const std::size_t at = line.find(key);
  const std::string number = at == std::string::npos ? "null" : line.substr(at + key.size());
  return number.compare(0, 4, "null") == 0 ? -1.0 : std::stod(number);
}
}

namespace relievoTest
{
FrameTimes::FrameTimes(const std::string& report)
{
  std::istringstream lines(report); // a line for each stage, then the totals
  for (std::string line; std::getline(lines, line);)
  {
    const std::string key = "{\"name\": \"";
    const std::size_t at = line.find(key);
    if (at == std::string::npos)
    {
      this->Frame = line.find("\"gpu_ms\"") == std::string::npos ? this->Frame : GetTime(line);
    }
    else if (line.find("\"ran\": true") != std::string::npos)
    {
      const std::size_t from = at + key.size();
      this->Stages[line.substr(from, line.find('"', from) - from)] = GetTime(line);
    }
  }
}

std::string FrameTimes::Judge() const
{
  double sum = 0.0;
  for (const auto& stage : this->Stages)
  {
    if (stage.second < 0.0)
    {
      return stage.first + " has no time";
    }
    sum += stage.second;
  }
  // Reports have six digits.
  return sum <= this->Frame * (1.0 + 1e-5)
    ? std::string()
    : "the stages took " + std::to_string(sum) + " ms, the frame " + std::to_string(this->Frame);
}
}
