// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSplicedKeys.h"

#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkProp.h"

#include <algorithm>

// Set and Resize, not Append and Remove: these also count references past the keys' own smart
// pointers, which a copy of the keys gets wrong.

//------------------------------------------------------------------------------
void vtkRelievoSplicedKeys::Add(vtkProp* prop, vtkOpenGLRenderPass* pass)
{
  if (!prop->GetPropertyKeys())
  {
    vtkNew<vtkInformation> made;
    prop->SetPropertyKeys(made);
  }
  vtkInformation* keys = prop->GetPropertyKeys();
  if (std::find(this->Keys.begin(), this->Keys.end(), keys) != this->Keys.end())
  {
    return;
  }
  this->Keys.emplace_back(keys);
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

//------------------------------------------------------------------------------
void vtkRelievoSplicedKeys::Remove(vtkOpenGLRenderPass* pass)
{
  vtkInformationObjectBaseVectorKey* key = vtkOpenGLRenderPass::RenderPasses();
  for (vtkInformation* keys : this->Keys)
  {
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
  this->Keys.clear();
}
