// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A data set whose views several processes have drawn: whether it is whole, and its indices.
 */
#ifndef DatasetParts_h
#define DatasetParts_h

#include "DatasetFormats.h"
#include "DatasetNames.h"
#include "WorkFolder.h"

#include <string>
#include <vector>

namespace dataset
{
/// The file of a data set's settings.
constexpr const char* DatasetSettings = "dataset.json";

/// The path of a view's record.
std::string GetDatasetRecord(const std::string& folder, std::size_t view);

/// Writes the indices of these records. Throws FileError.
void WriteDatasetIndex(const DatasetStyle& style, const std::vector<std::string>& objects,
  const std::vector<nlohmann::ordered_json>& records);

/// The complete and the missing views. Throws FileError if the folder is no data set.
WorkState VerifyDataset(const std::string& folder, WorkCheck check);

/// Writes the indices, and removes the files about progress. Throws WorkError if views are missing
/// or damaged.
void MergeDataset(const std::string& folder);
}

#endif
