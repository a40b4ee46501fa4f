// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The frame around a renderer's pass, and away again.
#include "vtkRelievoPass.h"

#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

//------------------------------------------------------------------------------
vtkRelievoPass* vtkRelievoPass::Attach(vtkRenderer* renderer)
{
  if (!renderer)
  {
    vtkGenericWarningMacro("Attach was given no renderer; give it the vtkRenderer to wrap.");
    return nullptr;
  }
  if (vtkRelievoPass* there = vtkRelievoPass::SafeDownCast(renderer->GetPass()))
  {
    return there;
  }
  vtkNew<vtkRelievoPass> pass;
  pass->SetDelegatePass(renderer->GetPass());
  renderer->SetPass(pass);
  return pass;
}

//------------------------------------------------------------------------------
bool vtkRelievoPass::Detach(vtkRenderer* renderer)
{
  vtkRelievoPass* pass = renderer ? vtkRelievoPass::SafeDownCast(renderer->GetPass()) : nullptr;
  if (!pass)
  {
    return false;
  }
  // The renderer may hold the last reference.
  vtkSmartPointer<vtkRelievoPass> alive = pass;
  if (renderer->GetRenderWindow())
  {
    pass->ReleaseStages(renderer->GetRenderWindow());
  }
  renderer->SetPass(pass->GetDelegatePass());
  return true;
}
