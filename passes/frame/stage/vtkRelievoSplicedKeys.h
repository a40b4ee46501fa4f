// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The property keys that a pass is spliced into. Several props may hold the same keys: assemblies
// hand theirs to their parts, copies of an actor share them. And a prop may be given other keys
// before the pass leaves: it leaves the keys it came into.
#ifndef vtkRelievoSplicedKeys_h
#define vtkRelievoSplicedKeys_h

#include "vtkRelievoFrameModule.h" // for the export macro
#include "vtkSmartPointer.h"

#include <vector>

class vtkInformation;
class vtkOpenGLRenderPass;
class vtkProp;

class VTKRELIEVOFRAME_EXPORT vtkRelievoSplicedKeys
{
public:
  // Adds the pass to the prop's keys, once to each keys; makes keys where the prop has none.
  void Add(vtkProp* prop, vtkOpenGLRenderPass* pass);

  // Takes the pass out of all keys that it was added to.
  void Remove(vtkOpenGLRenderPass* pass);

private:
  std::vector<vtkSmartPointer<vtkInformation>> Keys;
};

#endif
