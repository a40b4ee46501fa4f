// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The property keys that a pass is spliced into. Several props may share keys: assemblies pass
// theirs to their parts, and copies of an actor share them. A prop may also get other keys before
// the pass is removed, so that the pass must be removed from the keys, not from the prop.
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
  // Adds the pass to the prop's keys, once per keys object; makes keys for a prop without.
  void Add(vtkProp* prop, vtkOpenGLRenderPass* pass);

  // Removes the pass from all keys that it was added to.
  void Remove(vtkOpenGLRenderPass* pass);

private:
  std::vector<vtkSmartPointer<vtkInformation>> Keys;
};

#endif
