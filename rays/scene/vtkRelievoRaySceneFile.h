// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The content of a ray scene's file: meshes, their trees and normals, the number of props, and a
// hash of the geometry.
#ifndef vtkRelievoRaySceneFile_h
#define vtkRelievoRaySceneFile_h

#include "vtkPolyData.h"
#include "vtkRelievoMeshTree.h"
#include "vtkRelievoPlacedMesh.h"
#include "vtkRelievoRaySource.h"
#include "vtkSmartPointer.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

class vtkRelievoRayContent;
class vtkRelievoRayFileReader;
class vtkRelievoRayTree;

class vtkRelievoRaySceneFile
{
public:
  // Follows the name of a file whose numbers do not fit each other.
  static constexpr const char* Unfit = ": is damaged: its numbers do not fit each other";

  // Hash of the points, cells and matrices of all meshes.
  static std::uint64_t HashGeometry(const vtkRelievoRayContent& content);

  // Returns the reason of a failure; empty: none.
  static std::string Write(const std::string& path, const vtkRelievoRayContent& content,
    const vtkRelievoRayTree& tree, std::int64_t numberOfProps, std::uint64_t geometry);

  // Returns why the file cannot be used; empty: it can.
  std::string Read(const std::string& path);

  // Whether the trees have no cells or points that these meshes lack.
  bool Fits(const std::vector<vtkRelievoPlacedMesh>& meshes) const;

  // Sets the trees of the content's meshes, which are those of the file.
  void GiveTrees(vtkRelievoRayContent& content) const;

  std::vector<vtkRelievoPlacedMesh> Meshes;
  std::vector<vtkRelievoRaySource> Sources;
  std::int64_t NumberOfProps = 0;
  std::uint64_t Geometry = 0;

private:
  bool ReadMesh(vtkRelievoRayFileReader& file);

  std::vector<std::shared_ptr<vtkRelievoMeshTree>> Trees;
  std::vector<vtkSmartPointer<vtkPolyData>> Owned; // of Meshes: they have normals and indices
  std::vector<vtkSmartPointer<vtkIdTypeArray>> Indices;
  std::shared_ptr<const void> Memory; // of the arrays
};

#endif
