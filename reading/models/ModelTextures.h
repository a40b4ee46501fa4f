// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Textures and normal maps of models with bones, from images in the model's file and beside it.
 */
#ifndef ModelTextures_h
#define ModelTextures_h

#include "MaterialMaps.h"
#include "ReadingNames.h"

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <optional>
#include <string>
#include <vector>

class vtkActor;
class vtkDataSet;
class vtkRelievoModelReader;

namespace reading
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

  /// Sets the mesh's normal map on its actor, and its texture, unless the file's own material has
  /// the colours and sets the `cutoff`: the alpha below which the actor is cut out; 0: no cut-out.
  /// Notes unreadable images.
  void Put(vtkActor* actor, vtkDataSet* mesh, const std::optional<double>& cutoff);

private:
  vtkSmartPointer<vtkImageData> Find(vtkDataSet* mesh, const char* array, const std::string& what);
  vtkSmartPointer<vtkImageData> Read(const std::string& name);

  vtkRelievoModelReader* Reader;
  std::string Path;
  ReadContext& Context;
  MaterialPainter Painter;
};
}

#endif
