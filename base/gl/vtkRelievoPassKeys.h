// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The passes among a prop's keys, whose text VTK's mappers put into their shaders. Uses Set and
// Resize instead of Append and Remove, which also count references without the keys' smart
// pointers, so that deleted or copied keys have wrong counts.
#ifndef vtkRelievoPassKeys_h
#define vtkRelievoPassKeys_h

#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkOpenGLRenderPass.h"

namespace vtkRelievoPassKeys
{
// Adds the pass, at most once.
inline void Add(vtkInformation* keys, vtkOpenGLRenderPass* pass)
{
  vtkInformationObjectBaseVectorKey* key = vtkOpenGLRenderPass::RenderPasses();
  const int count = key->Size(keys);
  for (int i = 0; i < count; ++i)
  {
    if (key->Get(keys, i) == pass)
    {
      return;
    }
  }
  key->Set(keys, pass, count);
}

inline void Remove(vtkInformation* keys, vtkOpenGLRenderPass* pass)
{
  vtkInformationObjectBaseVectorKey* key = vtkOpenGLRenderPass::RenderPasses();
  const int count = key->Size(keys);
  int kept = 0;
  for (int i = 0; i < count; ++i)
  {
    vtkObjectBase* other = key->Get(keys, i);
    if (other != pass)
    {
      key->Set(keys, other, kept++);
    }
  }
  if (kept == 0)
  {
    keys->Remove(key);
  }
  else if (kept < count)
  {
    key->Resize(keys, kept);
  }
}
}

#endif
