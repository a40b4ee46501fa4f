// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSplicedKeys.h"

#include "vtkNew.h"
#include "vtkProp.h"
#include "vtkRelievoPassKeys.h"

#include <algorithm>

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
  vtkRelievoPassKeys::Add(keys, pass);
}

//------------------------------------------------------------------------------
void vtkRelievoSplicedKeys::Remove(vtkOpenGLRenderPass* pass)
{
  for (vtkInformation* keys : this->Keys)
  {
    vtkRelievoPassKeys::Remove(keys, pass);
  }
  this->Keys.clear();
}
