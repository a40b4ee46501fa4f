// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A mesh whose cells, or points, several processes compute: FILE.parts beside the mesh's file, with
 * parts.json, the settings; mesh.vtp, by part 1; for each part its values and a record, which is
 * written last.
 */
#ifndef MeshParts_h
#define MeshParts_h

#include "WorkFolder.h"

#include <memory>
#include <string>

class vtkObject;
class vtkPolyData;
class vtkRelievoSightAlgorithm;

namespace reading
{
class Progress;
}

namespace cli
{
class MeshParts
{
public:
  /// The folder of the parts of a file: "town.vtp.parts".
  static std::string GetFolder(const std::string& file) { return file + ".parts"; }

  explicit MeshParts(const std::string& folder);

  /// Prepares the filter for a part, in a folder that is new or was begun by this command with
  /// these words and the filter's meshes; otherwise throws UsageError. False, with a line for the
  /// user, if the part is complete.
  bool Begin(const std::string& command, const std::string& words, vtkRelievoSightAlgorithm* filter,
    const dataset::WorkPart& part);

  /// Writes the part that the filter has computed. Throws FileError.
  void End(vtkRelievoSightAlgorithm* filter, const dataset::WorkPart& part,
    reading::Progress& progress) const;

  /// The complete and the missing parts. Throws FileError.
  dataset::WorkState Verify(dataset::WorkCheck check) const;

  /// Joins all parts to the mesh's file, beside the folder, and returns its path. Throws WorkError
  /// if parts are missing or damaged.
  std::string Merge(reading::Progress& progress) const;

  /// The file of a folder's settings.
  static constexpr const char* Settings = "parts.json";

private:
  std::string GetFile() const; // the result
  std::string GetPath(const dataset::WorkPart& part, const char* extension) const;

  bool Has(const dataset::WorkPart& part) const; // complete

  // Writes a share of the arrays that `result` has and `mesh` does not; the first part also writes
  // the mesh.
  void Write(const dataset::WorkPart& part, vtkPolyData* mesh, vtkPolyData* result,
    reading::Progress& progress) const;

  void TakeProgress(vtkObject*, unsigned long, void* share);

  std::string Folder;
  std::string Hash; // of the settings
  std::unique_ptr<dataset::PartProgress> Shown;
};
}

#endif
