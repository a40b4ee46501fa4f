// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoLinearDepthPass.h"

#include "vtkObjectFactory.h"
#include "vtkRelievoFrameCamera.h"
#include "vtkRelievoPass.h"
#include "vtkRenderState.h"

vtkStandardNewMacro(vtkRelievoLinearDepthPass);

//------------------------------------------------------------------------------
vtkRelievoLinearDepthPass::vtkRelievoLinearDepthPass()
{
  this->Frame->SetDisplayLayer("depth");
  this->Frame->DisplayGreyOn();
}

//------------------------------------------------------------------------------
vtkRelievoLinearDepthPass::~vtkRelievoLinearDepthPass() = default;

//------------------------------------------------------------------------------
void vtkRelievoLinearDepthPass::SetDelegatePass(vtkRenderPass* pass)
{
  if (this->Frame->GetDelegatePass() != pass)
  {
    this->Frame->SetDelegatePass(pass);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkRenderPass* vtkRelievoLinearDepthPass::GetDelegatePass()
{
  return this->Frame->GetDelegatePass();
}

//------------------------------------------------------------------------------
void vtkRelievoLinearDepthPass::Render(const vtkRenderState* s)
{
  vtkRelievoFrameCamera view;
  view.Take(s->GetRenderer(), s);
  this->Frame->SetDisplayRange(
    this->Normalized ? view.Near : this->Range[0], this->Normalized ? view.Far : this->Range[1]);
  this->Frame->Render(s);
  this->NumberOfRenderedProps = this->Frame->GetNumberOfRenderedProps();
}

//------------------------------------------------------------------------------
void vtkRelievoLinearDepthPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Frame->ReleaseGraphicsResources(window); // says that there is no window
  if (window)
  {
    this->Superclass::ReleaseGraphicsResources(window);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoLinearDepthPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Normalized: " << this->Normalized << "\n";
  os << indent << "Range: " << this->Range[0] << " " << this->Range[1] << "\n";
}
