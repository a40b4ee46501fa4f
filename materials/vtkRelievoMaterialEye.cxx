// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoMaterialEye.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkProp.h"
#include "vtkRelievoFormulas.h" // for GLM
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

//------------------------------------------------------------------------------
vtkRenderer* vtkRelievoMaterialEye::FindRenderer(vtkProp* prop)
{
  for (int i = 0; prop && i < prop->GetNumberOfConsumers(); ++i)
  {
    vtkObject* consumer = prop->GetConsumer(i);
    auto* renderer = vtkRenderer::SafeDownCast(consumer);
    renderer = renderer ? renderer : FindRenderer(vtkProp::SafeDownCast(consumer));
    auto* window =
      vtkOpenGLRenderWindow::SafeDownCast(renderer ? renderer->GetRenderWindow() : nullptr);
    if (window && window->IsCurrent())
    {
      return renderer;
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
void vtkRelievoMaterialEye::SetParameters(vtkShaderProgram* program, vtkRenderer* renderer)
{
  if (!program->IsUniformUsed("relievoEyeVC") && !program->IsUniformUsed("relievoTowardsEyeVC"))
  {
    return;
  }
  glm::vec3 eye(0.f);
  glm::vec3 towards(0.f, 0.f, 1.f);
  if (renderer)
  {
    // The eye is the point that the rows of x, y and w map to 0: it has no pixel of its own.
    vtkCamera* camera = renderer->GetActiveCamera();
    vtkMatrix4x4* toNDC =
      camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1., 1.);
    auto row = [toNDC](int i) {
      return glm::dvec3(toNDC->GetElement(i, 0), toNDC->GetElement(i, 1), toNDC->GetElement(i, 2));
    };
    if (camera->GetParallelProjection())
    {
      const glm::dvec3 across = glm::normalize(glm::cross(row(0), row(1)));
      towards = glm::vec3(across.z < 0. ? -across : across);
    }
    else
    {
      const glm::dmat3 rows = glm::transpose(glm::dmat3(row(0), row(1), row(3)));
      const glm::dvec3 ends(
        toNDC->GetElement(0, 3), toNDC->GetElement(1, 3), toNDC->GetElement(3, 3));
      eye = glm::vec3(-glm::inverse(rows) * ends);
    }
  }
  program->SetUniform3f("relievoEyeVC", &eye.x);
  program->SetUniform3f("relievoTowardsEyeVC", &towards.x);
}
