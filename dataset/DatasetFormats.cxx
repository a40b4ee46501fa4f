// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DatasetFormats.h"

#include "DatasetFiles.h"
#include "DatasetObjects.h"
#include "DatasetView.h"
#include "Errors.h"
#include "FileHash.h"
#include "Lens.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRelievoCameraModel.h"
#include "vtkRelievoEXRWriter.h"
#include "vtkRelievoLensCamera.h"
#include "vtkRelievoOption.h"

#include <algorithm>
#include <cmath>

namespace dataset
{
namespace
{
using Json = nlohmann::ordered_json;

// Depth in whole steps; 0: no depth, beyond the last step, or behind the camera's plane.
unsigned short GetSteps(double depth, double step)
{
  const double steps = std::round(depth / step);
  return std::isfinite(depth) && depth > 0.0 && steps <= MostDepthSteps
    ? static_cast<unsigned short>(std::max(1.0, steps))
    : 0;
}

// An object's pose in the camera's frame: a rotation, and a translation in world units.
Json DescribePose(vtkMatrix4x4* matrix, vtkRelievoCameraModel* camera)
{
  double turned[9];
  double origin[3];
  GetRigidPose(matrix, turned, origin);
  const double* rotation = camera->GetRotation();
  std::vector<double> all(9);
  std::vector<double> place(3);
  for (std::size_t i = 0; i < 3; ++i)
  {
    place[i] = camera->GetTranslation()[i];
    for (std::size_t k = 0; k < 3; ++k)
    {
      place[i] += rotation[3 * i + k] * origin[k];
      for (std::size_t j = 0; j < 3; ++j)
      {
        all[3 * i + j] += rotation[3 * i + k] * turned[3 * k + j];
      }
    }
  }
  return { { "R", all }, { "t", place } };
}

// Stores doubles converted from floats or integers in their original type.
template <typename T>
void AddLayer(
  NumpyArchive& archive, const DatasetView& view, const std::string& name, const std::string& type)
{
  int components = 0;
  const std::vector<double> values = view.GetLayer(name, components);
  std::vector<T> exact(values.size());
  std::transform(values.begin(), values.end(), exact.begin(),
    [](double value) { return static_cast<T>(value); });
  std::vector<std::size_t> shape = { static_cast<std::size_t>(view.Rows),
    static_cast<std::size_t>(view.Columns) };
  if (components > 1)
  {
    shape.push_back(static_cast<std::size_t>(components));
  }
  archive.Add(name, type, shape, exact.data(), exact.size() * sizeof(T));
}

//------------------------------------------------------------------------------
// Layers as floats, by name.
void WriteLayers(const DatasetStyle& style, const DatasetView& view, const std::string& name)
{
  if (style.Layers.empty())
  {
    return;
  }
  vtkNew<vtkImageData> image;
  image->CopyStructure(view.Layers);
  image->SetFieldData(view.Layers->GetFieldData());
  for (const std::string& layer : style.Layers)
  {
    image->GetPointData()->AddArray(view.Layers->GetPointData()->GetArray(layer.c_str()));
  }
  style.Write("layers/" + name + ".exr", [&image](const std::string& file) {
    vtkNew<vtkRelievoEXRWriter> writer;
    writer->SetInputData(image);
    writer->SetFileName(file.c_str());
    writer->Write();
    return writer->GetErrorCode() == 0;
  });
}
}

//------------------------------------------------------------------------------
std::vector<unsigned short> GetDepthSteps(const DatasetView& view, double step)
{
  int components = 0;
  const std::vector<double> depth = view.GetLayer("depth", components);
  std::vector<unsigned short> steps(depth.size());
  std::transform(depth.begin(), depth.end(), steps.begin(),
    [step](double value) { return GetSteps(value, step); });
  return steps;
}

//------------------------------------------------------------------------------
void AddDatasetLayer(NumpyArchive& archive, const DatasetView& view, const std::string& name)
{
  switch (view.Layers->GetPointData()->GetArray(name.c_str())->GetDataType())
  {
    case VTK_FLOAT:
      return AddLayer<float>(archive, view, name, "<f4");
    case VTK_DOUBLE:
      return AddLayer<double>(archive, view, name, "<f8");
    default:
      return AddLayer<std::int64_t>(archive, view, name, "<i8");
  }
}

//------------------------------------------------------------------------------
bool DatasetStyle::IsValidation(std::size_t view) const
{
  // The margin is for shares such as 0.29, whose multiples are rounded below whole numbers.
  const auto count = [this](std::size_t views) {
    constexpr double margin = 1e-9;
    return std::floor(static_cast<double>(views) * this->Validation + margin);
  };
  return count(view + 1) > count(view);
}

//------------------------------------------------------------------------------
void DatasetStyle::SetCategories(const std::vector<std::string>& ofObjects)
{
  this->Categories.clear();
  this->CategoryOf.clear();
  std::map<std::string, std::size_t> places;
  for (const std::string& category : ofObjects)
  {
    const auto [found, isNew] = places.emplace(category, this->Categories.size());
    if (isNew)
    {
      this->Categories.push_back(category);
    }
    this->CategoryOf.push_back(found->second);
  }
}

//------------------------------------------------------------------------------
void DatasetStyle::Write(const std::string& path, const std::string& bytes) const
{
  WriteWhole(this->Folder + "/" + path, bytes);
  this->Hashes[path] = FileHash::Of(bytes);
}

//------------------------------------------------------------------------------
void DatasetStyle::Write(
  const std::string& path, const std::function<bool(const std::string&)>& write) const
{
  WriteWhole(this->Folder + "/" + path, write);
  this->Hashes[path] = FileHash::OfFile(this->Folder + "/" + path);
}

//------------------------------------------------------------------------------
void WriteDatasetPictures(const DatasetStyle& style, const DatasetView& view,
  const std::string& folder, const std::string& name)
{
  const auto write = [&](const std::string& path, const std::string& bytes) {
    style.Write(path + "/" + name + ".png", bytes);
  };
  if (!view.Picture.empty())
  {
    write(folder, EncodePNG(view.Picture, view.Columns, view.Rows, 3));
  }
  write("depth", EncodePNG(GetDepthSteps(view, style.DepthStep), view.Columns, view.Rows));
  WriteLayers(style, view, name);
}

//------------------------------------------------------------------------------
const std::vector<std::unique_ptr<DatasetFormat>>& GetDatasetFormats()
{
  static const std::vector<std::unique_ptr<DatasetFormat>> formats = [] {
    std::vector<std::unique_ptr<DatasetFormat>> all;
#define RELIEVO_DATASET_FORMAT(name) all.push_back(Make##name##Format());
#include "DatasetFormatList.h"
#undef RELIEVO_DATASET_FORMAT
    return all;
  }();
  return formats;
}

//------------------------------------------------------------------------------
bool IsNumbers(const Json& json, const char* name, std::size_t count)
{
  const auto found = json.find(name);
  return found != json.end() && found->is_array() && found->size() == count &&
    std::all_of(found->begin(), found->end(), [](const Json& each) { return each.is_number(); });
}

//------------------------------------------------------------------------------
bool IsDatasetRecord(const DatasetFormat& format, const Json& record, std::size_t objects)
{
  const auto hasNumber = [](const Json& json, const char* name) {
    return json.contains(name) && json[name].is_number();
  };
  if (!record.is_object() || !hasNumber(record, "view") || !record.contains("camera") ||
    !record.contains("objects") || !record["objects"].is_array() ||
    record["objects"].size() != objects)
  {
    return false;
  }
  const Json& camera = record["camera"];
  if (!IsNumbers(camera, "size", 2) || !IsNumbers(camera, "R", 9) || !IsNumbers(camera, "t", 3) ||
    (format.NeedsK && !IsNumbers(camera, "K", 9)))
  {
    return false;
  }
  std::size_t number = 0;
  return std::all_of(record["objects"].begin(), record["objects"].end(), [&](const Json& object) {
    return hasNumber(object, "object") && object["object"] == ++number &&
      IsNumbers(object, "R", 9) && IsNumbers(object, "t", 3) &&
      hasNumber(object, "visible_pixels") && hasNumber(object, "amodal_pixels") &&
      hasNumber(object, "valid_pixels") && IsNumbers(object, "visible_box", 4) &&
      IsNumbers(object, "amodal_box", 4) && format.IsObject(object);
  });
}

//------------------------------------------------------------------------------
void CheckDatasetCamera(const DatasetFormat& format, vtkRelievoCameraModel* camera,
  vtkRelievoCameraModel* first, const std::string& view)
{
  const auto refuse = [&](const std::string& what, bool DatasetFormat::*needs) {
    std::vector<std::string> others;
    for (const auto& other : GetDatasetFormats())
    {
      if (!((*other).*needs))
      {
        others.push_back(other->Name);
      }
    }
    throw UsageError(view + ": got the sensor " +
      DescribeDatasetCamera(camera).value("lens", std::string(camera->GetClassName())) +
      ", which has no " + what + "; expected the format " + vtkRelievoEither(others));
  };
  if (format.NeedsPicture && !camera->HasPicture())
  {
    refuse("picture", &DatasetFormat::NeedsPicture);
  }
  if (format.NeedsK && !vtkRelievoLensCamera::SafeDownCast(camera))
  {
    refuse("K", &DatasetFormat::NeedsK);
  }
  format.CheckCamera(camera, first, view);
}

//------------------------------------------------------------------------------
Json DescribeDatasetCamera(vtkRelievoCameraModel* camera)
{
  vtkNew<vtkFieldData> fields;
  camera->AddTo(fields);
  return Json::parse(WriteCalibration(fields, { camera->GetSize()[0], camera->GetSize()[1] }));
}

//------------------------------------------------------------------------------
std::size_t WriteDatasetView(const DatasetStyle& style, const DatasetView& view,
  const DatasetObjects& objects, vtkRelievoCameraModel* camera, std::size_t number, Json& record)
{
  const std::vector<unsigned short> steps = GetDepthSteps(view, style.DepthStep);
  record["objects"] = Json::array();
  for (std::size_t i = 0; i < objects.Get().size(); ++i)
  {
    Json object = { { "object", i + 1 }, { "name", objects.Get()[i].Name } };
    object.update(DescribePose(objects.Get()[i].Pose, camera));
    std::size_t valid = 0;
    view.Whole[i].ForEach([&](std::size_t pixel) { valid += steps[pixel] > 0 ? 1 : 0; });
    object["visible_pixels"] = view.Visible[i].GetCount();
    object["amodal_pixels"] = view.Whole[i].GetCount();
    object["valid_pixels"] = valid;
    object["visible_box"] = view.Visible[i].GetBox();
    object["amodal_box"] = view.Whole[i].GetBox();
    if (!view.Silhouettes.empty())
    {
      object["silhouette_pixels"] = view.Silhouettes[i].Count;
      object["silhouette_box"] = view.Silhouettes[i].Box;
    }
    style.Format->DescribeObject(view, i, object);
    record["objects"].push_back(object);
  }
  style.Format->WriteView(style, view, objects, record, WriteDatasetNumber(number));
  if (!style.Format->HasDepthSteps)
  {
    return 0;
  }
  int components = 0;
  const std::vector<double> depth = view.GetLayer("depth", components);
  return static_cast<std::size_t>(std::count_if(depth.begin(), depth.end(),
    [&](double value) { return std::isfinite(value) && GetSteps(value, style.DepthStep) == 0; }));
}
}
