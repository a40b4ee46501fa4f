// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Reads models with bones into actors: posed at a time, with colours and textures.
 */
#ifndef Models_h
#define Models_h

#include "ReadingNames.h"
#include "vtkActor.h"              // for the parts
#include "vtkRelievoModelReader.h" // for the model
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace reading
{
class ReadContext;
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

/// Makes an actor for each mesh. Notes repairs made while reading, and missing textures. Throws
/// WorkError naming the path.
PosedModel ReadModel(
  const std::string& path, const ModelChoice& choice, bool smooth, ReadContext& context);

/// Moves the model's actors to a time in seconds.
void PlayModel(PosedModel& model, double time, ReadContext& context);

/// The rows of the options of models.
void AddModelOptions(OptionRows& rows, ModelChoice& model);
}

#endif
