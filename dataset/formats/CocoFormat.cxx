// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DatasetFiles.h"
#include "DatasetFormats.h"
#include "DatasetView.h"

namespace dataset
{
namespace
{
using Json = nlohmann::ordered_json;

// Instances as run-length masks.
class CocoFormat : public DatasetFormat
{
public:
  CocoFormat()
    : DatasetFormat("coco")
  {
  }

  bool IsObject(const Json& object) const override
  {
    const auto hasText = [&object](const char* name) {
      return object.contains(name) && object[name].is_string();
    };
    return hasText("visible_runs") && hasText("amodal_runs");
  }

  void DescribeObject(const DatasetView& view, std::size_t i, Json& object) const override
  {
    object["visible_runs"] = view.Visible[i].GetRuns();
    object["amodal_runs"] = view.Whole[i].GetRuns();
  }

  void WriteView(const DatasetStyle& style, const DatasetView& view, const DatasetObjects&,
    const Json&, const std::string& name) const override
  {
    WriteDatasetPictures(style, view, "images", name);
  }

  std::vector<std::pair<std::string, std::string>> MakeIndex(const DatasetStyle& style,
    const std::vector<std::string>& objects, const std::vector<Json>& records) const override
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
          { "amodal_segmentation", runs("amodal_runs") },
          { "amodal_area", object["amodal_pixels"] }, { "amodal_bbox", object["amodal_box"] } });
      }
    }
    const Json all = {
      { "info", { { "description", "made by Relievo" }, { "depth_step", style.DepthStep } } },
      { "images", images }, { "annotations", annotations }, { "categories", categories }
    };
    return { { "instances.json", WriteDatasetJson(all) } };
  }
};
}

//------------------------------------------------------------------------------
std::unique_ptr<DatasetFormat> MakeCocoFormat()
{
  return std::make_unique<CocoFormat>();
}
}
