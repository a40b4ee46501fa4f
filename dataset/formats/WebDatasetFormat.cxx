// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DatasetFiles.h"
#include "DatasetFormats.h"
#include "DatasetView.h"
#include "TarArchive.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>

namespace dataset
{
namespace
{
using Json = nlohmann::ordered_json;

// Samples in tar archives, as the package webdataset reads them: each view is an archive of its
// own, which the indices join to shards.
class WebDatasetFormat : public DatasetFormat
{
public:
  WebDatasetFormat()
    : DatasetFormat("webdataset")
  {
  }

  void WriteView(const DatasetStyle& style, const DatasetView& view, const DatasetObjects&,
    const Json& record, const std::string& name) const override
  {
    TarArchive sample;
    sample.Add(name + ".png", EncodePNG(view.Picture, view.Columns, view.Rows, 3));
    sample.Add(name + ".depth.png",
      EncodePNG(GetDepthSteps(view, style.DepthStep), view.Columns, view.Rows));
    std::vector<unsigned short> ids(view.Objects.size());
    std::transform(view.Objects.begin(), view.Objects.end(), ids.begin(),
      [](int object) { return static_cast<unsigned short>(object + 1); });
    sample.Add(name + ".object.png", EncodePNG(ids, view.Columns, view.Rows));
    if (!style.Layers.empty())
    {
      NumpyArchive layers;
      for (const std::string& layer : style.Layers)
      {
        AddDatasetLayer(layers, view, layer);
      }
      sample.Add(name + ".layers.npz", layers.Finish(style.Folder + "/" + GetSample(name)));
    }
    Json described = record;
    described["depth_step"] = style.DepthStep;
    sample.Add(name + ".json", WriteDatasetJson(described));
    style.Write(GetSample(name), sample.Finish());
  }

  std::vector<std::pair<std::string, std::string>> MakeIndex(const DatasetStyle& style,
    const std::vector<std::string>&, const std::vector<Json>& records) const override
  {
    Json shards = Json::array();
    for (const DatasetArchive& shard : this->GetArchives(style, records))
    {
      shards.push_back(
        { { "url", shard.Name }, { "nsamples", shard.Files.size() }, { "filesize", shard.Bytes } });
    }
    return { { "index.json",
      WriteDatasetJson({ { "__kind__", "wids-shard-index-v1" }, { "wids_version", 1 },
        { "shardlist", shards } }) } };
  }

  std::vector<DatasetArchive> GetArchives(
    const DatasetStyle& style, const std::vector<Json>& records) const override
  {
    std::vector<DatasetArchive> shards;
    std::vector<std::uint64_t> sizes; // of the last shard's files
    for (const Json& record : records)
    {
      const std::string file = GetSample(WriteDatasetNumber(record["view"]));
      std::error_code trouble;
      const std::uint64_t size = std::filesystem::file_size(style.Folder + "/" + file, trouble);
      sizes.push_back(trouble ? 0 : size);
      if (shards.empty() || static_cast<double>(GetJoinedTarBytes(sizes)) > style.ShardBytes)
      {
        shards.push_back({ "shard-" + WriteDatasetNumber(shards.size()) + ".tar", {}, 0 });
        sizes = { sizes.back() };
      }
      shards.back().Files.push_back(file);
      shards.back().Bytes = GetJoinedTarBytes(sizes);
    }
    return shards;
  }

private:
  static std::string GetSample(const std::string& name) { return "samples/" + name + ".tar"; }
};
}

//------------------------------------------------------------------------------
std::unique_ptr<DatasetFormat> MakeWebDatasetFormat()
{
  return std::make_unique<WebDatasetFormat>();
}
}
