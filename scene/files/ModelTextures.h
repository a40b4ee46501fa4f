// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Textures and normal maps of models with bones, from images in the model's file and beside it.
 */
#ifndef ModelTextures_h
#define ModelTextures_h

#include "vtkImageData.h"
#include "vtkRelievoAllowedFolders.h"
#include "vtkRelievoMaterial.h"
#include "vtkSmartPointer.h"
#include "vtkTexture.h"

#include <map>
#include <string>
#include <tuple>
#include <vector>

class vtkActor;
class vtkDataSet;
class vtkRelievoModelReader;

namespace scene
{
class Progress;

class ModelTextures
{
public:
  /// `folders`: allowed folders of images, besides the file's own folder and below.
  ModelTextures(
    vtkRelievoModelReader* reader, const std::string& path, const std::vector<std::string>& folders)
    : Reader(reader)
    , Path(path)
    , Allowed(path, folders)
  {
  }

  /// Sets the mesh's texture on its actor. Returns the alpha below which the actor is cut out; 0:
  /// no cut-out. Notes unreadable images.
  double PutColor(vtkActor* actor, vtkDataSet* mesh, Progress& progress);

  /// Sets the mesh's normal map and the cutoff on its actor.
  void PutMaterial(vtkActor* actor, vtkDataSet* mesh, double cutoff, Progress& progress);

private:
  vtkSmartPointer<vtkImageData> Find(
    vtkDataSet* mesh, const char* array, const std::string& what, Progress& progress);
  vtkSmartPointer<vtkImageData> Read(const std::string& name, Progress& progress);

  vtkRelievoModelReader* Reader;
  std::string Path;
  vtkRelievoAllowedFolders Allowed;
  // Equal meshes share their materials.
  std::map<vtkImageData*, vtkSmartPointer<vtkTexture>> Textures;
  std::map<std::tuple<vtkImageData*, double, double, bool>, vtkSmartPointer<vtkRelievoMaterial>>
    Materials; ///< by normal map, its strength, cutoff, and whether it repeats
};
}

#endif
