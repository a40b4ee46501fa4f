// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoComparedFrame.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkRelievoCauseList.h"
#include "vtkRelievoFormulas.h"
#include "vtkRelievoLayerCatalogue.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <set>

namespace relievo::compare
{
namespace
{
using Json = nlohmann::json;

// Copies and comparisons of JSON recurse; a damaged file may nest it until the stack overflows.
constexpr int MostDepth = 16;

constexpr float OfStorage = 1e-3f; // levels

// Further components of a layer are ignored.
constexpr int MostComponents = 9;

// Without a record, the largest id gives the number of objects, and so the memory to allocate; a
// damaged file may contain any id.
constexpr int MostActors = 1000000;

template <typename T>
std::vector<T> GetValues(vtkDataArray* array)
{
  const int components = std::min(array->GetNumberOfComponents(), MostComponents);
  const vtkIdType tuples = array->GetNumberOfTuples();
  std::vector<T> values(static_cast<std::size_t>(tuples) * static_cast<std::size_t>(components));
  std::size_t at = 0;
  for (vtkIdType i = 0; i < tuples; ++i)
  {
    for (int c = 0; c < components; ++c)
    {
      values[at++] = static_cast<T>(array->GetComponent(i, c));
    }
  }
  return values;
}

template <>
std::vector<int> GetValues<int>(vtkDataArray* array)
{
  if (array->GetDataType() == VTK_INT)
  {
    const auto* from = static_cast<const int*>(array->GetVoidPointer(0));
    return std::vector<int>(from, from + array->GetNumberOfValues());
  }
  std::vector<int> values;
  for (const double value : GetValues<double>(array))
  {
    // Files of other programs store ids as floats; NaN and values outside int count as no id.
    const bool isId = value >= -1.0 && value <= std::numeric_limits<int>::max();
    values.push_back(isId ? static_cast<int>(value) : -1);
  }
  return values;
}

template <>
std::vector<float> GetValues<float>(vtkDataArray* array)
{
  const int components = array->GetNumberOfComponents();
  const auto count = static_cast<std::size_t>(array->GetNumberOfValues());
  if (array->GetDataType() == VTK_FLOAT && components <= MostComponents)
  {
    const auto* from = static_cast<const float*>(array->GetVoidPointer(0));
    return std::vector<float>(from, from + count);
  }
  if (array->GetDataType() == VTK_UNSIGNED_CHAR && components <= MostComponents)
  {
    const auto* from = static_cast<const unsigned char*>(array->GetVoidPointer(0));
    return std::vector<float>(from, from + count);
  }
  std::vector<float> values;
  for (const double value : GetValues<double>(array))
  {
    values.push_back(static_cast<float>(value));
  }
  return values;
}

Layer MakeLayer(vtkDataArray* array)
{
  Layer layer;
  layer.Components = std::min(array->GetNumberOfComponents(), MostComponents);
  layer.Values = GetValues<float>(array);
  layer.IsBytes = array->GetDataType() == VTK_UNSIGNED_CHAR;
  return layer;
}

std::vector<std::string> GetStrings(vtkImageData* image, const char* name)
{
  std::vector<std::string> strings;
  auto* array = vtkStringArray::SafeDownCast(image->GetFieldData()->GetAbstractArray(name));
  for (vtkIdType i = 0; array && i < array->GetNumberOfValues(); ++i)
  {
    strings.push_back(array->GetValue(i));
  }
  return strings;
}

bool GetNumbers(vtkImageData* image, const char* name, double* numbers, vtkIdType count)
{
  vtkDataArray* array = image->GetFieldData()->GetArray(name);
  if (!array || array->GetNumberOfValues() != count)
  {
    return false;
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    const int components = array->GetNumberOfComponents();
    numbers[i] = array->GetComponent(i / components, static_cast<int>(i % components));
  }
  return true;
}

template <std::size_t N>
bool TakeNumbers(const Json& json, const char* name, std::array<double, N>& numbers)
{
  const auto found = json.find(name);
  if (found == json.end() || !found->is_array() || found->size() != N ||
    !std::all_of(found->begin(), found->end(), [](const Json& each) { return each.is_number(); }))
  {
    return false;
  }
  std::transform(found->begin(), found->end(), numbers.begin(),
    [](const Json& each) { return each.get<double>(); });
  return true;
}

std::string TakeText(const Json& json, const char* name)
{
  const auto found = json.find(name);
  return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

bool TakeFlag(const Json& json, const char* name, bool otherwise)
{
  const auto found = json.find(name);
  return found != json.end() && found->is_boolean() ? found->get<bool>() : otherwise;
}

// Null if the text is no JSON.
Json Parse(const std::string& text)
{
  bool isDeep = false;
  Json json = Json::parse(
    text,
    [&isDeep](int depth, Json::parse_event_t, Json&) {
      isDeep = isDeep || depth > MostDepth;
      return !isDeep;
    },
    false);
  if (isDeep || json.is_discarded())
  {
    json = nullptr;
  }
  return json;
}

bool TakeObject(const std::string& text, Object& object)
{
  const Json json = Parse(text);
  if (!json.is_object() || !TakeNumbers(json, "matrix", object.Matrix) ||
    !TakeNumbers(json, "center", object.Center) || !TakeNumbers(json, "bounds", object.Bounds))
  {
    return false;
  }
  TakeNumbers(json, "spread", object.Spread);
  object.Name = TakeText(json, "name");
  object.Points = TakeText(json, "points");
  object.Cells = TakeText(json, "cells");
  object.Glyphs = TakeText(json, "glyphs");
  object.Visible = TakeFlag(json, "visible", true);
  object.Translucent = TakeFlag(json, "translucent", false);
  object.HasNormalMap = TakeFlag(json, "normal_map", false);
  object.NormalMap = TakeText(json, "normal_map_sum");
  object.Settings = json.value("settings", Json::object());
  object.Color = json.value("color", Json());
  object.Clipping = json.value("clipping", Json());
  object.Blocks = json.value("blocks", Json());
  return true;
}

const std::set<std::string> StageLayers = { "light", "fog", "ambient", "marker", "blend" };

// Layers that are not compared: they repeat others, or describe the method instead of the scene.
const std::set<std::string> PassedOver = { "range", "geometric_normal", "light_depth",
  "lamp_evaluations", "lamps_reaching", "volume_position", "volume_value", "volume_normal" };
}

//------------------------------------------------------------------------------
std::vector<std::string> ListChanges(const Json& from, const Json& to)
{
  std::vector<std::string> names;
  for (const auto& [name, value] : from.items())
  {
    const auto found = to.find(name);
    if (found != to.end() && *found != value)
    {
      names.push_back(name);
    }
  }
  return names;
}

//------------------------------------------------------------------------------
std::string Frame::Read(vtkImageData* image)
{
  const int* size = image->GetDimensions();
  this->Size = { size[0], size[1] };
  if (size[0] < 1 || size[1] < 1 || size[2] != 1)
  {
    return "has " + std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " +
      std::to_string(size[2]) + " points, expected columns, rows and one slice";
  }
  this->Pixels = static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]);
  vtkPointData* arrays = image->GetPointData();
  vtkDataArray* range = nullptr;
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = arrays->GetArray(i);
    const std::string name = array && array->GetName() ? array->GetName() : "";
    if (!array || static_cast<std::size_t>(array->GetNumberOfTuples()) != this->Pixels)
    {
      continue;
    }
    const int components = array->GetNumberOfComponents();
    if (name == vtkRelievoLayerCatalogue::GetPicture().Name)
    {
      this->Picture = MakeLayer(array);
      this->IsLinear = !this->Picture.IsBytes;
    }
    else if ((name == "actor" || name == "block" || name == "cell") && components == 1)
    {
      (name == "actor"     ? this->Actor
          : name == "cell" ? this->Cell
                           : this->Block) = GetValues<int>(array);
    }
    else if (name == "depth" && components == 1)
    {
      this->Depth = GetValues<float>(array);
    }
    else if (name == "position" && components == 3)
    {
      this->Position = GetValues<double>(array);
    }
    else if (vtkRelievoLayerCatalogue::GetIsOfLight(name) && components == 1)
    {
      this->Shadow[name] = GetValues<float>(array);
    }
    else if (name == "volume" && components == 1)
    {
      this->VolumeId = GetValues<int>(array);
    }
    else if ((name == "volume_depth" || name == "volume_opacity") && components == 1)
    {
      (name == "volume_depth" ? this->VolumeDepth : this->VolumeOpacity) = GetValues<float>(array);
    }
    else if (StageLayers.count(name) != 0)
    {
      this->Stages[name] = MakeLayer(array);
    }
    else if (PassedOver.count(name) == 0 && !name.empty())
    {
      this->Surface[name] = MakeLayer(array);
    }
    range = name == "range" && components == 1 ? array : range;
  }
  if (this->Depth.empty() && range && this->Position.empty())
  {
    this->Depth = GetValues<float>(range);
  }
  // In images of other programs, such as PNG, the scalars are the picture.
  vtkDataArray* scalars = arrays->GetScalars();
  const bool isPlain = this->Picture.Components == 0 && this->Actor.empty() &&
    this->Depth.empty() && this->Position.empty();
  if (isPlain && scalars &&
    static_cast<std::size_t>(scalars->GetNumberOfTuples()) == this->Pixels &&
    scalars->GetNumberOfComponents() <= 4)
  {
    this->Picture = MakeLayer(scalars);
    this->IsLinear = !this->Picture.IsBytes && scalars->GetDataType() != VTK_UNSIGNED_SHORT;
    if (scalars->GetDataType() == VTK_UNSIGNED_SHORT)
    {
      for (float& value : this->Picture.Values)
      {
        value /= 257.f;
      }
    }
    this->Surface.clear();
  }
  if (this->Picture.Components == 0 && this->Actor.empty() && this->Depth.empty() &&
    this->Position.empty() && this->Surface.empty())
  {
    return "has no layers to compare";
  }
  return this->ReadRecord(image);
}

//------------------------------------------------------------------------------
std::string Frame::ReadRecord(vtkImageData* image)
{
  this->HasCamera = GetNumbers(image, "worldToCamera", this->WorldToCamera.data(), 16) &&
    GetNumbers(image, "worldToNDC", this->WorldToNDC.data(), 16);
  GetNumbers(image, "near", &this->Near, 1);
  GetNumbers(image, "far", &this->Far, 1);
  if (this->HasCamera)
  {
    this->HasCamera = vtkMatrix4x4::Determinant(this->WorldToCamera.data()) != 0.0;
    vtkMatrix4x4::Invert(this->WorldToCamera.data(), this->CameraToWorld.data());
    vtkMatrix4x4::Multiply4x4(
      this->WorldToNDC.data(), this->CameraToWorld.data(), this->CameraToNDC.data());
  }
  this->ReadLights(image);
  double version = 0.0;
  if (!GetNumbers(image, "baseline_version", &version, 1))
  {
    const auto most = std::max_element(this->Actor.begin(), this->Actor.end());
    if (most != this->Actor.end() && *most >= MostActors)
    {
      return "shows actor " + std::to_string(*most) + ", expected at most " +
        std::to_string(MostActors - 1) + " without a record; write it with write_baseline()";
    }
    return {};
  }
  if (version > RecordVersion)
  {
    return "has the baseline format " + WriteShort(version) + ", expected at most " +
      std::to_string(RecordVersion) + "; use a newer Relievo";
  }
  if (!(version >= 1.0)) // also refuses NaN
  {
    return "has the baseline format " + WriteShort(version) +
      ", expected at least 1; write the baseline again";
  }
  this->HasRecord = true;
  this->HasVolumes = version >= 2.0;
  double portable = 0.0;
  this->IsPortable = GetNumbers(image, "portable", &portable, 1) && portable == 1.0;
  for (const std::string& text : GetStrings(image, "objects"))
  {
    Object object;
    if (!TakeObject(text, object))
    {
      return "has a record of object " + std::to_string(this->Objects.size()) +
        " that cannot be read; write the baseline again";
    }
    if (version < 3.0)
    {
      object.Glyphs.clear(); // there without the arrays that place them
    }
    this->Objects.push_back(object);
  }
  for (const int actor : this->Actor)
  {
    if (actor >= static_cast<int>(this->Objects.size()))
    {
      return "shows actor " + std::to_string(actor) + ", but its record has " +
        std::to_string(this->Objects.size()) + " objects; write the baseline again";
    }
  }
  for (const std::string& text : GetStrings(image, "volumes"))
  {
    Volume volume;
    const Json json = Parse(text);
    if (json.is_object())
    {
      TakeNumbers(json, "bounds", volume.Bounds);
      volume.Values = json;
      volume.Values.erase("bounds");
      if (version < 3.0)
      {
        volume.Values.erase("data"); // there also a sum of the points, so not comparable
      }
    }
    this->Volumes.push_back(volume);
  }
  for (const std::string& text : GetStrings(image, "overlays"))
  {
    this->Overlays.push_back(Parse(text));
  }
  for (const std::string& text : GetStrings(image, "settings"))
  {
    const std::size_t equals = text.find('=');
    this->Settings[text.substr(0, equals)] =
      equals == std::string::npos ? std::string() : text.substr(equals + 1);
  }
  this->Versions = GetStrings(image, "versions");
  return {};
}

//------------------------------------------------------------------------------
void Frame::ReadLights(vtkImageData* image)
{
  this->HasLights = this->HasCamera; // files without lights have no such attribute
  for (const std::string& text : GetStrings(image, "lights"))
  {
    Json json = Parse(text);
    if (!json.is_object())
    {
      continue;
    }
    Light light;
    light.Name = TakeText(json, "name");
    light.Layer = TakeText(json, "layer");
    if (this->Shadow.count(light.Layer) == 0)
    {
      light.Layer =
        vtkRelievoLayerCatalogue::GetOfLight().Name + std::to_string(this->Lights.size());
    }
    json.erase("name");
    json.erase("layer");
    light.Values = json;
    this->Lights.push_back(light);
  }
}

//------------------------------------------------------------------------------
int Frame::GetSamples() const
{
  const auto found = this->Settings.find(SamplesSetting);
  return found == this->Settings.end() ? -1 : std::atoi(found->second.c_str());
}

//------------------------------------------------------------------------------
bool Frame::SeesAs(const Frame& other) const
{
  for (std::size_t i = 0; i < 16; ++i)
  {
    // Skips the row for the depth buffer, which depends on the clipping distances; they also affect
    // the rounding of the other rows.
    const double most = 1e-13 * std::max(1.0, std::abs(this->WorldToNDC[i]));
    const bool isEqual = i / 4 == 2 || std::abs(this->WorldToNDC[i] - other.WorldToNDC[i]) <= most;
    if (!isEqual || this->WorldToCamera[i] != other.WorldToCamera[i])
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
float Frame::Level(std::size_t pixel, int c) const
{
  const int components = this->Picture.Components;
  const bool isGray = components < 3;
  const bool isAlpha = c == 3;
  const int place = !isGray ? c : isAlpha ? 1 : 0;
  const float value =
    this->Picture
      .Values[pixel * static_cast<std::size_t>(components) + static_cast<std::size_t>(place)];
  if (!this->IsLinear || std::isnan(value))
  {
    return value;
  }
  const float level =
    255.f * (isAlpha ? value : relievo::f32::relievoSrgbFromLinear(std::max(0.f, value)));
  // Pictures of 8 bits are stored as linear floats, which rounds: 2 levels must not become 2.00002.
  const float whole = std::round(level);
  return std::abs(level - whole) < OfStorage ? whole : level;
}

//------------------------------------------------------------------------------
// The point at this depth on the ray through (x, y), in pixels, from two linear equations.
std::array<double, 3> Frame::Unproject(double x, double y, double depth) const
{
  const std::array<double, 16>& m = this->CameraToNDC;
  const double ndc[2] = { 2.0 * x / this->Size[0] - 1.0, 2.0 * y / this->Size[1] - 1.0 };
  double a[2][3];
  for (std::size_t r = 0; r < 2; ++r)
  {
    const std::size_t row = 4 * r;
    const double z = -depth;
    a[r][0] = m[row] - ndc[r] * m[12];
    a[r][1] = m[row + 1] - ndc[r] * m[13];
    a[r][2] = ndc[r] * (m[14] * z + m[15]) - (m[row + 2] * z + m[row + 3]);
  }
  const double determinant = a[0][0] * a[1][1] - a[0][1] * a[1][0];
  const double eye[3] = { (a[0][2] * a[1][1] - a[0][1] * a[1][2]) / determinant,
    (a[0][0] * a[1][2] - a[0][2] * a[1][0]) / determinant, -depth };
  const std::array<double, 16>& w = this->CameraToWorld;
  std::array<double, 3> world{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    world[i] = w[4 * i] * eye[0] + w[4 * i + 1] * eye[1] + w[4 * i + 2] * eye[2] + w[4 * i + 3];
  }
  return world;
}

//------------------------------------------------------------------------------
std::array<double, 3> Frame::GetPosition(std::size_t pixel) const
{
  if (!this->Position.empty())
  {
    return { this->Position[3 * pixel], this->Position[3 * pixel + 1],
      this->Position[3 * pixel + 2] };
  }
  const auto width = static_cast<std::size_t>(this->Size[0]);
  return this->Unproject(static_cast<double>(pixel % width) + 0.5,
    static_cast<double>(pixel / width) + 0.5, this->Depth[pixel]);
}

//------------------------------------------------------------------------------
bool Frame::Project(const double point[3], double place[2]) const
{
  double seen[4];
  for (std::size_t i = 0; i < 4; ++i)
  {
    seen[i] = this->WorldToNDC[4 * i] * point[0] + this->WorldToNDC[4 * i + 1] * point[1] +
      this->WorldToNDC[4 * i + 2] * point[2] + this->WorldToNDC[4 * i + 3];
  }
  for (std::size_t i = 0; i < 2; ++i)
  {
    place[i] = 0.5 * (seen[i] / seen[3] + 1.0) * this->Size[i];
  }
  return this->HasCamera && seen[3] > 0.0;
}

//------------------------------------------------------------------------------
double Frame::GetDepth(std::size_t pixel) const
{
  if (!this->Depth.empty())
  {
    return this->Depth[pixel];
  }
  if (!this->HasDepths())
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  if (!this->Actor.empty() && this->Actor[pixel] < 0)
  {
    return std::numeric_limits<double>::infinity();
  }
  const std::array<double, 3> p = this->GetPosition(pixel);
  return -(this->WorldToCamera[8] * p[0] + this->WorldToCamera[9] * p[1] +
    this->WorldToCamera[10] * p[2] + this->WorldToCamera[11]);
}

//------------------------------------------------------------------------------
double Frame::GetFootprintAt(double depth) const
{
  if (!this->HasCamera || !std::isfinite(depth))
  {
    return 0.0;
  }
  const std::array<double, 3> a = this->Unproject(0.5 * this->Size[0], 0.5 * this->Size[1], depth);
  const std::array<double, 3> b =
    this->Unproject(0.5 * this->Size[0], 0.5 * this->Size[1] + 1.0, depth);
  return std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
}
}
