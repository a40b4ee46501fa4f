// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The stages that frames know by name. A library registers its stages once, when it is loaded:
//
//   static const bool registered = vtkRelievoStageRegistry::Add([] { return vtkMyStage::New(); });
//
// Frames that are made from then on have the stage, switched off unless its description says else.
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
  // A new stage, which the caller owns.
  using Maker = vtkRelievoStage* (*)();

  // False, with an error, if a stage of that name is there already.
  static bool Add(Maker maker);

  // One of each, by slot and name.
  static std::vector<vtkSmartPointer<vtkRelievoStage>> MakeAll();
};

#endif
