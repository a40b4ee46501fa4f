// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoPass.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRelievoBuiltInStages.h"
#include "vtkRelievoDisplayStage.h"
#include "vtkRelievoFogStage.h"
#include "vtkRelievoLayersStage.h"
#include "vtkRelievoMarkersStage.h"
#include "vtkRelievoShadowStage.h"
#include "vtkRelievoToneStage.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

vtkStandardNewMacro(vtkRelievoPass);

//------------------------------------------------------------------------------
vtkRelievoPass::vtkRelievoPass()
{
  vtkRelievoAddBuiltInStages();
  this->AddRegisteredStages();
}

//------------------------------------------------------------------------------
vtkRelievoPass::~vtkRelievoPass() = default;

//------------------------------------------------------------------------------
void vtkRelievoPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const char* shown = this->GetDisplayLayer();
  os << indent << "Shadows: " << this->GetShadows() << "\n";
  os << indent << "Deferred: " << this->GetDeferred() << "\n";
  os << indent << "DisplayLayer: " << (shown ? shown : "(none)") << "\n";
  os << indent << "DisplayRange: " << this->GetDisplayRange()[0] << " "
     << this->GetDisplayRange()[1] << "\n";
  os << indent << "DisplayGrey: " << this->GetDisplayGrey() << "\n";
}

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
      "The stage '" << name << "' of this frame is not Relievo's own, and keeps its settings; "
                    << "use its own methods, or SetParameter.");
  }
  return stage;
}
}

//------------------------------------------------------------------------------
vtkRelievoLayersStage* vtkRelievoPass::GetLayersStage()
{
  return Find<vtkRelievoLayersStage>(this, "gbuffer");
}

//------------------------------------------------------------------------------
vtkRelievoShadowStage* vtkRelievoPass::GetShadowStage()
{
  return Find<vtkRelievoShadowStage>(this, "shadows");
}

//------------------------------------------------------------------------------
vtkRelievoToneStage* vtkRelievoPass::GetToneStage()
{
  return Find<vtkRelievoToneStage>(this, "tone");
}

//------------------------------------------------------------------------------
vtkRelievoFogStage* vtkRelievoPass::GetFogStage()
{
  return Find<vtkRelievoFogStage>(this, "fog");
}

//------------------------------------------------------------------------------
vtkRelievoMarkersStage* vtkRelievoPass::GetMarkersStage()
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
  if (auto* shadows = FindToSet(this, this->GetShadowStage(), "shadows"))
  {
    shadows->SetEnabled(on);
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
  vtkRelievoShadowStage* shadows = this->GetShadowStage();
  return shadows && shadows->GetEnabled();
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
