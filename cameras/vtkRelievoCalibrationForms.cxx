// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoCalibrationForms.h"

#include "vtkRelievoCalibrationFile.h"

#include "vtk_zlib.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <sstream>
#include <vector>

namespace
{
using Json = nlohmann::json;

std::string Trim(const std::string& text)
{
  const char* const blanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blanks);
  return first == std::string::npos ? ""
                                    : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

// A number or a string.
Json ToValue(const std::string& text)
{
  const std::string word = Trim(text);
  const std::optional<double> number = vtkRelievoCalibrationFile::ToNumber(word);
  const bool isQuoted = word.size() > 1 && word.front() == '"' && word.back() == '"';
  return number ? Json(*number) : Json(isQuoted ? word.substr(1, word.size() - 2) : word);
}

// The words separated by blanks.
std::vector<std::string> GetWords(const std::string& text)
{
  std::istringstream stream(text);
  return { std::istream_iterator<std::string>(stream), std::istream_iterator<std::string>() };
}

struct ColmapModel
{
  const char* Name;
  std::size_t Focals; // 1: fx equals fy
  const char* Lens;   // its distortion_model
  std::size_t Coefficients;
};

constexpr ColmapModel ColmapModels[] = { { "SIMPLE_PINHOLE", 1, "none", 0 },
  { "PINHOLE", 2, "none", 0 }, { "SIMPLE_RADIAL", 1, "plumb_bob", 1 },
  { "RADIAL", 1, "plumb_bob", 2 }, { "OPENCV", 2, "plumb_bob", 4 },
  { "FULL_OPENCV", 2, "rational_polynomial", 8 }, { "OPENCV_FISHEYE", 2, "fisheye", 4 },
  { "SIMPLE_RADIAL_FISHEYE", 1, "fisheye", 1 }, { "RADIAL_FISHEYE", 1, "fisheye", 2 } };
}

//------------------------------------------------------------------------------
bool vtkRelievoCalibrationForms::Unpack(std::string& bytes, std::size_t most)
{
  z_stream stream = {};
  constexpr int gzip = 15 + 16; // the largest window, and gzip's header
  if (inflateInit2(&stream, gzip) != Z_OK)
  {
    return false;
  }
  stream.next_in = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_in = static_cast<uInt>(bytes.size());
  std::string text;
  std::array<char, 1 << 14> part;
  int state = Z_OK;
  while (state == Z_OK && text.size() <= most)
  {
    stream.next_out = reinterpret_cast<Bytef*>(part.data());
    stream.avail_out = static_cast<uInt>(part.size());
    state = inflate(&stream, Z_NO_FLUSH);
    text.append(part.data(), part.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  bytes = text;
  return state == Z_STREAM_END && text.size() <= most;
}

//------------------------------------------------------------------------------
Json vtkRelievoCalibrationForms::ReadXML(const std::string& text)
{
  Json file = Json::object();
  std::vector<std::string> path; // of elements
  std::string content;
  bool isWhole = false;
  std::size_t at = 0;
  while (!isWhole)
  {
    const std::size_t tag = text.find('<', at);
    if (tag == std::string::npos)
    {
      return {};
    }
    content += text.substr(at, tag - at);
    const bool isComment = text.compare(tag, 4, "<!--") == 0;
    const std::string end = isComment ? "-->" : ">";
    const std::size_t close = text.find(end, tag);
    if (close == std::string::npos)
    {
      return {};
    }
    at = close + end.size();
    const std::string inside = text.substr(tag + 1, close - tag - 1);
    if (isComment || inside.rfind('?', 0) == 0)
    {
      continue;
    }
    if (inside.rfind('/', 0) != 0)
    {
      path.push_back(inside.substr(0, inside.find_first_of(" \t\r\n/")));
      content.clear();
      if (path[0] != "opencv_storage" || path.size() > static_cast<std::size_t>(MostDepth))
      {
        return {};
      }
      if (inside.back() != '/')
      {
        continue;
      }
    }
    else if (path.empty() || Trim(inside.substr(1)) != path.back())
    {
      return {};
    }
    // End of an element: an entry, or a part of a matrix.
    if (path.size() == 2 && !file.contains(path[1]))
    {
      file[path[1]] = ToValue(content);
    }
    else if (path.size() == 3 && (!file.contains(path[1]) || file[path[1]].is_object()))
    {
      Json value = ToValue(content);
      if (path[2] == "data")
      {
        value = Json::array();
        for (const std::string& word : GetWords(content))
        {
          value.push_back(ToValue(word));
        }
      }
      file[path[1]][path[2]] = value;
    }
    path.pop_back();
    content.clear();
    isWhole = path.empty();
  }
  return file;
}

//------------------------------------------------------------------------------
Json vtkRelievoCalibrationForms::ReadCOLMAP(const std::string& text, std::string& error)
{
  std::vector<std::vector<std::string>> cameras;
  for (const std::string& line : vtkRelievoCalibrationFile::Split(text, '\n'))
  {
    const std::vector<std::string> words = GetWords(line);
    if (!words.empty() && words[0][0] != '#')
    {
      cameras.push_back(words);
    }
  }
  if (cameras.size() != 1 || cameras[0].size() < 4)
  {
    error = (cameras.size() > 1 ? "it has " + std::to_string(cameras.size()) + " lines"
                                : std::string("it has no camera")) +
      ", expected COLMAP's cameras.txt of one camera: CAMERA_ID MODEL WIDTH HEIGHT PARAMS...";
    return {};
  }
  const std::vector<std::string>& words = cameras[0];
  const auto* const model = std::find_if(std::begin(ColmapModels), std::end(ColmapModels),
    [&words](const ColmapModel& each) { return words[1] == each.Name; });
  if (model == std::end(ColmapModels))
  {
    error = "no lens supports the model '" + words[1] + "', expected one of";
    for (const ColmapModel& each : ColmapModels)
    {
      error += std::string(&each == ColmapModels ? " " : ", ") + each.Name;
    }
    return {};
  }
  std::vector<double> numbers;
  for (std::size_t i = 2; i < words.size(); ++i)
  {
    const std::optional<double> number = vtkRelievoCalibrationFile::ToNumber(words[i]);
    if (!number)
    {
      break;
    }
    numbers.push_back(*number);
  }
  // Width and height, focal lengths, the principal point, coefficients.
  const std::size_t count = 2 + model->Focals + 2 + model->Coefficients;
  if (numbers.size() != count || words.size() != 2 + count)
  {
    error = "got " + std::to_string(words.size() - 4) + " parameters of " + model->Name +
      ", expected " + std::to_string(count - 2) + " finite numbers";
    return {};
  }
  const double* const center = numbers.data() + 2 + model->Focals;
  return { { "width", numbers[0] }, { "height", numbers[1] },
    { "camera_matrix",
      { numbers[2], 0.0, center[0] - 0.5, 0.0, center[-1], center[1] - 0.5, 0.0, 0.0, 1.0 } },
    { "distortion_model", model->Lens },
    { "distortion_coefficients",
      std::vector<double>(center + 2, center + 2 + model->Coefficients) } };
}
