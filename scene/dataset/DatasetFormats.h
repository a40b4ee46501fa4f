// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * How a data set lies in its folder: the files of a view, and the indices of all views.
 */
#ifndef DatasetFormats_h
#define DatasetFormats_h

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

class vtkRelievoCameraModel;

namespace scene
{
class DatasetObjects;
struct DatasetView;

enum class DatasetFormat
{
  BOP,
  COCO,
  NeRF,
  Numpy
};

constexpr double MostDepthSteps = 65535.0; ///< of 16-bit depth

/// By DatasetFormat.
extern const std::vector<std::string> DatasetFormatNames;

struct DatasetStyle
{
  std::string Folder;
  DatasetFormat Format = DatasetFormat::BOP;
  double DepthStep = 0.0; ///< world units of a step of 16-bit depth
  double MillimetersPerUnit = 1000.0;
  std::vector<std::string> Layers; ///< as asked for
};

/// The six digits of a view or an object in names of files.
std::string WriteDatasetNumber(std::size_t number);

/// JSON as it is written; what a text has besides Unicode is replaced.
std::string WriteDatasetJson(const nlohmann::ordered_json& json);

/// Whether the record has what the indices of a format read, of so many objects.
bool IsDatasetRecord(
  DatasetFormat format, const nlohmann::ordered_json& record, std::size_t objects);

/// Throws UsageError for a camera that a format cannot say, beside that of the first view; `view`
/// names it.
void CheckDatasetCamera(DatasetFormat format, vtkRelievoCameraModel* camera,
  vtkRelievoCameraModel* first, const std::string& view);

/// What a record says of a camera: size, R, t, and what it is calibrated by.
nlohmann::ordered_json DescribeDatasetCamera(vtkRelievoCameraModel* camera);

/// Writes the files of a view and adds to its record what the indices need. Returns how many pixels
/// lie beyond the last step of 16-bit depth. Throws FileError.
std::size_t WriteDatasetView(const DatasetStyle& style, const DatasetView& view,
  const DatasetObjects& objects, vtkRelievoCameraModel* camera, std::size_t number,
  nlohmann::ordered_json& record);

/// Writes the indices of these records, which are whole. Throws FileError.
void WriteDatasetIndex(const DatasetStyle& style, const std::vector<std::string>& objects,
  const std::vector<nlohmann::ordered_json>& records);
}

#endif
