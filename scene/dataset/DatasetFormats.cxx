// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DatasetFormats.h"

#include "DatasetFiles.h"
#include "DatasetObjects.h"
#include "DatasetView.h"
#include "Errors.h"
#include "Lens.h"

#include "vtkFieldData.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRelievoCameraModel.h"
#include "vtkRelievoEXRWriter.h"
#include "vtkRelievoLensCamera.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace scene
{
const std::vector<std::string> DatasetFormatNames = { "bop", "coco", "nerf", "npz" };

namespace
{
using Json = nlohmann::ordered_json;

// The steps of a depth; 0: none, beyond the last, or behind the plane of the camera.
unsigned short GetSteps(double depth, double step)
{
  const double steps = std::round(depth / step);
  return std::isfinite(depth) && depth > 0.0 && steps <= MostDepthSteps
    ? static_cast<unsigned short>(std::max(1.0, steps))
    : 0;
}

// The pose of an object in a camera: a rotation, and a translation in world units.
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
// Floats as they were drawn, by names.
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
  WriteWhole(style.Folder + "/layers/" + name + ".exr", [&image](const std::string& file) {
    vtkNew<vtkRelievoEXRWriter> writer;
    writer->SetInputData(image);
    writer->SetFileName(file.c_str());
    writer->Write();
    return writer->GetErrorCode() == 0;
  });
}

//------------------------------------------------------------------------------
void WritePictures(const DatasetStyle& style, const DatasetView& view, const std::string& folder,
  const std::string& name)
{
  const auto write = [&](const std::string& path, const std::string& bytes) {
    WriteWhole(style.Folder + "/" + path + "/" + name + ".png", bytes);
  };
  if (!view.Picture.empty())
  {
    write(folder, EncodePNG(view.Picture, view.Columns, view.Rows, 3));
  }
  write("depth", EncodePNG(GetDepthSteps(view, style.DepthStep), view.Columns, view.Rows));
  WriteLayers(style, view, name);
}

//------------------------------------------------------------------------------
void WriteMasks(const DatasetStyle& style, const DatasetView& view, const std::string& name)
{
  constexpr unsigned char white = 255;
  for (std::size_t i = 0; i < view.Visible.size(); ++i)
  {
    const std::string file = "/" + name + "_" + WriteDatasetNumber(i) + ".png";
    for (const bool whole : { false, true })
    {
      const DatasetMask& mask = whole ? view.Whole[i] : view.Visible[i];
      WriteWhole(style.Folder + (whole ? "/mask" : "/mask_visib") + file,
        EncodePNG(mask.GetBytes(white), view.Columns, view.Rows, 1));
    }
  }
}

//------------------------------------------------------------------------------
// Doubles that come from floats or integers are these again.
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

void AddLayer(NumpyArchive& archive, const DatasetView& view, const std::string& name)
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
// All that there is of the view as arrays.
void WriteArrays(const DatasetStyle& style, const DatasetView& view, const DatasetObjects& objects,
  const Json& record, const std::string& name)
{
  const auto rows = static_cast<std::size_t>(view.Rows);
  const auto columns = static_cast<std::size_t>(view.Columns);
  const std::size_t count = view.Visible.size();
  NumpyArchive archive;
  if (!view.Picture.empty())
  {
    archive.Add("color", "|u1", { rows, columns, 3 }, view.Picture.data(), view.Picture.size());
  }
  AddLayer(archive, view, "depth");
  for (const std::string& layer : style.Layers)
  {
    if (layer != "depth")
    {
      AddLayer(archive, view, layer);
    }
  }
  std::vector<std::int32_t> ids(view.Objects.begin(), view.Objects.end());
  std::transform(ids.begin(), ids.end(), ids.begin(), [](int object) { return object + 1; });
  archive.Add("object", "<i4", { rows, columns }, ids.data(), ids.size() * sizeof(ids[0]));
  for (const bool whole : { false, true })
  {
    std::vector<unsigned char> masks;
    std::vector<std::int32_t> boxes;
    for (const DatasetMask& mask : whole ? view.Whole : view.Visible)
    {
      const std::vector<unsigned char> bytes = mask.GetBytes(1);
      masks.insert(masks.end(), bytes.begin(), bytes.end());
      const std::array<int, 4> box = mask.GetBox();
      boxes.insert(boxes.end(), box.begin(), box.end());
    }
    const std::string kind = whole ? "amodal" : "visible";
    archive.Add(kind + "_masks", "|b1", { count, rows, columns }, masks.data(), masks.size());
    archive.Add(
      kind + "_boxes", "<i4", { count, 4 }, boxes.data(), boxes.size() * sizeof(boxes[0]));
  }
  std::vector<double> matrices;
  for (const DatasetObject& object : objects.Get())
  {
    const double* matrix = object.Pose->GetData();
    matrices.insert(matrices.end(), matrix, matrix + 16);
  }
  const auto add = [&archive](const std::string& array, const std::vector<std::size_t>& shape,
                     const std::vector<double>& values) {
    archive.Add(array, "<f8", shape, values.data(), values.size() * sizeof(double));
  };
  add("object_to_world", { count, 4, 4 }, matrices);
  for (const auto& [array, value] : record["camera"].items())
  {
    if (value.is_string())
    {
      std::vector<std::int32_t> letters; // ASCII
      for (const char letter : value.get<std::string>())
      {
        letters.push_back(letter);
      }
      archive.Add(array, "<U" + std::to_string(letters.size()), {}, letters.data(),
        letters.size() * sizeof(letters[0]));
    }
    else if (array != "size") // which all arrays have
    {
      const auto values = value.get<std::vector<double>>();
      const bool isMatrix = array == "K" || array == "R";
      add(
        array, isMatrix ? std::vector<std::size_t>{ 3, 3 } : std::vector{ values.size() }, values);
    }
  }
  const std::string path = style.Folder + "/" + name + ".npz";
  WriteWhole(path, archive.Finish(path));
}

//------------------------------------------------------------------------------
void WriteJson(const std::string& path, const Json& json)
{
  WriteWhole(path, WriteDatasetJson(json));
}

std::vector<double> Scaled(const Json& values, double scale)
{
  std::vector<double> numbers = values.get<std::vector<double>>();
  for (double& number : numbers)
  {
    number *= scale;
  }
  return numbers;
}

//------------------------------------------------------------------------------
void WriteBOP(const DatasetStyle& style, const std::vector<Json>& records)
{
  const double scale = style.MillimetersPerUnit;
  Json cameras = Json::object();
  Json poses = Json::object();
  Json infos = Json::object();
  for (const Json& record : records)
  {
    const std::string key = std::to_string(record["view"].get<int>());
    const Json& camera = record["camera"];
    cameras[key] = { { "cam_K", camera["K"] }, { "depth_scale", style.DepthStep * scale },
      { "cam_R_w2c", camera["R"] }, { "cam_t_w2c", Scaled(camera["t"], scale) } };
    for (const char* name : { "lens", "distortion" })
    {
      if (camera.contains(name))
      {
        cameras[key][name] = camera[name];
      }
    }
    poses[key] = Json::array();
    infos[key] = Json::array();
    for (const Json& object : record["objects"])
    {
      poses[key].push_back({ { "cam_R_m2c", object["R"] },
        { "cam_t_m2c", Scaled(object["t"], scale) }, { "obj_id", object["object"] } });
      const double whole = object["silhouette_pixels"];
      const double seen = object["visible_pixels"];
      infos[key].push_back({ { "bbox_obj", object["silhouette_box"] },
        { "bbox_visib", object["visible_box"] }, { "px_count_all", object["silhouette_pixels"] },
        { "px_count_valid", object["valid_pixels"] },
        { "px_count_visib", object["visible_pixels"] },
        { "visib_fract", whole > 0.0 ? seen / whole : 0.0 } });
    }
  }
  WriteJson(style.Folder + "/scene_gt.json", poses);
  WriteJson(style.Folder + "/scene_gt_info.json", infos);
  WriteJson(style.Folder + "/scene_camera.json", cameras);
}

//------------------------------------------------------------------------------
void WriteCOCO(const DatasetStyle& style, const std::vector<std::string>& objects,
  const std::vector<Json>& records)
{
  Json images = Json::array();
  Json annotations = Json::array();
  Json categories = Json::array();
  for (std::size_t i = 0; i < objects.size(); ++i)
  {
    categories.push_back(
      { { "id", i + 1 }, { "name", objects[i] }, { "supercategory", "object" } });
  }
  for (const Json& record : records)
  {
    const int columns = record["camera"]["size"][0];
    const int rows = record["camera"]["size"][1];
    const int view = record["view"];
    images.push_back({ { "id", view }, { "width", columns }, { "height", rows },
      { "file_name", "images/" + WriteDatasetNumber(static_cast<std::size_t>(view)) + ".png" } });
    for (const Json& object : record["objects"])
    {
      if (object["visible_pixels"] == 0)
      {
        continue;
      }
      const auto runs = [&](const char* name) -> Json {
        return { { "size", { rows, columns } }, { "counts", object[name] } };
      };
      annotations.push_back({ { "id", annotations.size() + 1 }, { "image_id", view },
        { "category_id", object["object"] }, { "segmentation", runs("visible_runs") },
        { "area", object["visible_pixels"] }, { "bbox", object["visible_box"] }, { "iscrowd", 0 },
        { "amodal_segmentation", runs("amodal_runs") }, { "amodal_area", object["amodal_pixels"] },
        { "amodal_bbox", object["amodal_box"] } });
    }
  }
  WriteJson(style.Folder + "/instances.json",
    { { "info", { { "description", "made by Relievo" }, { "depth_step", style.DepthStep } } },
      { "images", images }, { "annotations", annotations }, { "categories", categories } });
}

// Whether a camera's record, by DescribeDatasetCamera, is that of a fisheye lens.
bool IsFisheye(const Json& camera)
{
  return camera.contains("lens") && camera["lens"] == "fisheye";
}

// What transforms.json says of a camera: (0, 0) is the corner of the first pixel.
Json DescribeIntrinsics(const Json& camera)
{
  const Json& k = camera["K"];
  Json all = { { "w", camera["size"][0] }, { "h", camera["size"][1] }, { "fl_x", k[0] },
    { "fl_y", k[4] }, { "cx", k[2].get<double>() + 0.5 }, { "cy", k[5].get<double>() + 0.5 } };
  const std::vector<const char*> names = IsFisheye(camera)
    ? std::vector<const char*>{ "k1", "k2", "k3", "k4" }
    : std::vector<const char*>{ "k1", "k2", "p1", "p2", "k3" }; // OpenCV's orders
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    all[names[i]] = camera.contains("distortion") ? camera["distortion"][i] : Json(0.0);
  }
  return all;
}

void WriteNeRF(const DatasetStyle& style, const std::vector<Json>& records)
{
  const bool isFisheye = !records.empty() && IsFisheye(records[0]["camera"]); // then all are
  Json all = { { "camera_model", isFisheye ? "OPENCV_FISHEYE" : "OPENCV" },
    { "is_fisheye", isFisheye }, { "depth_unit_scale_factor", style.DepthStep } };
  const bool alike = std::all_of(records.begin(), records.end(), [&](const Json& record) {
    return DescribeIntrinsics(record["camera"]) == DescribeIntrinsics(records[0]["camera"]);
  });
  if (alike && !records.empty())
  {
    all.update(DescribeIntrinsics(records[0]["camera"]));
  }
  all["frames"] = Json::array();
  for (const Json& record : records)
  {
    const Json& camera = record["camera"];
    const auto r = camera["R"].get<std::vector<double>>();
    const auto t = camera["t"].get<std::vector<double>>();
    Json matrix = Json::array();
    for (std::size_t i = 0; i < 3; ++i)
    {
      // Columns: right, up, backwards, and where the camera is.
      const double place = -(r[i] * t[0] + r[3 + i] * t[1] + r[6 + i] * t[2]);
      matrix.push_back({ r[i], -r[3 + i], -r[6 + i], place });
    }
    matrix.push_back({ 0.0, 0.0, 0.0, 1.0 });
    const std::string name = WriteDatasetNumber(record["view"].get<std::size_t>());
    Json frame = { { "file_path", "images/" + name + ".png" },
      { "depth_file_path", "depth/" + name + ".png" }, { "transform_matrix", matrix } };
    if (!alike)
    {
      frame.update(DescribeIntrinsics(camera));
    }
    all["frames"].push_back(frame);
  }
  WriteJson(style.Folder + "/transforms.json", all);
}
}

//------------------------------------------------------------------------------
std::string WriteDatasetNumber(std::size_t number)
{
  constexpr std::size_t digits = 6;
  const std::string text = std::to_string(number);
  return std::string(text.size() < digits ? digits - text.size() : 0, '0') + text;
}

//------------------------------------------------------------------------------
std::string WriteDatasetJson(const Json& json)
{
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

//------------------------------------------------------------------------------
bool IsDatasetRecord(DatasetFormat format, const Json& record, std::size_t objects)
{
  const auto has = [](const Json& json, const char* name, std::size_t count) {
    const auto found = json.find(name);
    return found != json.end() && found->is_array() && found->size() == count &&
      std::all_of(found->begin(), found->end(), [](const Json& each) { return each.is_number(); });
  };
  const auto hasNumber = [](const Json& json, const char* name) {
    return json.contains(name) && json[name].is_number();
  };
  const auto hasText = [](const Json& json, const char* name) {
    return json.contains(name) && json[name].is_string();
  };
  if (!record.is_object() || !hasNumber(record, "view") || !record.contains("camera") ||
    !record.contains("objects") || !record["objects"].is_array() ||
    record["objects"].size() != objects)
  {
    return false;
  }
  const Json& camera = record["camera"];
  const bool needsK = format == DatasetFormat::BOP || format == DatasetFormat::NeRF;
  if (!has(camera, "size", 2) || !has(camera, "R", 9) || !has(camera, "t", 3) ||
    (needsK && !has(camera, "K", 9)))
  {
    return false;
  }
  return std::all_of(record["objects"].begin(), record["objects"].end(), [&](const Json& object) {
    const bool isBOP = format == DatasetFormat::BOP;
    const bool isCOCO = format == DatasetFormat::COCO;
    return hasNumber(object, "object") && has(object, "R", 9) && has(object, "t", 3) &&
      hasNumber(object, "visible_pixels") && hasNumber(object, "amodal_pixels") &&
      hasNumber(object, "valid_pixels") && has(object, "visible_box", 4) &&
      has(object, "amodal_box", 4) &&
      (!isBOP || (hasNumber(object, "silhouette_pixels") && has(object, "silhouette_box", 4))) &&
      (!isCOCO || (hasText(object, "visible_runs") && hasText(object, "amodal_runs")));
  });
}

//------------------------------------------------------------------------------
void CheckDatasetCamera(DatasetFormat format, vtkRelievoCameraModel* camera,
  vtkRelievoCameraModel* first, const std::string& view)
{
  auto* lens = vtkRelievoLensCamera::SafeDownCast(camera);
  const std::string got = view + ": got the sensor " +
    DescribeDatasetCamera(camera).value("lens", std::string(camera->GetClassName()));
  if (format != DatasetFormat::Numpy && !HasDatasetPicture(camera))
  {
    throw UsageError(got + ", which has no picture; expected the format npz");
  }
  if ((format == DatasetFormat::BOP || format == DatasetFormat::NeRF) && !lens)
  {
    throw UsageError(got + ", which has no K; expected the format coco or npz");
  }
  if (format != DatasetFormat::NeRF)
  {
    return;
  }
  const auto refuse = [&view](const std::string& what) {
    throw UsageError(view + ": " + what +
      ", which transforms.json cannot say; expected another format, or another camera");
  };
  if (lens->GetSkew() != 0.0)
  {
    refuse("K has a skew");
  }
  if (lens->GetLens() == vtkRelievoLensCamera::DIVISION)
  {
    refuse("the lens is one by division");
  }
  constexpr int last = 5; // k1 k2 p1 p2 k3
  for (int i = last; i < vtkRelievoLensCamera::MOST_COEFFICIENTS; ++i)
  {
    if (lens->GetCoefficient(i) != 0.0)
    {
      refuse("the lens has k" + std::to_string(i - 1));
    }
  }
  if (IsFisheye(DescribeDatasetCamera(camera)) != IsFisheye(DescribeDatasetCamera(first)))
  {
    throw UsageError(view +
      ": transforms.json has one kind of lens for all views, and view 0 has another; expected "
      "fisheyes alone, or none");
  }
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
    if (style.Format == DatasetFormat::COCO)
    {
      object["visible_runs"] = view.Visible[i].GetRuns();
      object["amodal_runs"] = view.Whole[i].GetRuns();
    }
    record["objects"].push_back(object);
  }
  const std::string name = WriteDatasetNumber(number);
  switch (style.Format)
  {
    case DatasetFormat::BOP:
      WritePictures(style, view, "rgb", name);
      WriteMasks(style, view, name);
      break;
    case DatasetFormat::COCO:
    case DatasetFormat::NeRF:
      WritePictures(style, view, "images", name);
      break;
    case DatasetFormat::Numpy:
      WriteArrays(style, view, objects, record, name);
      return 0;
  }
  int components = 0;
  const std::vector<double> depth = view.GetLayer("depth", components);
  return static_cast<std::size_t>(std::count_if(depth.begin(), depth.end(),
    [&](double value) { return std::isfinite(value) && GetSteps(value, style.DepthStep) == 0; }));
}

//------------------------------------------------------------------------------
void WriteDatasetIndex(const DatasetStyle& style, const std::vector<std::string>& objects,
  const std::vector<Json>& records)
{
  switch (style.Format)
  {
    case DatasetFormat::BOP:
      return WriteBOP(style, records);
    case DatasetFormat::COCO:
      return WriteCOCO(style, objects, records);
    case DatasetFormat::NeRF:
      return WriteNeRF(style, records);
    case DatasetFormat::Numpy:
      break; // each archive says all
  }
}
}
