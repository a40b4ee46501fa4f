// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoCalibration.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRelievoLensCamera.h"
#include "vtkRelievoOrthographicCamera.h"
#include "vtkRelievoPanoramaCamera.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <utility>

vtkStandardNewMacro(vtkRelievoCalibration);

namespace
{
using Json = nlohmann::json;
using Numbers = std::vector<double>;

constexpr int CubeFaces = 6;
constexpr std::size_t MostBytes = std::size_t(1) << 26; // of a file

struct SensorKind
{
  const char* Name;
  const char* Form;        // of its words
  std::vector<int> Counts; // of its numbers
  int Lens;                // -1: it has no intrinsics
};

const std::vector<SensorKind>& GetKinds()
{
  using Lens = vtkRelievoLensCamera;
  static const std::vector<SensorKind> kinds = {
    { "pinhole", "pinhole", { 0 }, Lens::PINHOLE },
    { "brown", "brown:K1,K2[,P1,P2[,K3[,K4,K5,K6]]]", { 2, 4, 5, 8 }, Lens::BROWN_CONRADY },
    { "fisheye", "fisheye[:K1,K2,K3,K4]", { 0, 1, 2, 3, 4 }, Lens::FISHEYE },
    { "division", "division:K", { 1 }, Lens::DIVISION },
    { "equirectangular", "equirectangular[:H,V]", { 0, 2 }, -1 },
    { "cube", "cube", { 0 }, -1 },
    { "orthographic", "orthographic[:PIXELS]", { 0, 1 }, -1 },
  };
  return kinds;
}

const SensorKind* FindKind(const std::string& name)
{
  const auto found = std::find_if(GetKinds().begin(), GetKinds().end(),
    [&name](const SensorKind& kind) { return name == kind.Name; });
  return found == GetKinds().end() ? nullptr : &*found;
}

std::string GetForms()
{
  std::string forms;
  for (const SensorKind& kind : GetKinds())
  {
    forms += std::string(kind.Form) + ", ";
  }
  return forms + "or a file .yml, .yaml or .json";
}

std::vector<std::string> SplitAt(const std::string& text, char separator)
{
  std::vector<std::string> parts;
  std::istringstream stream(text + separator);
  for (std::string part; std::getline(stream, part, separator);)
  {
    parts.push_back(part);
  }
  return parts;
}

std::string Trim(const std::string& text)
{
  const char* const blanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blanks);
  return first == std::string::npos ? ""
                                    : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

// In every locale.
std::optional<double> ToNumber(const std::string& word)
{
  const std::size_t sign = word.size() > 1 && word[0] == '+' ? 1 : 0;
  double value = 0.0;
  const char* end = word.data() + word.size();
  const auto read = std::from_chars(word.data() + sign, end, value);
  return read.ec == std::errc() && read.ptr == end && std::isfinite(value)
    ? std::optional<double>(value)
    : std::nullopt;
}

// Words taken apart.
struct Parsed
{
  std::string Kind;
  Numbers Values;
  Numbers Intrinsics;
  double Angle = 0.0;
  std::string Wrong; // empty: nothing
};

Parsed Parse(const std::string& words)
{
  Parsed parsed;
  const std::size_t colon = words.find(':');
  parsed.Kind = words.substr(0, colon);
  const SensorKind* kind = FindKind(parsed.Kind);
  const std::string got = "got '" + words + "', expected ";
  if (!kind)
  {
    parsed.Wrong = got + GetForms();
    return parsed;
  }
  std::string form = kind->Form;
  if (kind->Lens >= 0)
  {
    const std::string mark = kind->Counts.back() ? "," : ":";
    form += ", and by choice " + mark + "K=FX/FY/CX/CY or " + mark + "angle=DEG";
  }
  form += ": finite numbers";
  bool good = true;
  const std::vector<std::string> parts =
    colon == std::string::npos ? std::vector<std::string>() : SplitAt(words.substr(colon + 1), ',');
  for (const std::string& part : parts)
  {
    const bool isMatrix = part.rfind("K=", 0) == 0;
    const bool isAngle = part.rfind("angle=", 0) == 0;
    const std::vector<std::string> each =
      SplitAt(part.substr(isMatrix || isAngle ? part.find('=') + 1 : 0), '/');
    Numbers numbers;
    for (const std::string& word : each)
    {
      const std::optional<double> number = ToNumber(word);
      good = good && number;
      numbers.push_back(number.value_or(0.0));
    }
    // One of them, and behind the coefficients.
    good = good && parsed.Intrinsics.empty() && parsed.Angle == 0.0 &&
      numbers.size() == (isMatrix ? 4 : 1) && (kind->Lens >= 0 || !(isMatrix || isAngle)) &&
      (!isAngle || (numbers[0] > 0.0 && numbers[0] <= 360.0));
    if (isMatrix)
    {
      parsed.Intrinsics = numbers;
    }
    else if (isAngle)
    {
      parsed.Angle = good ? numbers[0] : 0.0;
    }
    else
    {
      parsed.Values.insert(parsed.Values.end(), numbers.begin(), numbers.end());
    }
  }
  const auto count = static_cast<int>(parsed.Values.size());
  good = good && (colon == std::string::npos || !parts.empty()) &&
    std::count(kind->Counts.begin(), kind->Counts.end(), count) != 0;
  if (good && !parsed.Intrinsics.empty())
  {
    good = parsed.Intrinsics[0] > 0.0 && parsed.Intrinsics[1] > 0.0;
    parsed.Intrinsics.insert(parsed.Intrinsics.begin() + 2, 0.0); // no skew
  }
  if (good && count > 0 && parsed.Kind == "equirectangular")
  {
    good = parsed.Values[0] > 0.0 && parsed.Values[0] <= 360.0 && parsed.Values[1] > 0.0 &&
      parsed.Values[1] <= 180.0;
  }
  if (good && count > 0 && parsed.Kind == "orthographic")
  {
    good = parsed.Values[0] > 0.0;
  }
  parsed.Wrong = good ? "" : got + form;
  return parsed;
}

//------------------------------------------------------------------------------
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
      const std::optional<double> number = ToNumber(word);
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
  const std::optional<double> number = ToNumber(first);
  return number ? Json(*number) : Json(first);
}

// What calibrations say, of a file in YAML.
Json ReadYAML(const std::string& text)
{
  Lines lines;
  for (const std::string& line : SplitAt(text, '\n'))
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

// A file's calibration.
struct Calibrated : Parsed
{
  int Size[2] = { 0, 0 };
};

Calibrated Interpret(const Json& file)
{
  Calibrated found;
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
  if (k.size() != 9 || !AreAllFinite(k) || !(k[0] > 0.0 && k[4] > 0.0) || k[3] != 0.0 ||
    k[6] != 0.0 || k[7] != 0.0 || k[8] != 1.0)
  {
    found.Wrong = std::string("camera_matrix: ") + (given.is_null() ? "it is missing, " : "") +
      "expected 9 numbers, row by row: fx, skew, cx, 0, fy, cy, 0, 0, 1, fx and fy above 0";
    return found;
  }
  found.Intrinsics = { k[0], k[4], k[1], k[2], k[5] };
  found.Kind = GetLensName(file);
  const SensorKind* kind = FindKind(found.Kind);
  if (!kind)
  {
    found.Wrong = "distortion_model: got " + file["distortion_model"].dump() +
      ", expected plumb_bob, rational_polynomial, equidistant, fisheye or division";
    return found;
  }
  const Json& coefficients = file.value("distortion_coefficients", Json::array());
  const std::optional<Numbers> values = GetMatrix(coefficients);
  const auto most = static_cast<std::size_t>(kind->Counts.back());
  if (!values || !AreAllFinite(*values) ||
    std::any_of(values->begin() + static_cast<std::ptrdiff_t>(std::min(most, values->size())),
      values->end(), [](double value) { return value != 0.0; }))
  {
    found.Wrong = "distortion_coefficients: expected at most " + std::to_string(most) +
      " finite numbers of " + kind->Form + ", and zeros behind them";
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

std::string GetExtension(const std::string& path)
{
  const std::size_t dot = path.rfind('.');
  std::string extension = dot == std::string::npos ? "" : path.substr(dot);
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](char letter) { return letter >= 'A' && letter <= 'Z' ? char(letter + 32) : letter; });
  return extension;
}

Calibrated ReadFile(const std::string& path)
{
  Calibrated failed;
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
}

//------------------------------------------------------------------------------
vtkRelievoCalibration::vtkRelievoCalibration() = default;

//------------------------------------------------------------------------------
vtkRelievoCalibration::~vtkRelievoCalibration()
{
  if (this->Camera)
  {
    this->Camera->Delete();
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoCalibration::Fail(const std::string& text)
{
  this->FailureText = text;
  vtkErrorMacro(<< text);
  return false;
}

//------------------------------------------------------------------------------
bool vtkRelievoCalibration::IsFile(const std::string& words)
{
  const std::string extension = GetExtension(words);
  return !FindKind(words.substr(0, words.find(':'))) &&
    (extension == ".yml" || extension == ".yaml" || extension == ".json");
}

//------------------------------------------------------------------------------
std::string vtkRelievoCalibration::Check(const std::string& words)
{
  return IsFile(words) ? "" : Parse(words).Wrong;
}

//------------------------------------------------------------------------------
bool vtkRelievoCalibration::SetWords(const std::string& words)
{
  this->FailureText.clear();
  const bool isFile = IsFile(words);
  const Parsed parsed = isFile ? Parsed() : Parse(words);
  if (!parsed.Wrong.empty())
  {
    return this->Fail(parsed.Wrong);
  }
  this->Words = words;
  this->Kind = parsed.Kind;
  this->Numbers = parsed.Values;
  this->Intrinsics = parsed.Intrinsics;
  this->Angle = parsed.Angle;
  this->FileSize[0] = this->FileSize[1] = 0;
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
bool vtkRelievoCalibration::Read()
{
  this->FailureText.clear();
  if (!IsFile(this->Words))
  {
    return true;
  }
  const Calibrated found = ReadFile(this->Words);
  if (!found.Wrong.empty())
  {
    return this->Fail(this->Words + ": " + found.Wrong);
  }
  this->Kind = found.Kind;
  this->Numbers = found.Values;
  this->Intrinsics = found.Intrinsics;
  std::copy_n(found.Size, 2, this->FileSize);
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
// In place of the one before.
vtkRelievoCameraModel* vtkRelievoCalibration::MakeLens(vtkCamera* view, int columns, int rows)
{
  vtkMatrix4x4* projection = view->GetProjectionTransformMatrix(double(columns) / rows, -1.0, 1.0);
  const double halfHeight = 1.0 / projection->GetElement(1, 1); // at distance 1, or all over
  const bool isParallel = view->GetParallelProjection() != 0;
  if (this->Kind == "equirectangular" || this->Kind == "cube")
  {
    auto* panorama = vtkRelievoPanoramaCamera::New();
    panorama->SetLayout(this->Kind == "cube" ? vtkRelievoPanoramaCamera::CUBE
                                             : vtkRelievoPanoramaCamera::EQUIRECTANGULAR);
    if (!this->Numbers.empty())
    {
      panorama->SetFieldOfView(this->Numbers[0], this->Numbers[1]);
    }
    return panorama;
  }
  if (this->Kind == "orthographic")
  {
    auto* map = vtkRelievoOrthographicCamera::New();
    map->SetPixelsPerUnit(!this->Numbers.empty()
        ? this->Numbers[0]
        : 0.5 * rows / (isParallel ? halfHeight : halfHeight * view->GetDistance()));
    map->SetPrincipalPoint(0.5 * (columns - 1), 0.5 * (rows - 1));
    return map;
  }
  auto* lens = vtkRelievoLensCamera::New();
  lens->SetLens(
    FindKind(this->Kind)->Lens, static_cast<int>(this->Numbers.size()), this->Numbers.data());
  if (!this->Intrinsics.empty())
  {
    const double* k = this->Intrinsics.data();
    const double x = this->FileSize[0] ? double(columns) / this->FileSize[0] : 1.0;
    const double y = this->FileSize[1] ? double(rows) / this->FileSize[1] : 1.0;
    lens->SetIntrinsics(
      k[0] * x, k[1] * y, k[2] * x, (k[3] + 0.5) * x - 0.5, (k[4] + 0.5) * y - 0.5);
    return lens;
  }
  // Where the upper and the lower edge would be, were the focal length 1.
  const double angle = this->Angle > 0.0 ? this->Angle : this->ViewAngle;
  const double half =
    angle > 0.0 ? vtkMath::RadiansFromDegrees(0.5 * angle) : std::atan(halfHeight);
  lens->SetIntrinsics(1.0, 1.0, 0.0, 0.0, 0.0);
  const double edges[2][3] = { { 0.0, -std::sin(half), std::cos(half) },
    { 0.0, std::sin(half), std::cos(half) } };
  double places[2][2];
  const bool isSeen = lens->ProjectCameraPoint(edges[0], places[0]) &&
    lens->ProjectCameraPoint(edges[1], places[1]) && places[1][1] > places[0][1];
  if (!isSeen)
  {
    lens->Delete();
    std::ostringstream text;
    text << "the lens '" << this->Words << "' sees no " << vtkMath::DegreesFromRadians(2.0 * half)
         << " degrees, expected a smaller angle, or K=FX/FY/CX/CY";
    this->Fail(text.str());
    return nullptr;
  }
  const double focal = rows / (places[1][1] - places[0][1]);
  lens->SetIntrinsics(focal, focal, 0.0, 0.5 * (columns - 1), 0.5 * (rows - 1));
  return lens;
}

//------------------------------------------------------------------------------
vtkRelievoCameraModel* vtkRelievoCalibration::MakeCamera(vtkCamera* view, int columns, int rows)
{
  this->FailureText.clear();
  const std::string size = std::to_string(columns) + "x" + std::to_string(rows);
  if (!view || columns < 1 || rows < 1)
  {
    this->Fail("MakeCamera was given " + std::string(view ? "" : "no view and ") + size +
      " pixels, expected a vtkCamera, and 1x1 or more");
    return nullptr;
  }
  if (IsFile(this->Words) && this->FileSize[0] == 0 && !this->Read())
  {
    return nullptr;
  }
  if (this->Kind == "cube" && columns != CubeFaces * rows)
  {
    this->Fail("a cube's six faces lie side by side: got a picture of " + size +
      ", expected one six times as wide as high, such as " + std::to_string(CubeFaces * rows) +
      "x" + std::to_string(rows));
    return nullptr;
  }
  // The same shape: rounded from it.
  const double wide = double(columns) * this->FileSize[1];
  const double high = double(rows) * this->FileSize[0];
  if (std::abs(wide - high) > 0.5 * std::max(this->FileSize[0], this->FileSize[1]))
  {
    this->Fail(this->Words + ": it is for pictures of " + std::to_string(this->FileSize[0]) + "x" +
      std::to_string(this->FileSize[1]) + ", got a picture of " + size +
      ", expected one of that shape");
    return nullptr;
  }
  vtkRelievoCameraModel* made = this->MakeLens(view, columns, rows);
  if (!made)
  {
    return nullptr;
  }
  made->SetSize(columns, rows);
  made->LookAt(view->GetPosition(), view->GetFocalPoint(), view->GetViewUp());
  if (this->Camera)
  {
    this->Camera->Delete();
  }
  this->Camera = made;
  return made;
}

//------------------------------------------------------------------------------
void vtkRelievoCalibration::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Words: " << this->Words << "\n";
  os << indent << "FileSize: " << this->FileSize[0] << " x " << this->FileSize[1] << "\n";
  os << indent << "ViewAngle: " << this->ViewAngle << "\n";
}
