// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The layout of a data set in its folder: the files of a view, and the indices of all views.
 */
#ifndef DatasetFormats_h
#define DatasetFormats_h

#include "DatasetNames.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

class vtkRelievoCameraModel;
class vtkRenderer;

namespace dataset
{
class DatasetFormat;
class DatasetObjects;
class NumpyArchive;
struct DatasetView;

constexpr double BytesOfMegabyte = 1e6;
constexpr double MostDepthSteps = 65535.0; ///< the largest 16-bit depth

struct DatasetStyle
{
  std::string Folder;
  const DatasetFormat* Format = nullptr;
  double DepthStep = 0.0; ///< world units per step of 16-bit depth
  double MillimetersPerUnit = 1000.0;
  std::vector<std::string> Layers; ///< requested layers
  double Validation = 0.0;         ///< share of the views for validation
  double ShardBytes = 0.0;         ///< of an archive of several views, at most

  /// Whether a view is for validation: these views are spread evenly.
  bool IsValidation(std::size_t view) const;

  ///@{
  /// Sets the category of each object. All categories, in the order of their first objects, and
  /// the place there of an object's.
  void SetCategories(const std::vector<std::string>& ofObjects);
  const std::vector<std::string>& GetCategories() const { return this->Categories; }
  std::size_t GetCategory(std::size_t object) const { return this->CategoryOf[object]; }
  ///@}

  /// Hashes of the files written since it was last emptied, by path in the folder.
  mutable std::map<std::string, std::string> Hashes;

  ///@{
  /// WriteWhole for a path in the folder. Throws FileError.
  void Write(const std::string& path, const std::string& bytes) const;
  void Write(const std::string& path, const std::function<bool(const std::string&)>& write) const;
  ///@}

private:
  std::vector<std::string> Categories;
  std::vector<std::size_t> CategoryOf; // each object
};

/// An archive of several views: its name, the archives that it joins, and its size.
struct DatasetArchive
{
  std::string Name;
  std::vector<std::string> Files;
  std::uint64_t Bytes = 0;
};

/// A format: its requirements for views, and the files of a view and of all views. Each is in a
/// file of its own in formats/, with its name in dataset/CMakeLists.txt.
class DatasetFormat
{
public:
  using Json = nlohmann::ordered_json;

  explicit DatasetFormat(const std::string& name)
    : Name(name)
  {
  }
  virtual ~DatasetFormat() = default;
  DatasetFormat(const DatasetFormat&) = delete;
  void operator=(const DatasetFormat&) = delete;

  const std::string Name;

  bool NeedsPicture = true;      ///< each camera must give a picture
  bool NeedsK = false;           ///< each camera must have a K
  bool NeedsSilhouettes = false; ///< of objects, up to a picture's size beyond the picture
  bool HasDepthSteps = true;     ///< writes 16-bit depth
  bool HasCategories = false;    ///< can hold several objects of one category
  bool HasSplit = false;         ///< tells views for validation from those for training

  /// Throws UsageError for a layer that cannot be written together with the others.
  virtual void CheckLayer(const std::string&) const {}

  /// Throws UsageError if the format cannot represent a camera that otherwise fits, next to the
  /// camera of the first view; `view` names it in the message.
  virtual void CheckCamera(
    vtkRelievoCameraModel*, vtkRelievoCameraModel*, const std::string& /*view*/) const
  {
  }

  ///@{
  /// Extra data that WriteIndex needs in an object's record: whether it is present, and adding it,
  /// by the object's number.
  virtual bool IsObject(const Json&) const { return true; }
  virtual void DescribeObject(const DatasetView&, std::size_t, Json&) const {}
  ///@}

  /// Writes the files of a view; their names begin with `name`. Throws FileError.
  virtual void WriteView(const DatasetStyle& style, const DatasetView& view,
    const DatasetObjects& objects, const Json& record, const std::string& name) const = 0;

  /// The indices of these complete records: each file's name, and its bytes.
  virtual std::vector<std::pair<std::string, std::string>> MakeIndex(const DatasetStyle&,
    const std::vector<std::string>& /*objects*/, const std::vector<Json>&) const
  {
    return {};
  }

  /// The archives of these complete records, which are written before the indices.
  virtual std::vector<DatasetArchive> GetArchives(
    const DatasetStyle&, const std::vector<Json>&) const
  {
    return {};
  }

  /// Writes the meshes to which poses refer. Throws FileError.
  virtual void WriteModels(const DatasetStyle&, vtkRenderer*, const DatasetObjects&) const {}
};

/// All formats, in the order of vtkRelievoDatasetWriter::Formats.
const std::vector<std::unique_ptr<DatasetFormat>>& GetDatasetFormats();

#define RELIEVO_DATASET_FORMAT(name) std::unique_ptr<DatasetFormat> Make##name##Format();
#include "DatasetFormatList.h"
#undef RELIEVO_DATASET_FORMAT

/// Whether the entry is a list of `count` numbers.
bool IsNumbers(const nlohmann::ordered_json& json, const char* name, std::size_t count);

/// Depth from the top in whole steps; 0: no depth, beyond the last step, or behind the camera's
/// plane.
std::vector<unsigned short> GetDepthSteps(const DatasetView& view, double step);

/// Adds a layer in its original type, from the top.
void AddDatasetLayer(NumpyArchive& archive, const DatasetView& view, const std::string& name);

/// Writes the picture, the depth and the layers to their folders in the data set.
void WriteDatasetPictures(const DatasetStyle& style, const DatasetView& view,
  const std::string& folder, const std::string& name);

/// Whether the record has all entries that a format's indices read, for so many objects.
bool IsDatasetRecord(
  const DatasetFormat& format, const nlohmann::ordered_json& record, std::size_t objects);

/// Throws UsageError for a camera that a format cannot represent next to that of the first view;
/// `view` names it in the message.
void CheckDatasetCamera(const DatasetFormat& format, vtkRelievoCameraModel* camera,
  vtkRelievoCameraModel* first, const std::string& view);

/// A camera's part of a record: size, R, t and calibration.
nlohmann::ordered_json DescribeDatasetCamera(vtkRelievoCameraModel* camera);

/// Writes the files of a view and adds to its record the entries that the indices need. Returns the
/// number of pixels beyond the last step of 16-bit depth. Throws FileError.
std::size_t WriteDatasetView(const DatasetStyle& style, const DatasetView& view,
  const DatasetObjects& objects, vtkRelievoCameraModel* camera, std::size_t number,
  nlohmann::ordered_json& record);
}

#endif
