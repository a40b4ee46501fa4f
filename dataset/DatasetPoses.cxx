// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DatasetPoses.h"

#include "DatasetFiles.h"
#include "Errors.h"
#include "Messages.h"
#include "Sun.h"
#include "Values.h"

#include "vtkMath.h"
#include "vtkRelievoCalibrationFile.h"
#include "vtkRelievoLensCamera.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>

namespace dataset
{
namespace
{
using Json = nlohmann::ordered_json;
using Cameras = std::vector<vtkSmartPointer<vtkRelievoCameraModel>>;

constexpr int MostViews = 10000000;
constexpr double MostPixels = 1 << 20;             // in each direction
constexpr std::uint64_t Step = 0x9e3779b97f4a7c15; // increment of the random generator
constexpr double PoseMargin = 1.05; // margin around the objects that a pose must show

std::uint64_t Mix(std::uint64_t state)
{
  std::uint64_t bits = state + Step;
  bits = (bits ^ bits >> 30) * 0xbf58476d1ce4e5b9;
  bits = (bits ^ bits >> 27) * 0x94d049bb133111eb;
  return bits ^ bits >> 31;
}

vtkSmartPointer<vtkRelievoCameraModel> CopyOf(vtkRelievoCameraModel* camera)
{
  auto copy = vtkSmartPointer<vtkRelievoCameraModel>::Take(camera->NewInstance());
  copy->Copy(camera);
  return copy;
}

//------------------------------------------------------------------------------
// The distance from which a sphere of radius 1 fits the picture, by the boundary ray nearest to the
// axis. Panoramas and parallel projections stand at twice the radius.
double GetFittingDistance(vtkRelievoCameraModel* camera)
{
  const double right = camera->GetSize()[0] - 0.5;
  const double bottom = camera->GetSize()[1] - 0.5;
  const double places[4][2] = { { -0.5, bottom / 2.0 }, { right, bottom / 2.0 },
    { right / 2.0, -0.5 }, { right / 2.0, bottom } };
  double sine = 1.0;
  for (const auto& place : places)
  {
    double origin[3];
    double direction[3];
    const bool seen = camera->GetCameraRay(place[0], place[1], origin, direction);
    const double across = std::hypot(direction[0], direction[1]);
    if (!seen || !(direction[2] > 0.0) || !(across > 0.0))
    {
      return 2.0;
    }
    sine = std::min(sine, across);
  }
  return PoseMargin / sine;
}

//------------------------------------------------------------------------------
bool IsStanding(const std::string& words)
{
  return words.rfind("orbit:", 0) == 0 || words.rfind("random:", 0) == 0;
}

// Named numbers after a word, each with its default and range.
struct Named
{
  const char* Name;
  double Value, Low, High;
};

void Take(
  const std::string& option, const std::vector<std::string>& parts, std::vector<Named>& numbers)
{
  std::string all;
  for (const Named& number : numbers)
  {
    all += std::string(all.empty() ? "" : ", ") + number.Name;
  }
  for (const auto& [name, value] :
    ParseNamedWords(option, parts, "NAME=VALUE with a NAME of " + all))
  {
    const auto found = std::find_if(numbers.begin(), numbers.end(),
      [&name = name](const Named& number) { return name == number.Name; });
    if (found == numbers.end())
    {
      RefuseValue(option, name, "one of " + all);
    }
    found->Value = ParseNumberFrom(option + ", " + name, value, found->Low, found->High);
  }
}

//------------------------------------------------------------------------------
// Words that place cameras around an object.
struct Standing
{
  bool Orbit;
  int Count;
  std::vector<Named> Numbers;
};

Standing ParseStanding(const std::string& option, const std::string& word)
{
  const double infinity = std::numeric_limits<double>::infinity();
  const std::size_t colon = word.find(':');
  const bool orbit = word.compare(0, colon, "orbit") == 0;
  std::vector<std::string> parts = Split(word.substr(colon + 1), ',');
  const int count =
    ParseWhole(option + " " + word + ", number of views", parts.front(), 1, MostViews);
  parts.erase(parts.begin());
  // Distances are multiples of the one from which everything is visible.
  std::vector<Named> numbers = { { "elevation", 30.0, -90.0, 90.0 },
    { "distance", 1.0, 1e-6, infinity } };
  if (!orbit)
  {
    numbers = { { "lowest", 0.0, -90.0, 90.0 }, { "highest", 90.0, -90.0, 90.0 },
      { "nearest", 1.0, 1e-6, infinity }, { "farthest", 1.5, 1e-6, infinity } };
  }
  Take(option + " " + word, parts, numbers);
  if (!orbit)
  {
    for (const std::size_t low : { 0, 2 })
    {
      if (numbers[low].Value > numbers[low + 1].Value)
      {
        throw UsageError(option + " " + word + ": " + numbers[low].Name + " is above " +
          numbers[low + 1].Name + ", expected it to be at most this");
      }
    }
  }
  return { orbit, count, numbers };
}

Cameras StandAround(const std::string& option, const std::string& word, vtkRelievoCameraModel* like,
  const DatasetSurroundings& around)
{
  const auto [orbit, count, numbers] = ParseStanding(option, word);
  if (!around.Box.IsValid())
  {
    throw UsageError(option + " " + word +
      ": the scene is empty, so that cameras have nothing to surround; give poses, or show "
      "something");
  }
  double center[3];
  around.Box.GetCenter(center);
  const double radius = around.Box.GetDiagonalLength() / 2.0;
  const double fitting = (radius > 0.0 ? radius : 1.0) * GetFittingDistance(like);
  const double sines[2] = { std::sin(vtkMath::RadiansFromDegrees(numbers[0].Value)),
    std::sin(vtkMath::RadiansFromDegrees(numbers[1].Value)) };
  Cameras cameras;
  for (int i = 0; i < count; ++i)
  {
    double azimuth = 180.0 + 360.0 * i / count; // from the front
    double elevation = numbers[0].Value;
    double distance = numbers[1].Value;
    if (!orbit)
    {
      DatasetRandom random(around.Seed, 0, i);
      azimuth = random.Next(0.0, 360.0);
      // Uniform on the sphere.
      elevation = vtkMath::DegreesFromRadians(std::asin(random.Next(sines[0], sines[1])));
      distance = random.Next(numbers[2].Value, numbers[3].Value);
    }
    const std::array<double, 3> direction = GetSunDirection({ azimuth, elevation }, around.UpAxis);
    double position[3];
    double up[3] = {};
    if (std::abs(elevation) > 89.9)
    {
      // Seen from straight above, `up` points away from the camera's place on the circle.
      const std::array<double, 3> outwards = GetSunDirection({ azimuth, 0.0 }, around.UpAxis);
      std::transform(outwards.begin(), outwards.end(), up,
        [elevation](double along) { return elevation > 0.0 ? -along : along; });
    }
    else
    {
      up[around.UpAxis] = 1.0;
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      position[axis] = center[axis] + fitting * distance * direction[axis];
    }
    cameras.push_back(CopyOf(like));
    cameras.back()->LookAt(position, center, up);
  }
  return cameras;
}

//------------------------------------------------------------------------------
// Flattens numbers in nested lists. `where` names the place in the file.
std::vector<double> TakeNumbers(const Json& values, std::size_t count, const std::string& where)
{
  std::vector<double> numbers;
  const std::function<void(const Json&)> add = [&](const Json& value) {
    if (value.is_array())
    {
      std::for_each(value.begin(), value.end(), add);
    }
    else if (value.is_number())
    {
      numbers.push_back(value.get<double>());
    }
    else
    {
      numbers.resize(count + 1);
    }
  };
  add(values);
  if (numbers.size() != count)
  {
    throw UsageError(where + ": expected " + std::to_string(count) + " numbers");
  }
  return numbers;
}

void SetIntrinsics(
  vtkRelievoCameraModel* camera, const std::vector<double>& k, const std::string& where)
{
  if (!vtkRelievoCalibrationFile::IsMatrix(k))
  {
    throw UsageError(where +
      ": expected 9 numbers, row by row: fx, skew, cx, 0, fy, cy, 0, 0, 1, fx and fy above 0");
  }
  auto* lens = vtkRelievoLensCamera::SafeDownCast(camera);
  if (!lens)
  {
    throw UsageError(where + ": belongs to a camera, and this sensor has none of it");
  }
  lens->SetIntrinsics(k[0], k[4], k[1], k[2], k[5]);
}

// Keeps square pixels, the vertical view angle, and the axis's relative place in the picture.
void SetSize(
  vtkRelievoCameraModel* camera, const std::vector<double>& size, const std::string& where)
{
  for (const double pixels : size)
  {
    if (!(pixels >= 1.0 && pixels <= MostPixels && pixels == std::floor(pixels)))
    {
      throw UsageError(where + ": expected whole numbers of pixels from 1 to " +
        std::to_string(static_cast<int>(MostPixels)));
    }
  }
  const double x = size[0] / camera->GetSize()[0];
  const double y = size[1] / camera->GetSize()[1];
  camera->SetSize(static_cast<int>(size[0]), static_cast<int>(size[1]));
  if (auto* lens = vtkRelievoLensCamera::SafeDownCast(camera))
  {
    const double* axis = lens->GetPrincipalPoint();
    lens->SetIntrinsics(lens->GetFocalX() * y, lens->GetFocalY() * y, lens->GetSkew() * y,
      (axis[0] + 0.5) * x - 0.5, (axis[1] + 0.5) * y - 0.5);
  }
}

//------------------------------------------------------------------------------
// The lens of transforms.json: k1, k2, p1, p2, k3 (Brown and Conrady) with k4 to k6 for
// FULL_OPENCV, or k1 to k4 of a fisheye. Without coefficients, the camera's lens stays; throws
// UsageError if both lenses distort, and for other lenses.
void SetLens(
  vtkRelievoCameraModel* camera, const Json& frame, const Json& all, const std::string& where)
{
  static const std::vector<std::string> models = { "PINHOLE", "SIMPLE_PINHOLE", "PERSPECTIVE",
    "OPENCV", "FULL_OPENCV", "RADIAL", "SIMPLE_RADIAL", "OPENCV_FISHEYE" };
  const auto get = [&](const char* name, const Json& otherwise) {
    return frame.contains(name) ? frame[name] : all.contains(name) ? all[name] : otherwise;
  };
  const Json model = get("camera_model", models[0]);
  if (!model.is_string() ||
    std::find(models.begin(), models.end(), model.get<std::string>()) == models.end())
  {
    throw UsageError(
      where + ", camera_model: got " + model.dump() + ", expected one of " + Join(models, ", "));
  }
  const Json says = get("is_fisheye", false);
  if (!says.is_boolean())
  {
    throw UsageError(where + ", is_fisheye: got " + says.dump() + ", expected true or false");
  }
  const bool isFisheye = model == models.back() || says.get<bool>();
  std::vector<std::string> own = { "k1", "k2", "k3", "k4" };
  if (!isFisheye)
  {
    own = { "k1", "k2", "p1", "p2", "k3" };
  }
  if (!isFisheye && model == "FULL_OPENCV")
  {
    own.insert(own.end(), { "k4", "k5", "k6" });
  }
  std::vector<double> coefficients(own.size());
  for (const char* name : { "k1", "k2", "k3", "k4", "k5", "k6", "p1", "p2" })
  {
    const double value = TakeNumbers(get(name, 0.0), 1, where + ", " + name)[0];
    const auto place = std::find(own.begin(), own.end(), name);
    if (place != own.end())
    {
      coefficients[static_cast<std::size_t>(place - own.begin())] = value;
    }
    else if (value != 0.0)
    {
      throw UsageError(where + ", " + name + ": got " + Json(value).dump() +
        ", expected 0: the lens has " + Join(own, ", "));
    }
  }
  const bool bends = isFisheye ||
    std::any_of(coefficients.begin(), coefficients.end(), [](double value) { return value != 0; });
  auto* lens = vtkRelievoLensCamera::SafeDownCast(camera);
  if (bends && (!lens || lens->GetLens() != vtkRelievoLensCamera::PINHOLE))
  {
    throw UsageError(where + ": has a lens, and the given camera has another; expected only one");
  }
  if (bends)
  {
    lens->SetLens(isFisheye ? vtkRelievoLensCamera::FISHEYE : vtkRelievoLensCamera::BROWN_CONRADY,
      static_cast<int>(coefficients.size()), coefficients.data());
  }
}

//------------------------------------------------------------------------------
// The OpenGL camera-to-world matrices of transforms.json, and its K, which places (0, 0) at the
// corner of the first pixel, not at its centre.
void SetFromFrame(
  vtkRelievoCameraModel* camera, const Json& frame, const Json& all, const std::string& where)
{
  const auto get = [&](const char* name) {
    const Json& from = frame.contains(name) ? frame : all;
    return from.contains(name) ? TakeNumbers(from[name], 1, where + ", " + name)[0]
                               : std::numeric_limits<double>::quiet_NaN();
  };
  SetLens(camera, frame, all, where);
  if (std::isnan(get("w")) != std::isnan(get("h")))
  {
    throw UsageError(where + ": expected both w and h");
  }
  if (!std::isnan(get("w")))
  {
    SetSize(camera, { get("w"), get("h") }, where + ", w and h");
  }
  const int* size = camera->GetSize();
  // Focal length in pixels, or from the angle between the edges.
  const auto getFocal = [&](const char* name, const char* ofAngle, int pixels) {
    const double angle = get(ofAngle);
    if (angle <= 0.0 || angle >= vtkMath::Pi())
    {
      throw UsageError(where + ", " + ofAngle + ": expected radians between 0 and pi");
    }
    return std::isnan(get(name)) ? pixels / 2.0 / std::tan(angle / 2.0) : get(name);
  };
  const double focals[2] = { getFocal("fl_x", "camera_angle_x", size[0]),
    getFocal("fl_y", "camera_angle_y", size[1]) };
  const double fx = std::isnan(focals[0]) ? focals[1] : focals[0];
  if (!std::isnan(fx))
  {
    const double fy = std::isnan(focals[1]) ? fx : focals[1];
    const double cx = std::isnan(get("cx")) ? size[0] / 2.0 : get("cx");
    const double cy = std::isnan(get("cy")) ? size[1] / 2.0 : get("cy");
    SetIntrinsics(camera, { fx, 0.0, cx - 0.5, 0.0, fy, cy - 0.5, 0.0, 0.0, 1.0 }, where + ", K");
  }
  else if (!std::isnan(get("cx")) || !std::isnan(get("cy")))
  {
    throw UsageError(where + ", cx and cy: expected fl_x or camera_angle_x as well");
  }
  const std::vector<double> m =
    TakeNumbers(frame["transform_matrix"], 16, where + ", transform_matrix");
  double rotation[9];
  double translation[3];
  for (std::size_t i = 0; i < 3; ++i)
  {
    const double sign = i == 0 ? 1.0 : -1.0; // y up and z backwards become y down and z forward
    translation[i] = 0.0;
    for (std::size_t j = 0; j < 3; ++j)
    {
      rotation[3 * i + j] = sign * m[4 * j + i];
      translation[i] -= rotation[3 * i + j] * m[4 * j + 3];
    }
  }
  camera->SetExtrinsics(rotation, translation);
}

//------------------------------------------------------------------------------
void SetFromPose(
  vtkRelievoCameraModel* camera, const Json& pose, int upAxis, const std::string& where)
{
  const auto take = [&](const char* name, std::size_t count) {
    return TakeNumbers(pose[name], count, where + ", " + name);
  };
  if (pose.contains("size"))
  {
    SetSize(camera, take("size", 2), where + ", size");
  }
  if (pose.contains("K"))
  {
    SetIntrinsics(camera, take("K", 9), where + ", K");
  }
  if (pose.contains("R") && pose.contains("t"))
  {
    camera->SetExtrinsics(take("R", 9).data(), take("t", 3).data());
    return;
  }
  if (!pose.contains("position") || !pose.contains("target"))
  {
    throw UsageError(where + ": expected R and t, or position and target");
  }
  std::vector<double> up(3);
  up[static_cast<std::size_t>(upAxis)] = 1.0;
  if (pose.contains("up"))
  {
    up = take("up", 3);
  }
  const std::vector<double> position = take("position", 3);
  const std::vector<double> target = take("target", 3);
  const std::string message =
    vtkRelievoCameraModel::CheckView(position.data(), target.data(), up.data());
  if (!message.empty())
  {
    throw UsageError(where + ": " + message);
  }
  camera->LookAt(position.data(), target.data(), up.data());
}

//------------------------------------------------------------------------------
Cameras ReadPoses(
  const std::string& option, const std::string& path, vtkRelievoCameraModel* like, int upAxis)
{
  const Json all = Json::parse(ReadWhole(path), nullptr, false);
  const bool frames = all.is_object() && all.contains("frames");
  const Json& list = frames ? all["frames"] : all;
  if (!list.is_array() || list.empty())
  {
    throw FileError(path + ": " + (all.is_discarded() ? "is no JSON" : "has no poses") +
      ", expected a list of poses with R and t, or frames with a transform_matrix");
  }
  Cameras cameras;
  for (std::size_t i = 0; i < list.size(); ++i)
  {
    const std::string where = option + " " + path + ": pose " + std::to_string(i);
    cameras.push_back(CopyOf(like));
    if (!list[i].is_object() || (frames && !list[i].contains("transform_matrix")))
    {
      throw UsageError(where + ": expected " + (frames ? "a transform_matrix" : "R and t"));
    }
    frames ? SetFromFrame(cameras.back(), list[i], all, where)
           : SetFromPose(cameras.back(), list[i], upAxis, where);
    try
    {
      Messages::Check(where);
    }
    catch (const WorkError& error)
    {
      throw UsageError(error.what());
    }
  }
  return cameras;
}
}

//------------------------------------------------------------------------------
DatasetRandom::DatasetRandom(int seed, int purpose, int view)
  : State(0)
{
  for (const int part : { seed, purpose, view })
  {
    this->State = Mix(this->State + static_cast<std::uint64_t>(static_cast<std::int64_t>(part)));
  }
}

//------------------------------------------------------------------------------
double DatasetRandom::Next(double low, double high)
{
  const double share = static_cast<double>(Mix(this->State) >> 11) * 0x1p-53;
  this->State += Step;
  return low + (high - low) * share;
}

//------------------------------------------------------------------------------
void CheckDatasetPoses(const std::string& option, const std::string& words)
{
  const std::filesystem::path path(words);
  std::error_code trouble;
  if (IsStanding(words))
  {
    ParseStanding(option, words);
  }
  else if (path.extension() != ".json" && !std::filesystem::exists(path, trouble))
  {
    RefuseValue(option, words, "orbit:N, random:N or a FILE.json");
  }
}

//------------------------------------------------------------------------------
Cameras MakeDatasetPoses(const std::string& option, const std::string& words,
  vtkRelievoCameraModel* like, const DatasetSurroundings& around)
{
  CheckDatasetPoses(option, words);
  return IsStanding(words) ? StandAround(option, words, like, around)
                           : ReadPoses(option, words, like, around.UpAxis);
}

//------------------------------------------------------------------------------
std::array<double, 3> MakeDatasetSun(int seed, int view, int upAxis)
{
  constexpr double lowest = 15.0;
  constexpr double highest = 75.0;
  DatasetRandom random(seed, 1, view);
  const double azimuth = random.Next(0.0, 360.0);
  return GetSunDirection({ azimuth, random.Next(lowest, highest) }, upAxis);
}
}
