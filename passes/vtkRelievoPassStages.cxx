// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Short ways to the stages that every vtkRelievoPass has.
#include "vtkRelievoDisplayStage.h"
#include "vtkRelievoGBufferPass.h"
#include "vtkRelievoPass.h"
#include "vtkRelievoShadowPass.h"

namespace
{
template <typename Stage>
Stage* Find(vtkRelievoFramePass* frame, const char* name)
{
  return Stage::SafeDownCast(frame->GetStage(name));
}
}

//------------------------------------------------------------------------------
vtkRelievoGBufferPass* vtkRelievoPass::GetGBuffer()
{
  return Find<vtkRelievoGBufferPass>(this, "gbuffer");
}

//------------------------------------------------------------------------------
vtkRelievoShadowPass* vtkRelievoPass::GetShadowPass()
{
  return Find<vtkRelievoShadowPass>(this, "shadows");
}

//------------------------------------------------------------------------------
vtkRelievoDisplayStage* vtkRelievoPass::GetDisplay()
{
  return Find<vtkRelievoDisplayStage>(this, "display");
}

//------------------------------------------------------------------------------
void vtkRelievoPass::SetShadows(bool on)
{
  this->GetShadowPass()->SetVisible(on);
}

//------------------------------------------------------------------------------
bool vtkRelievoPass::GetShadows()
{
  return this->GetShadowPass()->GetVisible();
}

//------------------------------------------------------------------------------
void vtkRelievoPass::SetDisplayLayer(const char* name)
{
  this->GetDisplay()->SetLayer(name ? name : "");
}

//------------------------------------------------------------------------------
const char* vtkRelievoPass::GetDisplayLayer()
{
  return this->GetDisplay()->GetLayerOrNull();
}

//------------------------------------------------------------------------------
void vtkRelievoPass::SetDisplayRange(double first, double last)
{
  this->GetDisplay()->SetRange(first, last);
}

//------------------------------------------------------------------------------
double* vtkRelievoPass::GetDisplayRange()
{
  return this->GetDisplay()->GetRange();
}

//------------------------------------------------------------------------------
void vtkRelievoPass::SetDisplayGrey(bool on)
{
  this->GetDisplay()->SetGrey(on);
}

//------------------------------------------------------------------------------
bool vtkRelievoPass::GetDisplayGrey()
{
  return this->GetDisplay()->GetGrey();
}
