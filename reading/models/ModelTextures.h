// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Textures and normal maps of models with bones, from images in the model's file and beside it.
 */
#ifndef ModelTextures_h
#define ModelTextures_h

#include "vtkImageData.h"
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
class ReadContext;

class ModelTextures
{
public:
  ModelTextures(vtkRelievoModelReader* reader, const std::string& path, ReadContext& context)
    : Reader(reader)
    , Path(path)
    , Context(context)
  {
  }

  /// The texture that the mesh names, on its actor. Returns the alpha below which the actor is cut
  /// out; 0: nowhere. What cannot be read is noted.
  double PutColor(vtkActor* actor, vtkDataSet* mesh);

  /// The normal map that the mesh names, and the cutoff, on its actor.
  void PutMaterial(vtkActor* actor, vtkDataSet* mesh, double cutoff);

private:
  vtkSmartPointer<vtkImageData> Find(vtkDataSet* mesh, const char* array, const std::string& what);
  vtkSmartPointer<vtkImageData> Read(const std::string& name);

  vtkRelievoModelReader* Reader;
  std::string Path;
  ReadContext& Context;
  // Meshes share them, where they are alike.
  std::map<vtkImageData*, vtkSmartPointer<vtkTexture>> Textures;
  std::map<std::tuple<vtkImageData*, double, double, bool>, vtkSmartPointer<vtkRelievoMaterial>>
    Materials; ///< by normal map, its strength, cutoff, and whether it repeats
};
}

#endif
