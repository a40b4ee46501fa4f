// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Reads models with bones into actors: posed at a time, with colours and textures.
 */
#ifndef Models_h
#define Models_h

#include "vtkActor.h"              // for the parts
#include "vtkRelievoModelReader.h" // for the model
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace scene
{
class Progress;
struct ModelChoice;

struct PosedModel
{
  struct Part
  {
    unsigned int Block; ///< of the reader's output
    vtkSmartPointer<vtkActor> Actor;
  };
  std::string Path;
  bool Smooth = true; ///< as in MakeActor
  vtkSmartPointer<vtkRelievoModelReader> Reader;
  std::vector<Part> Parts;
  vtkSmartPointer<vtkActor> Skeleton; ///< null: not requested
};

/// Makes an actor for each mesh. Notes repairs made while reading, and missing textures. `folders`:
/// allowed folders of files that the model names, besides its own folder and below. Throws
/// WorkError naming the path.
PosedModel ReadModel(const std::string& path, const std::vector<std::string>& folders,
  const ModelChoice& choice, bool smooth, Progress& progress);

/// Moves the model's actors to a time in seconds.
void PlayModel(PosedModel& model, double time, Progress& progress);
}

#endif
