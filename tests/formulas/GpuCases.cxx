// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GpuCases.h"

#include "Check.h"
#include "GLCheck.h"
#include "Window.h"
#include "vtkRelievoShaderLibrary.h"

#include <vtkNew.h>
#include <vtkOpenGLError.h> // for the OpenGL symbols
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLQuadHelper.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkOpenGLState.h>
#include <vtkPixelBufferObject.h>
#include <vtkRenderWindow.h>
#include <vtkShaderProgram.h>
#include <vtkSmartPointer.h>
#include <vtkTextureObject.h>

#include <fstream>
#include <sstream>
#include <string>

namespace relievoTest
{
namespace
{
constexpr unsigned int Width = 256;

std::string ReadTestShader(const std::string& name)
{
  std::ifstream file(std::string(RELIEVO_FORMULA_TESTS) + "/" + name);
  std::ostringstream text;
  text << file.rdbuf();
  RELIEVO_CHECK_THAT(!text.str().empty(), "cannot read tests/formulas/" + name);
  return text.str();
}

std::string FragmentShader()
{
  std::string shader = ReadTestShader("casesFS.glsl");
  vtkShaderProgram::Substitute(shader, "//RELIEVO::Extensions",
    vtkRelievoShaderLibrary::Get("extensions.glsl") + vtkRelievoShaderLibrary::Get("exact.glsl"));
  // normal_depth.glsl takes in the files below it.
  vtkShaderProgram::Substitute(shader, "//RELIEVO::Formulas",
    vtkRelievoShaderLibrary::Get("formulas/formats/normal_depth.glsl") +
      vtkRelievoShaderLibrary::Get("formulas/geometry/unproject.glsl") +
      vtkRelievoShaderLibrary::Get("formulas/color/srgb.glsl") +
      vtkRelievoShaderLibrary::Get("formulas/color/tone.glsl") +
      vtkRelievoShaderLibrary::Get("formulas/color/hash_color.glsl") +
      vtkRelievoShaderLibrary::Get("formulas/color/colormap.glsl") +
      vtkRelievoShaderLibrary::Get("formulas/light/environment.glsl") +
      vtkRelievoShaderLibrary::Get("formulas/light/irradiance.glsl") +
      vtkRelievoShaderLibrary::Get("formulas/light/fresnel.glsl") +
      vtkRelievoShaderLibrary::Get("formulas/light/prefilter.glsl") +
      vtkRelievoShaderLibrary::Get("formulas/light/fog.glsl") +
      vtkRelievoShaderLibrary::Get("formulas/geometry/noise.glsl") +
      vtkRelievoShaderLibrary::Get("formulas/geometry/skin.glsl") +
      vtkRelievoShaderLibrary::Get("rays/leaves.glsl"));
  vtkShaderProgram::Substitute(shader, "//RELIEVO::Cases", ReadTestShader("cases.glsl"));
  return shader;
}

vtkSmartPointer<vtkTextureObject> NewWordTexture(vtkOpenGLRenderWindow* window)
{
  auto texture = vtkSmartPointer<vtkTextureObject>::New();
  texture->SetContext(window);
  texture->SetInternalFormat(GL_RGBA32UI);
  texture->SetFormat(GL_RGBA_INTEGER);
  texture->SetDataType(GL_UNSIGNED_INT);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  return texture;
}
}

struct GpuCases::Internals
{
  vtkSmartPointer<vtkOpenGLRenderWindow> Window;
  std::unique_ptr<GLCheck> Watch;
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
};

//------------------------------------------------------------------------------
GpuCases::GpuCases()
  : Internal(new Internals)
{
  const vtkSmartPointer<vtkRenderWindow> window = MakeWindow(16, 16);
  this->Internal->Window = vtkOpenGLRenderWindow::SafeDownCast(window);
  if (!RELIEVO_CHECK_THAT(this->Internal->Window, "VTK made no OpenGL window"))
  {
    return;
  }
  this->Internal->Watch.reset(new GLCheck(window));
  this->Internal->Quad.reset(
    new vtkOpenGLQuadHelper(this->Internal->Window, nullptr, FragmentShader().c_str(), nullptr));
  RELIEVO_CHECK_THAT(this->IsValid(), "casesFS.glsl does not compile with the formulas");
}

//------------------------------------------------------------------------------
GpuCases::~GpuCases()
{
  if (this->Internal->Window)
  {
    this->Internal->Window->MakeCurrent();
  }
  this->Internal->Quad.reset();
  this->Internal->Watch.reset();
}

//------------------------------------------------------------------------------
bool GpuCases::IsValid() const
{
  return this->Internal->Quad && this->Internal->Quad->Program &&
    this->Internal->Quad->Program->GetCompiled();
}

//------------------------------------------------------------------------------
std::vector<glm::uvec4> GpuCases::Run(int which, const std::vector<CaseInput>& inputs)
{
  if (!this->IsValid() || inputs.empty())
  {
    return {};
  }
  const unsigned int rows = static_cast<unsigned int>((inputs.size() + Width - 1) / Width);
  std::vector<glm::uvec4> a(std::size_t(rows) * Width, glm::uvec4(0));
  std::vector<glm::uvec4> b(a);
  for (std::size_t i = 0; i < inputs.size(); ++i)
  {
    a[i] = inputs[i].A;
    b[i] = inputs[i].B;
  }
  vtkOpenGLRenderWindow* window = this->Internal->Window;
  window->MakeCurrent();
  auto textureA = NewWordTexture(window);
  auto textureB = NewWordTexture(window);
  auto output = NewWordTexture(window);
  textureA->Create2DFromRaw(Width, rows, 4, VTK_UNSIGNED_INT, a.data());
  textureB->Create2DFromRaw(Width, rows, 4, VTK_UNSIGNED_INT, b.data());
  output->Allocate2D(Width, rows, 4, VTK_UNSIGNED_INT);

  vtkOpenGLState* state = window->GetState();
  vtkNew<vtkOpenGLFramebufferObject> frame;
  frame->SetContext(window);
  state->PushFramebufferBindings();
  frame->Bind();
  frame->AddColorAttachment(0, output);
  frame->ActivateDrawBuffer(0);
  frame->Start(static_cast<int>(Width), static_cast<int>(rows));
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_SCISSOR_TEST);

  vtkShaderProgram* program = this->Internal->Quad->Program;
  window->GetShaderCache()->ReadyShaderProgram(program);
  textureA->Activate();
  textureB->Activate();
  program->SetUniformi("inputA", textureA->GetTextureUnit());
  program->SetUniformi("inputB", textureB->GetTextureUnit());
  program->SetUniformi("whichCase", which);
  this->Internal->Quad->Render();
  textureA->Deactivate();
  textureB->Deactivate();
  state->PopFramebufferBindings();

  vtkSmartPointer<vtkPixelBufferObject> buffer;
  buffer.TakeReference(output->Download());
  const bool downloaded = buffer != nullptr;
  std::vector<glm::uvec4> results(a.size());
  if (downloaded)
  {
    unsigned int size[2] = { Width, rows };
    vtkIdType increments[2] = { 0, 0 };
    buffer->Download2D(VTK_UNSIGNED_INT, results.data(), size, 4, increments);
  }
  results.resize(inputs.size());
  frame->ReleaseGraphicsResources(window);
  textureA->ReleaseGraphicsResources(window);
  textureB->ReleaseGraphicsResources(window);
  output->ReleaseGraphicsResources(window);
  const std::string place = "in case " + std::to_string(which);
  this->Internal->Watch->Poll(place);
  return RELIEVO_CHECK_THAT(downloaded, "no words came back " + place) ? results
                                                                       : std::vector<glm::uvec4>();
}
}
