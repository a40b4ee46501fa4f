// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Short ways to the stages that every vtkRelievoPass has.
#include "vtkRelievoDisplayStage.h"
#include "vtkRelievoFogStage.h"
#include "vtkRelievoGBufferPass.h"
#include "vtkRelievoMarkersStage.h"
#include "vtkRelievoPass.h"
#include "vtkRelievoShadowPass.h"
#include "vtkRelievoToneStage.h"

namespace
{
template <typename Stage>
Stage* Find(vtkRelievoFramePass* frame, const char* name)
{
  return Stage::SafeDownCast(frame->GetStage(name));
}

// A frame may have another class's stage of that name (AddStage), or none.
template <typename Stage>
Stage* FindToSet(vtkRelievoPass* frame, Stage* stage, const char* name)
{
  if (!stage)
  {
    vtkErrorWithObjectMacro(frame,
      "The stage '" << name << "' of this frame is not Relievo's own, and keeps what it is set to; "
                    << "use its own methods, or SetParameter.");
  }
  return stage;
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
vtkRelievoToneStage* vtkRelievoPass::GetTone()
{
  return Find<vtkRelievoToneStage>(this, "tone");
}

//------------------------------------------------------------------------------
vtkRelievoFogStage* vtkRelievoPass::GetFog()
{
  return Find<vtkRelievoFogStage>(this, "fog");
}

//------------------------------------------------------------------------------
vtkRelievoMarkersStage* vtkRelievoPass::GetMarkers()
{
  return Find<vtkRelievoMarkersStage>(this, "markers");
}

//------------------------------------------------------------------------------
vtkRelievoDisplayStage* vtkRelievoPass::GetDisplay()
{
  return Find<vtkRelievoDisplayStage>(this, "display");
}

//------------------------------------------------------------------------------
void vtkRelievoPass::SetShadows(bool on)
{
  if (auto* shadows = FindToSet(this, this->GetShadowPass(), "shadows"))
  {
    shadows->SetVisible(on);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoPass::SetDeferred(bool on)
{
  if (vtkRelievoStage* deferred = FindToSet(this, this->GetStage("deferred"), "deferred"))
  {
    deferred->SetEnabled(on);
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoPass::GetDeferred()
{
  vtkRelievoStage* deferred = this->GetStage("deferred");
  return deferred && deferred->GetEnabled();
}

//------------------------------------------------------------------------------
bool vtkRelievoPass::GetShadows()
{
  vtkRelievoShadowPass* shadows = this->GetShadowPass();
  return shadows && shadows->GetVisible();
}

//------------------------------------------------------------------------------
void vtkRelievoPass::SetDisplayLayer(const char* name)
{
  if (auto* display = FindToSet(this, this->GetDisplay(), "display"))
  {
    display->SetLayer(name ? name : "");
  }
}

//------------------------------------------------------------------------------
const char* vtkRelievoPass::GetDisplayLayer()
{
  vtkRelievoDisplayStage* display = this->GetDisplay();
  return display ? display->GetLayerOrNull() : nullptr;
}

//------------------------------------------------------------------------------
void vtkRelievoPass::SetDisplayRange(double first, double last)
{
  if (auto* display = FindToSet(this, this->GetDisplay(), "display"))
  {
    display->SetRange(first, last);
  }
}

//------------------------------------------------------------------------------
double* vtkRelievoPass::GetDisplayRange()
{
  static double none[2] = { 0.0, 0.0 };
  vtkRelievoDisplayStage* display = this->GetDisplay();
  return display ? display->GetRange() : none;
}

//------------------------------------------------------------------------------
void vtkRelievoPass::SetDisplayGrey(bool on)
{
  if (auto* display = FindToSet(this, this->GetDisplay(), "display"))
  {
    display->SetGrey(on);
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoPass::GetDisplayGrey()
{
  vtkRelievoDisplayStage* display = this->GetDisplay();
  return display && display->GetGrey();
}
