// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DatasetFiles.h"
#include "DatasetFormats.h"
#include "DatasetObjects.h"
#include "DatasetView.h"
#include "Errors.h"

#include "vtkDataArray.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cstdint>
#include <set>

namespace dataset
{
namespace
{
using Json = nlohmann::ordered_json;

// All data of a view as arrays that numpy.load() reads.
class NpzFormat : public DatasetFormat
{
public:
  NpzFormat()
    : DatasetFormat("npz")
  {
    this->NeedsPicture = false;
    this->HasDepthSteps = false;
  }

  void CheckLayer(const std::string& layer) const override
  {
    static const std::set<std::string> own = { "color", "object", "visible_masks", "amodal_masks",
      "visible_boxes", "amodal_boxes", "object_to_world", "K", "R", "t", "lens", "distortion",
      "field_of_view", "orthographic", "push_broom", "elevations", "azimuths", "turn", "way",
      "rotation", "min_range", "max_range", "divergence", "noise" };
    if (own.count(layer) > 0)
    {
      throw UsageError("layer " + layer +
        ": is the name of an array that npz has itself; expected another layer, or another format");
    }
  }

  void WriteView(const DatasetStyle& style, const DatasetView& view, const DatasetObjects& objects,
    const Json& record, const std::string& name) const override
  {
    const auto rows = static_cast<std::size_t>(view.Rows);
    const auto columns = static_cast<std::size_t>(view.Columns);
    const std::size_t count = view.Visible.size();
    NumpyArchive archive;
    if (!view.Picture.empty())
    {
      archive.Add("color", "|u1", { rows, columns, 3 }, view.Picture.data(), view.Picture.size());
    }
    AddDatasetLayer(archive, view, "depth");
    for (const std::string& layer : style.Layers)
    {
      if (layer != "depth")
      {
        AddDatasetLayer(archive, view, layer);
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
      else if (array != "size") // all arrays have it
      {
        const auto values = value.get<std::vector<double>>();
        const bool isMatrix = array == "K" || array == "R";
        add(array, isMatrix ? std::vector<std::size_t>{ 3, 3 } : std::vector{ values.size() },
          values);
      }
    }
    style.Write(name + ".npz", archive.Finish(style.Folder + "/" + name + ".npz"));
  }
};
}

//------------------------------------------------------------------------------
std::unique_ptr<DatasetFormat> MakeNpzFormat()
{
  return std::make_unique<NpzFormat>();
}
}
