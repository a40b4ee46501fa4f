// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoCalibrationFile.h"

#include "vtkRelievoCalibrationForms.h"
#include "vtkRelievoLensCamera.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <system_error>
#include <utility>

namespace
{
using Json = nlohmann::json;
using vtkRelievoCalibrationForms::Trim;
using Numbers = std::vector<double>;

constexpr std::size_t MostBytes = std::size_t(1) << 26; // per file
constexpr int MostDepth = vtkRelievoCalibrationForms::MostDepth;

int GetLens(const std::string& name)
{
  return name == "pinhole" ? vtkRelievoLensCamera::PINHOLE
    : name == "brown"      ? vtkRelievoLensCamera::BROWN_CONRADY
    : name == "fisheye"    ? vtkRelievoLensCamera::FISHEYE
                           : vtkRelievoLensCamera::DIVISION;
}

// The subset of YAML used by calibrations.

using Lines = std::vector<std::string>;

std::size_t GetIndent(const std::string& line)
{
  const std::size_t indent = line.find_first_not_of(' ');
  return indent == std::string::npos ? line.size() : indent;
}

// Removes the comment.
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

// Parses a list in brackets, with nested lists; null if they are nested too deeply.
Json ReadFlow(const std::string& text, std::size_t& at, int depth = 0)
{
  if (depth > MostDepth)
  {
    return {};
  }
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
      list.push_back(ReadFlow(text, at, depth + 1));
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
  return {}; // the list is not closed
}

// The entries of a map: each key with the lines of its value.
std::vector<std::pair<std::string, Lines>> GetEntries(const Lines& lines)
{
  std::vector<std::pair<std::string, Lines>> entries;
  std::size_t indent = std::string::npos;
  int depth = 0; // of open brackets
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
  if (first.empty() && lines.size() > 1 && Trim(lines[1]).rfind("- ", 0) == 0)
  {
    Json list = Json::array();
    for (std::size_t i = 1; i < lines.size(); ++i)
    {
      const std::string item = Trim(lines[i]);
      const std::string word = item.rfind("- ", 0) == 0 ? Trim(item.substr(2)) : item;
      const std::optional<double> number = vtkRelievoCalibrationFile::ToNumber(word);
      list.push_back(number ? Json(*number) : Json(word));
    }
    return list;
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

// The entries: their names in files of OpenCV and of ROS's calibrator, in a CameraInfo of ROS 1 and
// 2, and in files of Kalibr and EuRoC.
enum
{
  WIDTH,
  HEIGHT,
  MATRIX,
  COEFFICIENTS,
  MODEL,
  FISHEYE_MODEL,
  BINNING_X,
  BINNING_Y,
  REGION,
  CAMERA_MODEL,
  INTRINSICS,
  RESOLUTION
};
const std::vector<std::string> EntryNames[] = { { "image_width", "width" },
  { "image_height", "height" }, { "camera_matrix", "K", "k" },
  { "distortion_coefficients", "D", "d", "distortion_coeffs" }, { "distortion_model" },
  { "fisheye_model" }, { "binning_x" }, { "binning_y" }, { "roi" }, { "camera_model" },
  { "intrinsics" }, { "resolution" } };

struct Entry
{
  std::string Name;
  Json Value; // null if missing
};

Entry FindEntry(const Json& file, int which)
{
  for (const std::string& name : EntryNames[which])
  {
    if (file.contains(name))
    {
      return { name, file[name] };
    }
  }
  return { EntryNames[which][0], {} };
}

// A camera in Kalibr's chain: cam0, cam1, ...
bool IsCameraName(const std::string& key)
{
  return key.size() > 3 && key.rfind("cam", 0) == 0 &&
    key.find_first_not_of("0123456789", 3) == std::string::npos;
}

// The known entries of a YAML map, and of the cameras in it.
Json PickEntries(const Lines& lines, bool hasCameras)
{
  Json file = Json::object();
  for (const auto& [key, value] : GetEntries(lines))
  {
    for (const std::vector<std::string>& names : EntryNames)
    {
      if (std::find(names.begin(), names.end(), key) != names.end())
      {
        file[key] = ReadYAMLValue(value, 1);
      }
    }
    if (hasCameras && IsCameraName(key))
    {
      file[key] = PickEntries(Lines(value.begin() + 1, value.end()), false);
    }
  }
  return file;
}

Json ReadYAML(const std::string& text)
{
  Lines lines;
  for (const std::string& line : vtkRelievoCalibrationFile::Split(text, '\n'))
  {
    const bool isMark =
      line.rfind('%', 0) == 0 || line.rfind("---", 0) == 0 || line.rfind("...", 0) == 0;
    lines.push_back(isMark ? "" : DropComment(line));
  }
  return PickEntries(lines, true);
}

// The numbers of a matrix, row by row; none if the value is not a matrix.
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

// Error message if the count of numbers contradicts the matrix's own rows and columns; else empty.
std::string GetMiscount(const Json& value, std::size_t count)
{
  double expected = 1.0;
  for (const char* side : { "rows", "cols" })
  {
    if (!value.is_object() || !value.contains(side) || !value[side].is_number())
    {
      return "";
    }
    expected *= value[side].get<double>();
  }
  std::ostringstream words;
  words << "its rows and cols give " << expected << " numbers, but its data has " << count;
  return expected == static_cast<double>(count) ? "" : words.str();
}

bool AreAllFinite(const Numbers& numbers)
{
  return std::all_of(
    numbers.begin(), numbers.end(), [](double value) { return std::isfinite(value); });
}

// The lens's name for the file's entries; empty if there is no such lens.
std::string GetLensName(const Json& file)
{
  static const std::vector<std::pair<std::string, std::string>> names = { { "plumb_bob", "brown" },
    { "rational_polynomial", "brown" }, { "radtan", "brown" }, { "radial-tangential", "brown" },
    { "equidistant", "fisheye" }, { "equi", "fisheye" }, { "fisheye", "fisheye" },
    { "division", "division" }, { "none", "pinhole" }, { "", "brown" } };
  const Json flag = FindEntry(file, FISHEYE_MODEL).Value;
  if ((flag.is_number() && flag.get<double>() != 0.0) || (flag.is_boolean() && flag.get<bool>()))
  {
    return "fisheye";
  }
  const Json given = FindEntry(file, MODEL).Value;
  const Json model = given.is_null() ? Json("") : given;
  const auto found = std::find_if(names.begin(), names.end(),
    [&model](const auto& each) { return model.is_string() && each.first == model; });
  return found == names.end() ? "" : found->second;
}

// A non-negative whole number of pixels; 0 if the value is missing.
std::optional<int> GetPixels(const Json& value)
{
  const double pixels = value.is_number() ? value.get<double>() : 0.0;
  const bool good = (value.is_null() || value.is_number()) && pixels >= 0.0 && pixels <= 1 << 20 &&
    pixels == std::floor(pixels);
  return good ? std::optional<int>(static_cast<int>(pixels)) : std::nullopt;
}

// A CameraInfo's picture may be a part of the sensor's (`roi`, in pixels of the sensor), with
// binned pixels (`binning_x`, `binning_y`), which its matrix ignores: computes the picture's size
// and matrix. A binned pixel's centre is the mean of its sensor pixels'.
void TakePart(const Json& file, vtkRelievoCalibrationFile& found)
{
  const Json region = FindEntry(file, REGION).Value;
  for (int i = 0; i < 2; ++i)
  {
    const auto [name, binning] = FindEntry(file, i == 0 ? BINNING_X : BINNING_Y);
    const std::optional<int> together = GetPixels(binning);
    const auto get = [&region](const char* key) {
      return GetPixels(region.is_object() && region.contains(key) ? region[key] : Json());
    };
    const std::optional<int> offset = get(i == 0 ? "x_offset" : "y_offset");
    const std::optional<int> size = get(i == 0 ? "width" : "height");
    const int all = found.Size[i];
    const int part = size.value_or(0) > 0 ? *size : all - offset.value_or(0);
    const int bin = std::max(together.value_or(0), 1); // 0 means 1
    if (!(region.is_null() || region.is_object()) || !offset || !size || part < 1 ||
      *offset + part > all)
    {
      found.Wrong = "roi: got " + region.dump() +
        ", expected x_offset, y_offset, width and height of a part of the picture";
      return;
    }
    if (!together || part / bin < 1)
    {
      found.Wrong = name + ": got " + binning.dump() + ", expected a whole number of pixels";
      return;
    }
    found.Size[i] = part / bin;
    double& focal = found.Intrinsics[i];
    double& center = found.Intrinsics[3 + i];
    focal /= bin;
    center = (center - *offset + 0.5) / bin - 0.5;
    found.Intrinsics[2] /= i == 0 ? bin : 1; // skew, in units of columns
  }
}

// Replaces Kalibr's chain by its only camera, and converts the resolution and intrinsics of Kalibr
// and EuRoC to size and matrix. Returns an error message, or an empty string.
std::string TakeKalibr(Json& file)
{
  std::vector<std::string> cameras;
  for (const auto& [key, value] : file.items())
  {
    if (IsCameraName(key) && value.is_object())
    {
      cameras.push_back(key);
    }
  }
  if (cameras.size() > 1)
  {
    return "it has " + std::to_string(cameras.size()) + " cameras, " + cameras.front() + " to " +
      cameras.back() + ", expected one; put each of them into a file of its own";
  }
  if (!cameras.empty())
  {
    file = Json(file[cameras[0]]);
  }
  const Json intrinsics = FindEntry(file, INTRINSICS).Value;
  if (intrinsics.is_null() || !FindEntry(file, MATRIX).Value.is_null())
  {
    return "";
  }
  const Json model = FindEntry(file, CAMERA_MODEL).Value;
  if (!(model.is_null() || model == "pinhole"))
  {
    return "camera_model: got " + model.dump() + ", expected pinhole; " +
      "other models, such as omni, eucm and ds, are not supported";
  }
  const Numbers k = GetMatrix(intrinsics).value_or(Numbers());
  if (k.size() != 4)
  {
    return "intrinsics: expected 4 numbers: fx, fy, cx, cy";
  }
  const Json resolution = FindEntry(file, RESOLUTION).Value;
  if (!resolution.is_array() || resolution.size() != 2)
  {
    return "resolution: expected 2 numbers: columns, rows";
  }
  file["image_width"] = resolution[0];
  file["image_height"] = resolution[1];
  file["camera_matrix"] = { k[0], 0.0, k[2], 0.0, k[1], k[3], 0.0, 0.0, 1.0 };
  return "";
}

vtkRelievoCalibrationFile Interpret(Json file)
{
  vtkRelievoCalibrationFile found;
  found.Wrong = TakeKalibr(file);
  if (!found.Wrong.empty())
  {
    return found;
  }
  for (int i = 0; i < 2; ++i)
  {
    const auto [name, size] = FindEntry(file, i == 0 ? WIDTH : HEIGHT);
    const double pixels = size.is_number() ? size.get<double>() : 0.0;
    if (!(pixels >= 1.0 && pixels <= 1 << 20 && pixels == std::floor(pixels)))
    {
      found.Wrong = name + ": " + (size.is_null() ? "it is missing, " : "") +
        "expected a whole number of pixels";
      return found;
    }
    found.Size[i] = static_cast<int>(pixels);
  }
  const Entry given = FindEntry(file, MATRIX);
  const Numbers k = GetMatrix(given.Value).value_or(Numbers());
  if (!vtkRelievoCalibrationFile::IsMatrix(k))
  {
    found.Wrong = given.Name + ": " + (given.Value.is_null() ? "it is missing, " : "") +
      "expected 9 numbers, row by row: fx, skew, cx, 0, fy, cy, 0, 0, 1, fx and fy above 0";
    return found;
  }
  found.Intrinsics = { k[0], k[4], k[1], k[2], k[5] };
  TakePart(file, found);
  if (!found.Wrong.empty())
  {
    return found;
  }
  found.Kind = GetLensName(file);
  if (found.Kind.empty())
  {
    found.Wrong = "distortion_model: got " + FindEntry(file, MODEL).Value.dump() +
      ", expected plumb_bob, radtan, rational_polynomial, equidistant, fisheye, division or none";
    return found;
  }
  const Entry coefficients = FindEntry(file, COEFFICIENTS);
  const std::optional<Numbers> values =
    coefficients.Value.is_null() ? Numbers() : GetMatrix(coefficients.Value);
  const std::string miscount =
    values ? GetMiscount(coefficients.Value, values->size()) : std::string();
  if (!miscount.empty())
  {
    found.Wrong = coefficients.Name + ": " + miscount;
    return found;
  }
  // OpenCV's longer models equal this one if the further coefficients are 0.
  const int lens = GetLens(found.Kind);
  found.Values = values.value_or(Numbers());
  const auto isTaken = [&found, lens] {
    return vtkRelievoLensCamera::TakesCount(lens, static_cast<int>(found.Values.size()));
  };
  while (!isTaken() && found.Values.back() == 0.0)
  {
    found.Values.pop_back();
  }
  if (found.Kind == "brown" && found.Values.size() == 1)
  {
    found.Values.push_back(0.0); // only k1
  }
  if (!values || !AreAllFinite(*values) || !isTaken())
  {
    found.Wrong = coefficients.Name + ": " +
      (values ? "got " + std::to_string(values->size()) + " numbers, " : "") + "expected " +
      vtkRelievoLensCamera::GetCounts(lens) + " finite numbers for the lens " + found.Kind +
      ", and zeros after them";
    if (found.Kind == "brown" && found.Values.size() == 3)
    {
      found.Wrong += "; the third is p1 in OpenCV's order, k3 comes after p1 and p2";
    }
    else if (found.Kind == "brown" && found.Values.size() > 8)
    {
      found.Wrong += "; thin prisms (s1 to s4) and tilted sensors (tau) are not supported";
    }
    return found;
  }
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
  std::string name = path;
  std::transform(name.begin(), name.end(), name.begin(),
    [](char letter) { return letter >= 'A' && letter <= 'Z' ? char(letter + 32) : letter; });
  std::size_t dot = name.rfind('.');
  if (dot != std::string::npos && dot > 0 && name.compare(dot, std::string::npos, ".gz") == 0)
  {
    const std::size_t inner = name.rfind('.', dot - 1);
    dot = inner == std::string::npos ? dot : inner;
  }
  return dot == std::string::npos ? "" : name.substr(dot);
}

//------------------------------------------------------------------------------
vtkRelievoCalibrationFile vtkRelievoCalibrationFile::Read(const std::string& path)
{
  vtkRelievoCalibrationFile failed;
  // Reading a pipe would block, and a device may not end.
  std::error_code trouble;
  const bool isFile = std::filesystem::is_regular_file(path, trouble);
  if (std::filesystem::exists(path, trouble) && !isFile)
  {
    failed.Wrong = "expected a file, not a folder, a pipe or a device";
    return failed;
  }
  const bool isLarge = isFile && std::filesystem::file_size(path, trouble) > MostBytes;
  std::ifstream stream(path, std::ios::binary);
  std::string text;
  if (!isLarge)
  {
    text.assign(std::istreambuf_iterator<char>(stream), {});
  }
  if (!stream.is_open() || stream.bad() || isLarge)
  {
    failed.Wrong = isLarge ? "it is too large for a calibration" : "cannot be read";
    return failed;
  }
  std::string extension = GetExtension(path);
  if (extension.size() > 3 && extension.substr(extension.size() - 3) == ".gz")
  {
    extension.resize(extension.size() - 3);
    if (!vtkRelievoCalibrationForms::Unpack(text, MostBytes))
    {
      failed.Wrong = "expected complete gzip data no larger than a calibration";
      return failed;
    }
  }
  Json file;
  if (extension == ".json")
  {
    // Calibrations contain no deeper values; OpenCV's files may have comments.
    const auto isHigh = [](int depth, Json::parse_event_t, const Json&) {
      return depth <= MostDepth;
    };
    file = Json::parse(text, isHigh, false, true);
  }
  else if (extension == ".xml")
  {
    file = vtkRelievoCalibrationForms::ReadXML(text);
  }
  else if (extension == ".txt")
  {
    file = vtkRelievoCalibrationForms::ReadCOLMAP(text, failed.Wrong);
    if (!failed.Wrong.empty())
    {
      return failed;
    }
  }
  else
  {
    file = ReadYAML(text);
  }
  if (!file.is_object())
  {
    failed.Wrong = std::string("it is no ") +
      (extension == ".xml" ? "opencv_storage of XML" : "JSON object") +
      ", expected camera_matrix, image_width, image_height and "
      "distortion_coefficients";
    return failed;
  }
  return Interpret(std::move(file));
}
