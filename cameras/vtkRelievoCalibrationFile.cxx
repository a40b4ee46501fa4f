// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoCalibrationFile.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>
#include <utility>

namespace
{
using Json = nlohmann::json;
using Numbers = std::vector<double>;

constexpr std::size_t MostBytes = std::size_t(1) << 26; // of a file

int GetMostCoefficients(const std::string& lens)
{
  return lens == "brown" ? 8 : lens == "fisheye" ? 4 : 1;
}

std::string Trim(const std::string& text)
{
  const char* const blanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blanks);
  return first == std::string::npos ? ""
                                    : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

// YAML, as far as calibrations need it.

using Lines = std::vector<std::string>;

std::size_t GetIndent(const std::string& line)
{
  const std::size_t indent = line.find_first_not_of(' ');
  return indent == std::string::npos ? line.size() : indent;
}

// Without the comment.
std::string DropComment(const std::string& line)
{
  char quote = 0;
  for (std::size_t i = 0; i < line.size(); ++i)
  {
    if (quote)
    {
      quote = line[i] == quote ? 0 : quote;
    }
    else if (line[i] == '"' || line[i] == '\'')
    {
      quote = line[i];
    }
    else if (line[i] == '#' && (i == 0 || line[i - 1] == ' ' || line[i - 1] == '\t'))
    {
      return line.substr(0, i);
    }
  }
  return line;
}

// A list in brackets, lists among its items.
Json ReadFlow(const std::string& text, std::size_t& at)
{
  Json list = Json::array();
  std::string item;
  const auto finish = [&] {
    const std::string word = Trim(item);
    item.clear();
    if (!word.empty())
    {
      const std::optional<double> number = vtkRelievoCalibrationFile::ToNumber(word);
      list.push_back(number ? Json(*number) : Json(word));
    }
  };
  for (++at; at < text.size(); ++at)
  {
    if (text[at] == '[')
    {
      list.push_back(ReadFlow(text, at));
    }
    else if (text[at] == ']')
    {
      finish();
      return list;
    }
    else if (text[at] == ',')
    {
      finish();
    }
    else
    {
      item += text[at];
    }
  }
  return {}; // it does not end
}

// The entries of a map, each with what follows its key.
std::vector<std::pair<std::string, Lines>> GetEntries(const Lines& lines)
{
  std::vector<std::pair<std::string, Lines>> entries;
  std::size_t indent = std::string::npos;
  int depth = 0; // of brackets
  for (const std::string& line : lines)
  {
    if (Trim(line).empty())
    {
      continue;
    }
    indent = indent == std::string::npos ? GetIndent(line) : indent;
    const std::size_t colon = line.find(':');
    std::string rest = line;
    if (GetIndent(line) == indent && colon != std::string::npos && line[indent] != '-' &&
      depth == 0)
    {
      entries.emplace_back(Trim(line.substr(0, colon)), Lines());
      rest = line.substr(colon + 1);
    }
    if (!entries.empty())
    {
      entries.back().second.push_back(rest);
    }
    depth += static_cast<int>(
      std::count(rest.begin(), rest.end(), '[') - std::count(rest.begin(), rest.end(), ']'));
  }
  return entries;
}

Json ReadYAMLValue(Lines lines, int depth)
{
  std::string first = Trim(lines[0]);
  if (first.rfind('!', 0) == 0)
  {
    const std::size_t end = first.find(' ');
    first = end == std::string::npos ? "" : Trim(first.substr(end));
  }
  if (first.empty() && lines.size() > 1 && depth > 0)
  {
    Json map = Json::object();
    for (const auto& [key, value] : GetEntries(Lines(lines.begin() + 1, lines.end())))
    {
      map[key] = ReadYAMLValue(value, depth - 1);
    }
    return map;
  }
  if (first.rfind('[', 0) == 0)
  {
    lines[0] = first;
    std::string text;
    for (const std::string& line : lines)
    {
      text += line + ' ';
    }
    std::size_t at = 0;
    return ReadFlow(text, at);
  }
  if (first.size() > 1 && (first[0] == '"' || first[0] == '\'') && first.back() == first[0])
  {
    return first.substr(1, first.size() - 2);
  }
  const std::optional<double> number = vtkRelievoCalibrationFile::ToNumber(first);
  return number ? Json(*number) : Json(first);
}

// What calibrations say, of a file in YAML.
Json ReadYAML(const std::string& text)
{
  Lines lines;
  for (const std::string& line : vtkRelievoCalibrationFile::Split(text, '\n'))
  {
    const bool isMark =
      line.rfind('%', 0) == 0 || line.rfind("---", 0) == 0 || line.rfind("...", 0) == 0;
    lines.push_back(isMark ? "" : DropComment(line));
  }
  Json file = Json::object();
  for (const auto& [key, value] : GetEntries(lines))
  {
    for (const char* known : { "image_width", "image_height", "camera_matrix",
           "distortion_coefficients", "distortion_model", "fisheye_model" })
    {
      if (key == known)
      {
        file[key] = ReadYAMLValue(value, 1);
      }
    }
  }
  return file;
}

// The numbers of a matrix, row by row; none if it is no matrix.
std::optional<Numbers> GetMatrix(const Json& value)
{
  const Json& data = value.is_object() && value.contains("data") ? value["data"] : value;
  Numbers numbers;
  if (!data.is_array())
  {
    return std::nullopt;
  }
  for (const Json& each : data)
  {
    const std::optional<Numbers> row =
      each.is_number() ? Numbers{ each.get<double>() } : GetMatrix(each);
    if (!row)
    {
      return std::nullopt;
    }
    numbers.insert(numbers.end(), row->begin(), row->end());
  }
  return numbers;
}

bool AreAllFinite(const Numbers& numbers)
{
  return std::all_of(
    numbers.begin(), numbers.end(), [](double value) { return std::isfinite(value); });
}

// The lens's name by what a file says of it; empty if there is no such lens.
std::string GetLensName(const Json& file)
{
  static const std::vector<std::pair<std::string, std::string>> names = { { "plumb_bob", "brown" },
    { "rational_polynomial", "brown" }, { "equidistant", "fisheye" }, { "fisheye", "fisheye" },
    { "division", "division" }, { "", "brown" } };
  const Json& flag = file.value("fisheye_model", Json());
  if ((flag.is_number() && flag.get<double>() != 0.0) || (flag.is_boolean() && flag.get<bool>()))
  {
    return "fisheye";
  }
  const Json& model = file.value("distortion_model", Json(""));
  const auto found = std::find_if(names.begin(), names.end(),
    [&model](const auto& each) { return model.is_string() && each.first == model; });
  return found == names.end() ? "" : found->second;
}

vtkRelievoCalibrationFile Interpret(const Json& file)
{
  vtkRelievoCalibrationFile found;
  for (int i = 0; i < 2; ++i)
  {
    const char* name = i == 0 ? "image_width" : "image_height";
    const Json& size = file.value(name, Json());
    const double pixels = size.is_number() ? size.get<double>() : 0.0;
    if (!(pixels >= 1.0 && pixels <= 1 << 20 && pixels == std::floor(pixels)))
    {
      found.Wrong = std::string(name) + ": " + (size.is_null() ? "it is missing, " : "") +
        "expected a whole number of pixels";
      return found;
    }
    found.Size[i] = static_cast<int>(pixels);
  }
  const Json& given = file.value("camera_matrix", Json());
  const Numbers k = GetMatrix(given).value_or(Numbers());
  if (!vtkRelievoCalibrationFile::IsMatrix(k))
  {
    found.Wrong = std::string("camera_matrix: ") + (given.is_null() ? "it is missing, " : "") +
      "expected 9 numbers, row by row: fx, skew, cx, 0, fy, cy, 0, 0, 1, fx and fy above 0";
    return found;
  }
  found.Intrinsics = { k[0], k[4], k[1], k[2], k[5] };
  found.Kind = GetLensName(file);
  if (found.Kind.empty())
  {
    found.Wrong = "distortion_model: got " + file["distortion_model"].dump() +
      ", expected plumb_bob, rational_polynomial, equidistant, fisheye or division";
    return found;
  }
  const Json& coefficients = file.value("distortion_coefficients", Json::array());
  const std::optional<Numbers> values = GetMatrix(coefficients);
  const auto most = static_cast<std::size_t>(GetMostCoefficients(found.Kind));
  if (!values || !AreAllFinite(*values) ||
    std::any_of(values->begin() + static_cast<std::ptrdiff_t>(std::min(most, values->size())),
      values->end(), [](double value) { return value != 0.0; }))
  {
    found.Wrong = "distortion_coefficients: expected at most " + std::to_string(most) +
      " finite numbers, of the lens " + found.Kind + ", and zeros behind them";
    return found;
  }
  found.Values.assign(
    values->begin(), values->begin() + static_cast<std::ptrdiff_t>(std::min(most, values->size())));
  if (found.Kind != "fisheye" &&
    std::all_of(
      found.Values.begin(), found.Values.end(), [](double value) { return value == 0.0; }))
  {
    found.Kind = "pinhole";
    found.Values.clear();
  }
  return found;
}
}

//------------------------------------------------------------------------------
std::optional<double> vtkRelievoCalibrationFile::ToNumber(const std::string& word)
{
  const std::size_t sign = word.size() > 1 && word[0] == '+' ? 1 : 0;
  double value = 0.0;
  const char* end = word.data() + word.size();
  const auto read = std::from_chars(word.data() + sign, end, value);
  return read.ec == std::errc() && read.ptr == end && std::isfinite(value)
    ? std::optional<double>(value)
    : std::nullopt;
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkRelievoCalibrationFile::Split(const std::string& text, char separator)
{
  std::vector<std::string> parts;
  std::istringstream stream(text + separator);
  for (std::string part; std::getline(stream, part, separator);)
  {
    parts.push_back(part);
  }
  return parts;
}

//------------------------------------------------------------------------------
std::string vtkRelievoCalibrationFile::GetExtension(const std::string& path)
{
  const std::size_t dot = path.rfind('.');
  std::string extension = dot == std::string::npos ? "" : path.substr(dot);
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](char letter) { return letter >= 'A' && letter <= 'Z' ? char(letter + 32) : letter; });
  return extension;
}

//------------------------------------------------------------------------------
vtkRelievoCalibrationFile vtkRelievoCalibrationFile::Read(const std::string& path)
{
  vtkRelievoCalibrationFile failed;
  std::ifstream stream(path, std::ios::binary);
  std::string text(std::istreambuf_iterator<char>(stream), {});
  if (!stream.is_open() || stream.bad() || text.size() > MostBytes)
  {
    failed.Wrong =
      text.size() > MostBytes ? "it is larger than a calibration is" : "cannot be read";
    return failed;
  }
  Json file;
  if (GetExtension(path) == ".json")
  {
    file = Json::parse(text, nullptr, false, true); // OpenCV's may have comments
  }
  else
  {
    file = ReadYAML(text);
  }
  if (!file.is_object())
  {
    failed.Wrong = "it is no JSON object, expected camera_matrix, image_width, image_height and "
                   "distortion_coefficients";
    return failed;
  }
  return Interpret(file);
}
