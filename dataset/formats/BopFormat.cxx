// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DatasetFiles.h"
#include "DatasetFormats.h"
#include "DatasetModels.h"
#include "DatasetView.h"

namespace dataset
{
namespace
{
using Json = nlohmann::ordered_json;

std::vector<double> Scaled(const Json& values, double scale)
{
  std::vector<double> numbers = values.get<std::vector<double>>();
  for (double& number : numbers)
  {
    number *= scale;
  }
  return numbers;
}

// A scene of the Benchmark for 6D Object Pose Estimation; lengths are in millimetres.
class BopFormat : public DatasetFormat
{
public:
  BopFormat()
    : DatasetFormat("bop")
  {
    this->NeedsK = true;
    this->NeedsSilhouettes = true;
  }

  bool IsObject(const Json& object) const override
  {
    return object.contains("silhouette_pixels") && object["silhouette_pixels"].is_number() &&
      IsNumbers(object, "silhouette_box", 4);
  }

  void WriteView(const DatasetStyle& style, const DatasetView& view, const DatasetObjects&,
    const Json&, const std::string& name) const override
  {
    WriteDatasetPictures(style, view, "rgb", name);
    constexpr unsigned char white = 255;
    for (std::size_t i = 0; i < view.Visible.size(); ++i)
    {
      const std::string file = "/" + name + "_" + WriteDatasetNumber(i) + ".png";
      for (const bool whole : { false, true })
      {
        const DatasetMask& mask = whole ? view.Whole[i] : view.Visible[i];
        style.Write((whole ? "mask" : "mask_visib") + file,
          EncodeMask(mask.GetBytes(white), view.Columns, view.Rows));
      }
    }
  }

  std::vector<std::pair<std::string, std::string>> MakeIndex(const DatasetStyle& style,
    const std::vector<std::string>&, const std::vector<Json>& records) const override
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
    return { { "scene_gt.json", WriteDatasetJson(poses) },
      { "scene_gt_info.json", WriteDatasetJson(infos) },
      { "scene_camera.json", WriteDatasetJson(cameras) } };
  }

  void WriteModels(
    const DatasetStyle& style, vtkRenderer* renderer, const DatasetObjects& objects) const override
  {
    WriteDatasetModels(style, renderer, objects);
  }
};
}

//------------------------------------------------------------------------------
std::unique_ptr<DatasetFormat> MakeBopFormat()
{
  return std::make_unique<BopFormat>();
}
}
