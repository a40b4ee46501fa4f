// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoFrameCamera.h"

#include "vtkCamera.h"
#include "vtkFrameBufferObjectBase.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"

//------------------------------------------------------------------------------
glm::mat4 vtkRelievoFrameCamera::GetProjection() const
{
  return glm::mat4(this->ViewToNDC);
}

//------------------------------------------------------------------------------
glm::mat4 vtkRelievoFrameCamera::GetViewToWorld() const
{
  return glm::mat4(glm::inverse(this->WorldToView));
}

//------------------------------------------------------------------------------
double vtkRelievoFrameCamera::GetWinding() const
{
  return glm::determinant(glm::dmat3(this->WorldToView)) *
    glm::determinant(glm::dmat2(this->ViewToNDC));
}

//------------------------------------------------------------------------------
void vtkRelievoFrameCamera::Take(vtkRenderer* renderer, const vtkRenderState* s)
{
  vtkFrameBufferObjectBase* framebuffer = s ? s->GetFrameBuffer() : nullptr;
  this->Viewport[0] = this->Viewport[1] = 0;
  if (framebuffer)
  {
    framebuffer->GetLastSize(this->Viewport[2], this->Viewport[3]);
  }
  else
  {
    renderer->GetTiledSizeAndOrigin(
      &this->Viewport[2], &this->Viewport[3], &this->Viewport[0], &this->Viewport[1]);
  }
  vtkCamera* camera = renderer->GetActiveCamera();
  double range[2];
  camera->GetClippingRange(range);
  this->Near = range[0];
  this->Far = range[1];
  this->Parallel = camera->GetParallelProjection() != 0;
  this->WorldToView = vtkRelievoToGlm(camera->GetModelViewTransformMatrix());
  this->ViewToNDC = vtkRelievoToGlm(
    camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0));
}
