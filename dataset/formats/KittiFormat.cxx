// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DatasetFiles.h"
#include "DatasetFormats.h"
#include "DatasetView.h"

#include <algorithm>
#include <array>

namespace dataset
{
namespace
{
using Json = nlohmann::ordered_json;

// Words of a label's line are separated by spaces.
std::string GetWord(std::string name)
{
  std::replace_if(
    name.begin(), name.end(), [](unsigned char letter) { return letter <= ' '; }, '_');
  return name;
}

// Levels of occlusion by the visible share; KITTI defines them in words only.
int GetOcclusion(double visible)
{
  constexpr double fully = 0.95, largely = 0.5;
  return visible >= fully ? 0 : visible >= largely ? 1 : 2;
}

// Boxes in the picture, for detectors that read the labels of KITTI's object benchmark.
class KittiFormat : public DatasetFormat
{
public:
  KittiFormat()
    : DatasetFormat("kitti")
  {
    this->NeedsK = true;
    this->NeedsSilhouettes = true;
    this->HasCategories = true;
    this->HasSplit = true;
  }

  void WriteView(const DatasetStyle& style, const DatasetView& view, const DatasetObjects&,
    const Json& record, const std::string& name) const override
  {
    WriteDatasetPictures(style, view, "training/image_2", name);
    const std::vector<std::string> categories = style.GetCategories();
    std::string lines;
    for (std::size_t i = 0; i < view.Visible.size(); ++i)
    {
      const auto seen = static_cast<double>(view.Visible[i].GetCount());
      if (seen == 0.0)
      {
        continue;
      }
      const bool isWhole = view.Whole[i].GetCount() > 0;
      const DatasetMask& whole = isWhole ? view.Whole[i] : view.Visible[i];
      const auto inside = static_cast<double>(whole.GetCount());
      const double all = std::max(inside, static_cast<double>(view.Silhouettes[i].Count));
      const std::array<int, 4> box = whole.GetBox();
      lines += GetWord(categories[style.GetCategory(i)]) + " " + Json(1.0 - inside / all).dump() +
        " " + std::to_string(GetOcclusion(seen / inside)) + " -10 "; // angle of view: unknown
      for (const int edge : { box[0], box[1], box[0] + box[2] - 1, box[1] + box[3] - 1 })
      {
        lines += std::to_string(edge) + " ";
      }
      lines += "-1 -1 -1 -1000 -1000 -1000 -10\n"; // no box in space
    }
    style.Write("training/label_2/" + name + ".txt", lines);
    // Loaders read all lines: the four cameras of the benchmark's car, and its lidar, are this one.
    std::string matrix, calibration;
    for (std::size_t k = 0; k < 9; ++k)
    {
      matrix += " " + record["camera"]["K"][k].dump() + (k % 3 == 2 ? " 0.0" : "");
    }
    for (const char* camera : { "P0:", "P1:", "P2:", "P3:" })
    {
      calibration += camera + matrix + "\n";
    }
    const std::string moved = " 1.0 0.0 0.0 0.0 0.0 1.0 0.0 0.0 0.0 0.0 1.0 0.0\n";
    calibration += "R0_rect: 1.0 0.0 0.0 0.0 1.0 0.0 0.0 0.0 1.0\n";
    calibration += "Tr_velo_to_cam:" + moved + "Tr_imu_to_velo:" + moved;
    style.Write("training/calib/" + name + ".txt", calibration);
  }

  std::vector<std::pair<std::string, std::string>> MakeIndex(const DatasetStyle& style,
    const std::vector<std::string>&, const std::vector<Json>& records) const override
  {
    std::string training, validation;
    for (const Json& record : records)
    {
      const auto view = record["view"].get<std::size_t>();
      (style.IsValidation(view) ? validation : training) += WriteDatasetNumber(view) + "\n";
    }
    std::vector<std::pair<std::string, std::string>> lists = { { "ImageSets/train.txt",
      training } };
    if (style.Validation > 0.0)
    {
      lists.emplace_back("ImageSets/val.txt", validation);
    }
    return lists;
  }
};
}

//------------------------------------------------------------------------------
std::unique_ptr<DatasetFormat> MakeKittiFormat()
{
  return std::make_unique<KittiFormat>();
}
}
