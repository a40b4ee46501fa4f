// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The stages known to frames by name. A library registers its stages once, when it is loaded:
//
//   static const bool registered = vtkRelievoStageRegistry::Add([] { return vtkMyStage::New(); });
//
// Frames made later have the stage, switched off unless its description tells otherwise.
#ifndef vtkRelievoStageRegistry_h
#define vtkRelievoStageRegistry_h

#include "vtkRelievoFrameModule.h" // for the export macro
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkRelievoStage;

class VTKRELIEVOFRAME_EXPORT vtkRelievoStageRegistry
{
public:
  // Makes a new stage, owned by the caller.
  using Maker = vtkRelievoStage* (*)();

  // False, with an error, if a stage of that name is registered already.
  static bool Add(Maker maker);

  // Makes one of each stage, ordered by slot and name.
  static std::vector<vtkSmartPointer<vtkRelievoStage>> MakeAll();
};

#endif
