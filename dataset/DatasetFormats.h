// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * How a data set lies in its folder: the files of a view, and the indices of all views.
 */
#ifndef DatasetFormats_h
#define DatasetFormats_h

#include <nlohmann/json.hpp>

#include <memory>
#include <string>
#include <vector>

class vtkRelievoCameraModel;
class vtkRenderer;

namespace scene
{
class DatasetFormat;
class DatasetObjects;
struct DatasetView;

constexpr double MostDepthSteps = 65535.0; ///< of 16-bit depth

struct DatasetStyle
{
  std::string Folder;
  const DatasetFormat* Format = nullptr;
  double DepthStep = 0.0; ///< world units of a step of 16-bit depth
  double MillimetersPerUnit = 1000.0;
  std::vector<std::string> Layers; ///< as asked for
};

/// A format: what it needs of views, and the files of a view and of all views. Each has a file of
/// its own in formats/ and a word in dataset/CMakeLists.txt.
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

  bool NeedsPicture = true;      ///< of every camera
  bool NeedsK = false;           ///< of every camera
  bool NeedsSilhouettes = false; ///< of objects, up to a picture's size beyond the picture
  bool HasDepthSteps = true;     ///< depth in 16 bits

  /// Throws UsageError for a layer that cannot be written beside the others.
  virtual void CheckLayer(const std::string&) const {}

  /// Throws UsageError for a camera that has what is needed and that the format cannot say, beside
  /// that of the first view; `view` names it.
  virtual void CheckCamera(
    vtkRelievoCameraModel*, vtkRelievoCameraModel*, const std::string& /*view*/) const
  {
  }

  ///@{
  /// What the record of an object has for WriteIndex besides what all have: whether it is there,
  /// and adding it, by the object's number.
  virtual bool IsObject(const Json&) const { return true; }
  virtual void DescribeObject(const DatasetView&, std::size_t, Json&) const {}
  ///@}

  /// Writes the files of a view, whose names begin with `name`. Throws FileError.
  virtual void WriteView(const DatasetStyle& style, const DatasetView& view,
    const DatasetObjects& objects, const Json& record, const std::string& name) const = 0;

  /// Writes the indices of these records, which are whole. Throws FileError.
  virtual void WriteIndex(const DatasetStyle&, const std::vector<std::string>& /*objects*/,
    const std::vector<Json>&) const
  {
  }

  /// Writes the meshes that poses place. Throws FileError.
  virtual void WriteModels(const DatasetStyle&, vtkRenderer*, const DatasetObjects&) const {}
};

/// All of them, in the order of vtkRelievoDatasetWriter::Formats.
const std::vector<std::unique_ptr<DatasetFormat>>& GetDatasetFormats();

#define RELIEVO_DATASET_FORMAT(name) std::unique_ptr<DatasetFormat> Make##name##Format();
#include "DatasetFormatList.h"
#undef RELIEVO_DATASET_FORMAT

/// The six digits of a view or an object in names of files.
std::string WriteDatasetNumber(std::size_t number);

///@{
/// JSON as it is written, also to a file; what a text has besides Unicode is replaced.
std::string WriteDatasetJson(const nlohmann::ordered_json& json);
void WriteDatasetJson(const std::string& path, const nlohmann::ordered_json& json);
///@}

/// Whether the entry is a list of so many numbers.
bool IsNumbers(const nlohmann::ordered_json& json, const char* name, std::size_t count);

/// Writes the picture to a folder of the data set, and depth and layers to theirs.
void WriteDatasetPictures(const DatasetStyle& style, const DatasetView& view,
  const std::string& folder, const std::string& name);

/// Whether the record has what the indices of a format read, of so many objects.
bool IsDatasetRecord(
  const DatasetFormat& format, const nlohmann::ordered_json& record, std::size_t objects);

/// Throws UsageError for a camera that a format cannot say, beside that of the first view; `view`
/// names it.
void CheckDatasetCamera(const DatasetFormat& format, vtkRelievoCameraModel* camera,
  vtkRelievoCameraModel* first, const std::string& view);

/// What a record says of a camera: size, R, t, and what it is calibrated by.
nlohmann::ordered_json DescribeDatasetCamera(vtkRelievoCameraModel* camera);

/// Writes the files of a view and adds to its record what the indices need. Returns how many pixels
/// lie beyond the last step of 16-bit depth. Throws FileError.
std::size_t WriteDatasetView(const DatasetStyle& style, const DatasetView& view,
  const DatasetObjects& objects, vtkRelievoCameraModel* camera, std::size_t number,
  nlohmann::ordered_json& record);
}

#endif
