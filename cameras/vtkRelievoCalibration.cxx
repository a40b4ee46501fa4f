// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoCalibration.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRelievoCalibrationFile.h"
#include "vtkRelievoSensorList.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

vtkStandardNewMacro(vtkRelievoCalibration);

namespace
{
using Numbers = std::vector<double>;

using SensorKind = vtkRelievoSensorWords;

const std::vector<SensorKind>& GetKinds()
{
  static const std::vector<SensorKind> kinds = [] {
    std::vector<SensorKind> all;
    for (const auto& words : { RELIEVO_SENSOR_WORDS })
    {
      all.insert(all.end(), words.begin(), words.end());
    }
    return all;
  }();
  return kinds;
}

const SensorKind* FindKind(const std::string& name)
{
  const auto found = std::find_if(GetKinds().begin(), GetKinds().end(),
    [&name](const SensorKind& kind) { return name == kind.Name; });
  return found == GetKinds().end() ? nullptr : &*found;
}

// Parsed words.
struct Parsed
{
  std::string Kind;
  Numbers Values;
  Numbers Intrinsics;
  double Angle = 0.0;
  std::string Error; // error message, or empty
};

Parsed Parse(const std::string& words)
{
  Parsed parsed;
  const std::size_t colon = words.find_first_of(":,");
  parsed.Kind = words.substr(0, colon);
  const SensorKind* kind = FindKind(parsed.Kind);
  const std::string got = "got '" + words + "', expected ";
  if (!kind)
  {
    parsed.Error = got + vtkRelievoCalibration::GetForms(true) + ", " +
      vtkRelievoCalibration::GetForms(false) + ", or a file .yml, .yaml, .json, .xml or .txt";
    return parsed;
  }
  std::string form = kind->Form;
  if (kind->Lens >= 0)
  {
    form += ", optionally followed by ,K=FX/FY/CX/CY or ,angle=DEG";
  }
  form += kind->Range;
  bool good = true;
  const std::vector<std::string> parts = colon == std::string::npos
    ? std::vector<std::string>()
    : vtkRelievoCalibrationFile::Split(words.substr(colon + 1), ',');
  for (const std::string& part : parts)
  {
    const bool isMatrix = part.rfind("K=", 0) == 0;
    const bool isAngle = part.rfind("angle=", 0) == 0;
    const std::vector<std::string> each = vtkRelievoCalibrationFile::Split(
      part.substr(isMatrix || isAngle ? part.find('=') + 1 : 0), '/');
    Numbers numbers;
    for (const std::string& word : each)
    {
      const std::optional<double> number = vtkRelievoCalibrationFile::ToNumber(word);
      good = good && number;
      numbers.push_back(number.value_or(0.0));
    }
    // Only one option is allowed, after the coefficients.
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
  // Coefficients follow a colon; after a comma there are none.
  good = good && (colon == std::string::npos || words[colon] == ':' || count == 0) &&
    (colon == std::string::npos || !parts.empty()) &&
    std::count(kind->Counts.begin(), kind->Counts.end(), count) != 0;
  if (good && !parsed.Intrinsics.empty())
  {
    good = parsed.Intrinsics[0] > 0.0 && parsed.Intrinsics[1] > 0.0;
    parsed.Intrinsics.insert(parsed.Intrinsics.begin() + 2, 0.0); // no skew
  }
  if (good && count > 0 && kind->IsGood)
  {
    good = kind->IsGood(parsed.Values);
  }
  parsed.Error = good ? "" : got + form;
  return parsed;
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
bool vtkRelievoCalibration::IsFile(RELIEVO_TEXT words)
{
  static const std::vector<std::string> extensions = { ".yml", ".yaml", ".json", ".xml", ".txt",
    ".yml.gz", ".yaml.gz", ".json.gz", ".xml.gz" };
  return !FindKind(words.substr(0, words.find(':'))) &&
    std::find(extensions.begin(), extensions.end(),
      vtkRelievoCalibrationFile::GetExtension(words)) != extensions.end();
}

//------------------------------------------------------------------------------
std::string vtkRelievoCalibration::GetForms(bool ofLenses)
{
  std::string forms;
  for (const SensorKind& kind : GetKinds())
  {
    forms += (kind.Lens >= 0) != ofLenses ? "" : (forms.empty() ? "" : ", ") + kind.Form;
  }
  return forms;
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkRelievoCalibration::GetNames()
{
  std::vector<std::string> names;
  for (const SensorKind& kind : GetKinds())
  {
    const bool alone = std::count(kind.Counts.begin(), kind.Counts.end(), 0) != 0;
    names.push_back(kind.Name + (alone ? "" : ":"));
  }
  return names;
}

//------------------------------------------------------------------------------
std::string vtkRelievoCalibration::Check(RELIEVO_TEXT words)
{
  return IsFile(words) ? "" : Parse(words).Error;
}

//------------------------------------------------------------------------------
bool vtkRelievoCalibration::SetWords(RELIEVO_TEXT words)
{
  this->FailureText.clear();
  const bool isFile = IsFile(words);
  const Parsed parsed = isFile ? Parsed() : Parse(words);
  if (!parsed.Error.empty())
  {
    return this->Fail(parsed.Error);
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
  const vtkRelievoCalibrationFile found = vtkRelievoCalibrationFile::Read(this->Words);
  if (!found.Error.empty())
  {
    return this->Fail(this->Words + ": " + found.Error);
  }
  this->Kind = found.Kind;
  this->Numbers = found.Values;
  this->Intrinsics = found.Intrinsics;
  std::copy_n(found.Size, 2, this->FileSize);
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
// Replaces the lens of an earlier call.
vtkRelievoCameraModel* vtkRelievoCalibration::MakeLens(vtkCamera* view, int columns, int rows)
{
  vtkMatrix4x4* projection = view->GetProjectionTransformMatrix(double(columns) / rows, -1.0, 1.0);
  // At distance 1, or anywhere in parallel projection.
  const double halfHeight = 1.0 / projection->GetElement(1, 1);
  const SensorKind& kind = *FindKind(this->Kind);
  if (kind.Make)
  {
    const bool isParallel = view->GetParallelProjection() != 0;
    return kind.Make(
      this->Numbers, { columns, rows, isParallel ? halfHeight : halfHeight * view->GetDistance() });
  }
  auto* lens = vtkRelievoLensCamera::New();
  lens->SetLens(kind.Lens, static_cast<int>(this->Numbers.size()), this->Numbers.data());
  if (!this->Intrinsics.empty())
  {
    const double* k = this->Intrinsics.data();
    const double x = this->FileSize[0] ? double(columns) / this->FileSize[0] : 1.0;
    const double y = this->FileSize[1] ? double(rows) / this->FileSize[1] : 1.0;
    lens->SetIntrinsics(
      k[0] * x, k[1] * y, k[2] * x, (k[3] + 0.5) * x - 0.5, (k[4] + 0.5) * y - 0.5);
    return lens;
  }
  // Positions of the upper and the lower edge for a focal length of 1.
  const double angle = this->Angle > 0.0 ? this->Angle : this->ViewAngle;
  const double half =
    angle > 0.0 ? vtkMath::RadiansFromDegrees(0.5 * angle) : std::atan(halfHeight);
  lens->SetIntrinsics(1.0, 1.0, 0.0, 0.0, 0.0);
  const double edges[2][3] = { { 0.0, -std::sin(half), std::cos(half) },
    { 0.0, std::sin(half), std::cos(half) } };
  double places[2][2];
  // The picture of a pinhole with 180 degrees is infinitely high; with 179.9 degrees it has this
  // height.
  constexpr double highest = 2291.8;
  const bool isSeen = lens->ProjectCameraPoint(edges[0], places[0]) &&
    lens->ProjectCameraPoint(edges[1], places[1]) && places[1][1] > places[0][1] &&
    places[1][1] - places[0][1] < highest;
  if (!isSeen)
  {
    lens->Delete();
    std::ostringstream text;
    text << "the lens '" << this->Words << "' cannot span "
         << vtkMath::DegreesFromRadians(2.0 * half)
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
  const SensorKind& kind = *FindKind(this->Kind);
  const std::string sizeError = kind.CheckSize ? kind.CheckSize(columns, rows) : "";
  if (!sizeError.empty())
  {
    this->Fail(sizeError);
    return nullptr;
  }
  // Equal shape, up to rounding.
  const double wide = double(columns) * this->FileSize[1];
  const double high = double(rows) * this->FileSize[0];
  if (std::abs(wide - high) > 0.5 * std::max(this->FileSize[0], this->FileSize[1]))
  {
    this->Fail(this->Words + ": the calibration is for pictures of " +
      std::to_string(this->FileSize[0]) + "x" + std::to_string(this->FileSize[1]) +
      ", got a picture of " + size + ", expected one of the same shape");
    return nullptr;
  }
  const double* const position = view->GetPosition();
  const std::string error =
    vtkRelievoCameraModel::CheckView(position, view->GetFocalPoint(), view->GetViewUp());
  if (!error.empty())
  {
    this->Fail(error);
    return nullptr;
  }
  vtkRelievoCameraModel* made = this->MakeLens(view, columns, rows);
  if (!made)
  {
    return nullptr;
  }
  made->SetSize(columns, rows);
  made->LookAt(position, view->GetFocalPoint(), view->GetViewUp());
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
