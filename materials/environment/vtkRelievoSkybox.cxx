// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSkybox.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkRelievoEnvironment.h"
#include "vtkRelievoEnvironmentTextures.h"
#include "vtkRelievoShaderLibrary.h"
#include "vtkRelievoSpliceText.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkRelievoSkybox);

class vtkRelievoSkybox::Internals
{
public:
  struct Drawing
  {
    vtkWeakPointer<vtkOpenGLRenderWindow> Window;
    std::string Defines;
    bool Made = false; // without a quad: it does not compile
    std::unique_ptr<vtkOpenGLQuadHelper> Quad;
  };

  vtkSmartPointer<vtkRelievoEnvironment> Environment;
  std::vector<Drawing> Drawings; // by window

  // The window's program, ready for its uniforms.
  vtkOpenGLQuadHelper* Ready(vtkOpenGLRenderWindow* window, const std::string& defines)
  {
    this->Drawings.erase(std::remove_if(this->Drawings.begin(), this->Drawings.end(),
                           [](const Drawing& drawing) { return !drawing.Window; }),
      this->Drawings.end());
    auto drawing = std::find_if(this->Drawings.begin(), this->Drawings.end(),
      [window](const Drawing& one) { return one.Window == window; });
    if (drawing == this->Drawings.end())
    {
      drawing = this->Drawings.insert(this->Drawings.end(), Drawing());
      drawing->Window = window;
    }
    if (drawing->Made && drawing->Defines == defines)
    {
      if (drawing->Quad)
      {
        window->GetShaderCache()->ReadyShaderProgram(drawing->Quad->Program);
      }
      return drawing->Quad.get();
    }
    std::string fragment = vtkRelievoShaderLibrary::Get("environment/skyFS.glsl");
    vtkRelievoSpliceText::FillMark(fragment, "//RELIEVO::Defines", defines);
    const std::string vertex = vtkRelievoShaderLibrary::Get("environment/skyVS.glsl");
    drawing->Made = true;
    drawing->Defines = defines;
    drawing->Quad.reset();
    // VTK's helper assumes that its shaders compile.
    if (window->GetShaderCache()->ReadyShaderProgram(vertex.c_str(), fragment.c_str(), ""))
    {
      drawing->Quad.reset(new vtkOpenGLQuadHelper(window, vertex.c_str(), fragment.c_str(), ""));
    }
    return drawing->Quad.get();
  }
};

//------------------------------------------------------------------------------
vtkRelievoSkybox::vtkRelievoSkybox()
  : Internal(new Internals)
{
  this->PickableOff();
  this->DragableOff();
  this->UseBoundsOff();
}

//------------------------------------------------------------------------------
vtkRelievoSkybox::~vtkRelievoSkybox() = default;

//------------------------------------------------------------------------------
void vtkRelievoSkybox::SetEnvironment(vtkRelievoEnvironment* environment)
{
  if (this->Internal->Environment != environment)
  {
    this->Internal->Environment = environment;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkRelievoEnvironment* vtkRelievoSkybox::GetEnvironment()
{
  return this->Internal->Environment;
}

//------------------------------------------------------------------------------
void vtkRelievoSkybox::GetScreenToEnvironment(vtkRenderer* renderer, vtkMatrix3x3* matrix)
{
  if (!renderer || !renderer->GetRenderWindow() || !matrix)
  {
    vtkErrorMacro(
      "GetScreenToEnvironment was given " << (!matrix ? "no matrix; give it a vtkMatrix3x3 to fill."
          : renderer ? "a renderer without a window; add it to a vtkRenderWindow."
                     : "no renderer; give it one that is in a vtkRenderWindow."));
    return;
  }
  vtkCamera* camera = renderer->GetActiveCamera();
  vtkMatrix4x4* toView = camera->GetModelViewTransformMatrix();
  vtkNew<vtkMatrix4x4> toNDC;
  toNDC->DeepCopy(camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1, 1));
  vtkNew<vtkMatrix3x3> toWorld;
  if (camera->GetParallelProjection())
  {
    int tile[2];
    renderer->GetTiledSize(&tile[0], &tile[1]);
    const double half = std::tan(vtkMath::RadiansFromDegrees(0.5 * this->ParallelViewAngle)) /
      (static_cast<double>(renderer->GetSize()[1]) / tile[1]);
    const double wide = half * toNDC->GetElement(1, 1) / toNDC->GetElement(0, 0);
    const double center[2] = { -toNDC->GetElement(0, 3), -toNDC->GetElement(1, 3) };
    const double inView[9] = { wide, 0., center[0] * wide, 0., half, center[1] * half, 0., 0.,
      -1. };
    vtkNew<vtkMatrix3x3> screenToView;
    screenToView->DeepCopy(inView);
    for (int i = 0; i < 9; ++i)
    {
      toWorld->SetElement(i / 3, i % 3, toView->GetElement(i / 3, i % 3));
    }
    toWorld->Invert();
    vtkMatrix3x3::Multiply3x3(toWorld, screenToView, toWorld);
  }
  else
  {
    // A direction d is seen where (x, y, 1) w = A d, with the rows of x, y and w; the rest of the
    // matrices (near, far and the eye's position) has no influence.
    vtkNew<vtkMatrix4x4> worldToNDC;
    vtkMatrix4x4::Multiply4x4(toNDC, toView, worldToNDC);
    for (int i = 0; i < 9; ++i)
    {
      toWorld->SetElement(i / 3, i % 3, worldToNDC->GetElement(i < 6 ? i / 3 : 3, i % 3));
    }
    toWorld->Invert();
  }
  // The renderer's axes, in the convention of VTK's mappers.
  double right[3];
  double up[3];
  double front[3];
  renderer->GetEnvironmentRight(right);
  renderer->GetEnvironmentUp(up);
  vtkMath::Cross(right, up, front);
  vtkNew<vtkMatrix3x3> turned;
  for (int j = 0; j < 3; ++j)
  {
    turned->SetElement(0, j, right[j]);
    turned->SetElement(1, j, up[j]);
    turned->SetElement(2, j, front[j]);
  }
  vtkMatrix3x3::Multiply3x3(turned, toWorld, matrix);
  if (this->Internal->Environment)
  {
    vtkNew<vtkMatrix3x3> rotation;
    this->Internal->Environment->GetWorldToEnvironment(rotation);
    vtkMatrix3x3::Multiply3x3(rotation, matrix, matrix);
  }
}

//------------------------------------------------------------------------------
int vtkRelievoSkybox::RenderOpaqueGeometry(vtkViewport* viewport)
{
  Internals& in = *this->Internal;
  auto* renderer = vtkRenderer::SafeDownCast(viewport);
  auto* window =
    vtkOpenGLRenderWindow::SafeDownCast(renderer ? renderer->GetRenderWindow() : nullptr);
  if (!window || !in.Environment || renderer->GetSelector())
  {
    return 0;
  }
  auto& textures = vtkRelievoEnvironmentTextures::Of(in.Environment);
  auto structure = textures.GetStructure();
  if (!structure.Projection)
  {
    return 0;
  }
  structure.Irradiance = false;
  structure.Rough = structure.Rough && this->Roughness > 0.0;
  vtkOpenGLQuadHelper* quad = in.Ready(window, structure.GetDefines());
  vtkShaderProgram* program = quad ? quad->Program : nullptr;
  if (!program || !program->GetCompiled() || !textures.Activate(window, program, this->Roughness))
  {
    return 0;
  }
  vtkNew<vtkMatrix3x3> matrix;
  this->GetScreenToEnvironment(renderer, matrix);
  // The length is arbitrary: dividing by the greatest element makes the numbers fit floats.
  double greatest = 0.0;
  for (int i = 0; i < 9; ++i)
  {
    greatest = std::max(greatest, std::abs(matrix->GetData()[i]));
  }
  float columns[9];
  for (int i = 0; i < 9; ++i)
  {
    columns[i] = static_cast<float>(matrix->GetElement(i % 3, i / 3) / greatest);
  }
  program->SetUniformMatrix3x3("relievoEnvironmentFromScreen", columns);
  program->SetUniformf("relievoIntensity", static_cast<float>(in.Environment->GetIntensity()));

  vtkOpenGLState* state = window->GetState();
  // State by state: vtkOpenGLState::Push would save buffers that mappers have deleted but left
  // bound.
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  vtkOpenGLState::ScopedglEnableDisable cull(state, GL_CULL_FACE);
  vtkOpenGLState::ScopedglEnableDisable test(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglDepthFunc function(state);
  vtkOpenGLState::ScopedglDepthMask mask(state);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglDepthMask(GL_FALSE);
  quad->Render();
  textures.Deactivate(window);
  return 1;
}

//------------------------------------------------------------------------------
void vtkRelievoSkybox::ReleaseGraphicsResources(vtkWindow* window)
{
  Internals& in = *this->Internal;
  for (Internals::Drawing& drawing : in.Drawings)
  {
    if (drawing.Window && (!window || drawing.Window == window))
    {
      if (drawing.Quad)
      {
        drawing.Quad->ReleaseGraphicsResources(drawing.Window);
        drawing.Quad.reset();
      }
      drawing.Made = false;
    }
  }
  if (in.Environment)
  {
    in.Environment->ReleaseGraphicsResources(window);
  }
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkRelievoSkybox::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Environment: " << this->GetEnvironment() << "\n";
  os << indent << "Roughness: " << this->Roughness << "\n";
  os << indent << "ParallelViewAngle: " << this->ParallelViewAngle << "\n";
}
