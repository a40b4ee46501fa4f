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

// Boxes of the visible objects, as the detectors of Ultralytics read them.
class YoloFormat : public DatasetFormat
{
public:
  YoloFormat()
    : DatasetFormat("yolo")
  {
    this->HasCategories = true;
    this->HasSplit = true;
  }

  void WriteView(const DatasetStyle& style, const DatasetView& view, const DatasetObjects&,
    const Json& record, const std::string& name) const override
  {
    const std::string split = style.IsValidation(record["view"]) ? "val" : "train";
    WriteDatasetPictures(style, view, "images/" + split, name);
    std::string lines;
    for (std::size_t i = 0; i < view.Visible.size(); ++i)
    {
      if (view.Visible[i].GetCount() == 0)
      {
        continue;
      }
      const std::array<int, 4> box = view.Visible[i].GetBox();
      lines += std::to_string(style.GetCategory(i));
      for (const double share :
        { (box[0] + 0.5 * box[2]) / view.Columns, (box[1] + 0.5 * box[3]) / view.Rows,
          static_cast<double>(box[2]) / view.Columns, static_cast<double>(box[3]) / view.Rows })
      {
        lines += " " + Json(share).dump();
      }
      lines += "\n";
    }
    style.Write("labels/" + split + "/" + name + ".txt", lines);
  }

  std::vector<std::pair<std::string, std::string>> MakeIndex(const DatasetStyle& style,
    const std::vector<std::string>&, const std::vector<Json>&) const override
  {
    // Without `path`, the folders are relative to this file. JSON's texts are texts of YAML.
    std::string lines = "train: images/train\nval: images/";
    lines += style.Validation > 0.0 ? "val" : "train";
    lines += "\nnames:\n";
    const std::vector<std::string> names = style.GetCategories();
    for (std::size_t i = 0; i < names.size(); ++i)
    {
      lines += "  " + std::to_string(i) + ": " +
        Json(names[i]).dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
    }
    return { { "data.yaml", lines } };
  }
};
}

//------------------------------------------------------------------------------
std::unique_ptr<DatasetFormat> MakeYoloFormat()
{
  return std::make_unique<YoloFormat>();
}
}
