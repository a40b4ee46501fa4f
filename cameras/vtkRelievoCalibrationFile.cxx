// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoCalibrationFile.h"

#include "vtkRelievoCalibrationForms.h"
#include "vtkRelievoLensCamera.h"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

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
using Numbers = std::vector<double>;

// Per file: enough for all points of hundreds of pictures. yaml-cpp may take 250 times as much.
constexpr std::size_t MostBytes = std::size_t(1) << 23;
constexpr std::size_t MostDepth = vtkRelievoCalibrationForms::MostDepth;
constexpr std::size_t MostValues = 100000; // of entries that are read from YAML

int GetLens(const std::string& name)
{
  return name == "pinhole" ? vtkRelievoLensCamera::PINHOLE
    : name == "brown"      ? vtkRelievoLensCamera::BROWN_CONRADY
    : name == "fisheye"    ? vtkRelievoLensCamera::FISHEYE
                           : vtkRelievoLensCamera::DIVISION;
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

// Builds the entries that EntryNames lists, of a YAML document and of the cameras in it. yaml-cpp's
// own nodes would also keep the others, such as all points of a calibration's pictures.
class EntryPicker : public YAML::EventHandler
{
public:
  Json File;

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t) override { this->Place(mark, {}); }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override
  {
    throw YAML::ParserException(mark, "an alias (*), which is not supported");
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t,
    const std::string& text) override
  {
    if (this->ExpectsKey())
    {
      this->Open.back().Key = text;
      this->Open.back().HasKey = true;
      return;
    }
    const bool isQuoted = tag == "!";
    const std::optional<double> number =
      isQuoted ? std::nullopt : vtkRelievoCalibrationFile::ToNumber(text);
    this->Place(mark, number ? Json(*number) : Json(text));
  }
  void OnSequenceStart(
    const YAML::Mark& mark, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override
  {
    this->Open.push_back({ this->Place(mark, Json::array()), false, false, {} });
  }
  void OnSequenceEnd() override { this->Open.pop_back(); }
  void OnMapStart(
    const YAML::Mark& mark, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override
  {
    this->Open.push_back({ this->Place(mark, Json::object()), true, false, {} });
  }
  void OnMapEnd() override { this->Open.pop_back(); }

private:
  struct Level
  {
    Json* Value; // nullptr: left out
    bool IsMap;
    bool HasKey; // Key waits for its value
    std::string Key;
  };

  bool ExpectsKey() const
  {
    return !this->Open.empty() && this->Open.back().IsMap && !this->Open.back().HasKey;
  }

  // Whether the value of the innermost key is wanted.
  bool IsWanted() const
  {
    const std::string& key = this->Open.back().Key;
    const bool isCamera = IsCameraName(this->Open[0].Key);
    return this->Open.size() > (isCamera ? 2 : 1) || (isCamera && this->Open.size() == 1) ||
      std::any_of(std::begin(EntryNames), std::end(EntryNames), [&key](const auto& names) {
        return std::find(names.begin(), names.end(), key) != names.end();
      });
  }

  // Where the value is kept; nullptr: it is left out.
  Json* Place(const YAML::Mark& mark, Json value)
  {
    if (this->Open.empty())
    {
      this->File = std::move(value);
      return &this->File;
    }
    Level& level = this->Open.back();
    if (this->ExpectsKey()) // with a list or a map
    {
      level.Key.clear();
      level.HasKey = true;
      return nullptr;
    }
    level.HasKey = false;
    if (!level.Value || this->Open.size() > MostDepth || (level.IsMap && !this->IsWanted()))
    {
      return nullptr;
    }
    if (++this->Count > MostValues)
    {
      throw YAML::ParserException(mark, "more values than a calibration has");
    }
    if (!level.IsMap)
    {
      level.Value->push_back(std::move(value));
      return &level.Value->back();
    }
    if (level.Value->contains(level.Key))
    {
      throw YAML::ParserException(mark, level.Key + " is there twice");
    }
    return &((*level.Value)[level.Key] = std::move(value));
  }

  std::vector<Level> Open;
  std::size_t Count = 0;
};

// The first document. `message` receives an error message, or remains empty.
Json ReadYAML(const std::string& text, std::string& message)
{
  EntryPicker picker;
  try
  {
    std::istringstream stream(text);
    YAML::Parser(stream).HandleNextDocument(picker);
  }
  catch (const YAML::Exception& error)
  {
    message = "line " + std::to_string(error.mark.line + 1) + ": expected YAML, got " + error.msg;
  }
  return picker.File;
}

// A value as JSON text; bytes that are not UTF-8, which YAML and XML may contain, are replaced.
std::string ToText(const Json& value)
{
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
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
      found.Error = "roi: got " + ToText(region) +
        ", expected x_offset, y_offset, width and height of a part of the picture";
      return;
    }
    if (!together || part / bin < 1)
    {
      found.Error = name + ": got " + ToText(binning) + ", expected a whole number of pixels";
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
    return "camera_model: got " + ToText(model) + ", expected pinhole; " +
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
  found.Error = TakeKalibr(file);
  if (!found.Error.empty())
  {
    return found;
  }
  for (int i = 0; i < 2; ++i)
  {
    const auto [name, size] = FindEntry(file, i == 0 ? WIDTH : HEIGHT);
    const double pixels = size.is_number() ? size.get<double>() : 0.0;
    if (!(pixels >= 1.0 && pixels <= 1 << 20 && pixels == std::floor(pixels)))
    {
      found.Error = name + ": " + (size.is_null() ? "it is missing, " : "") +
        "expected a whole number of pixels";
      return found;
    }
    found.Size[i] = static_cast<int>(pixels);
  }
  const Entry given = FindEntry(file, MATRIX);
  const Numbers k = GetMatrix(given.Value).value_or(Numbers());
  if (!vtkRelievoCalibrationFile::IsMatrix(k))
  {
    found.Error = given.Name + ": " + (given.Value.is_null() ? "it is missing, " : "") +
      "expected 9 numbers, row by row: fx, skew, cx, 0, fy, cy, 0, 0, 1, fx and fy above 0";
    return found;
  }
  found.Intrinsics = { k[0], k[4], k[1], k[2], k[5] };
  TakePart(file, found);
  if (!found.Error.empty())
  {
    return found;
  }
  found.Kind = GetLensName(file);
  if (found.Kind.empty())
  {
    found.Error = "distortion_model: got " + ToText(FindEntry(file, MODEL).Value) +
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
    found.Error = coefficients.Name + ": " + miscount;
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
    found.Error = coefficients.Name + ": " +
      (values ? "got " + std::to_string(values->size()) + " numbers, " : "") + "expected " +
      vtkRelievoLensCamera::GetCounts(lens) + " finite numbers for the lens " + found.Kind +
      ", and zeros after them";
    if (found.Kind == "brown" && found.Values.size() == 3)
    {
      found.Error += "; the third is p1 in OpenCV's order, k3 comes after p1 and p2";
    }
    else if (found.Kind == "brown" && found.Values.size() > 8)
    {
      found.Error += "; thin prisms (s1 to s4) and tilted sensors (tau) are not supported";
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
    failed.Error = "expected a file, not a folder, a pipe or a device";
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
    failed.Error = isLarge ? "it is too large for a calibration" : "cannot be read";
    return failed;
  }
  std::string extension = GetExtension(path);
  if (extension.size() > 3 && extension.substr(extension.size() - 3) == ".gz")
  {
    extension.resize(extension.size() - 3);
    if (!vtkRelievoCalibrationForms::Unpack(text, MostBytes))
    {
      failed.Error = "expected complete gzip data no larger than a calibration";
      return failed;
    }
  }
  Json file;
  if (extension == ".json")
  {
    // Calibrations contain no deeper values; OpenCV's files may have comments.
    const auto isHigh = [](int depth, Json::parse_event_t, const Json&) {
      return depth <= vtkRelievoCalibrationForms::MostDepth;
    };
    file = Json::parse(text, isHigh, false, true);
  }
  else if (extension == ".xml")
  {
    file = vtkRelievoCalibrationForms::ReadXML(text);
  }
  else if (extension == ".txt")
  {
    file = vtkRelievoCalibrationForms::ReadCOLMAP(text, failed.Error);
    if (!failed.Error.empty())
    {
      return failed;
    }
  }
  else
  {
    file = ReadYAML(text, failed.Error);
    if (!failed.Error.empty())
    {
      return failed;
    }
  }
  if (!file.is_object())
  {
    failed.Error = std::string("it is no ") +
      (extension == ".xml"       ? "opencv_storage of XML"
          : extension == ".json" ? "JSON object"
                                 : "YAML map") +
      ", expected camera_matrix, image_width, image_height and "
      "distortion_coefficients";
    return failed;
  }
  return Interpret(std::move(file));
}
