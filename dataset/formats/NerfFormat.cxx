// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DatasetFiles.h"
#include "DatasetFormats.h"
#include "Errors.h"

#include "vtkRelievoLensCamera.h"

#include <algorithm>

namespace dataset
{
namespace
{
using Json = nlohmann::ordered_json;

// Whether the record of a camera, by DescribeDatasetCamera, has a fisheye lens.
bool IsFisheye(const Json& camera)
{
  return camera.contains("lens") && camera["lens"] == "fisheye";
}

// The camera's entries of transforms.json: (0, 0) is the corner of the first pixel.
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

// transforms.json, with a single kind of lens in all views.
class NerfFormat : public DatasetFormat
{
public:
  NerfFormat()
    : DatasetFormat("nerf")
  {
    this->NeedsK = true;
    this->HasSplit = true;
  }

  void CheckCamera(vtkRelievoCameraModel* camera, vtkRelievoCameraModel* first,
    const std::string& view) const override
  {
    auto* lens = vtkRelievoLensCamera::SafeDownCast(camera);
    const auto refuse = [&view](const std::string& what) {
      throw UsageError(view + ": " + what +
        ", which transforms.json cannot describe; expected another format, or another camera");
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
        ": transforms.json has one kind of lens for all views, and view 0 has another; "
        "expected fisheyes in all views, or in none");
    }
  }

  void WriteView(const DatasetStyle& style, const DatasetView& view, const DatasetObjects&,
    const Json&, const std::string& name) const override
  {
    WriteDatasetPictures(style, view, "images", name);
  }

  std::vector<std::pair<std::string, std::string>> MakeIndex(const DatasetStyle& style,
    const std::vector<std::string>&, const std::vector<Json>& records) const override
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
    if (style.Validation > 0.0)
    {
      Json training = Json::array(), validation = Json::array();
      for (const Json& record : records)
      {
        const auto view = record["view"].get<std::size_t>();
        (style.IsValidation(view) ? validation : training)
          .push_back("images/" + WriteDatasetNumber(view) + ".png");
      }
      all["train_filenames"] = training;
      all["val_filenames"] = all["test_filenames"] = validation; // nerfstudio needs all three
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
        // Columns: right, up, backwards, camera position.
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
    return { { "transforms.json", WriteDatasetJson(all) } };
  }
};
}

//------------------------------------------------------------------------------
std::unique_ptr<DatasetFormat> MakeNerfFormat()
{
  return std::make_unique<NerfFormat>();
}
}
