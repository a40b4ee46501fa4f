// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CubeLookup.h"

#include "Check.h"
#include "GLCheck.h"
#include "Window.h"

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

#include <cmath>
#include <fstream>
#include <sstream>
#include <string>

namespace relievoTest
{
namespace
{
constexpr unsigned int Width = 256;

std::string FragmentShader()
{
  std::ifstream file(std::string(RELIEVO_FORMULA_TESTS) + "/cubeLookupFS.glsl");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

// Each texel holds its own face, column and row.
void FillCube(vtkTextureObject* texture, int size)
{
  std::vector<std::vector<float>> faces(6);
  void* data[6];
  for (int face = 0; face < 6; ++face)
  {
    for (int j = 0; j < size; ++j)
    {
      for (int i = 0; i < size; ++i)
      {
        faces[face].insert(faces[face].end(), { float(face), float(i), float(j), 1.f });
      }
    }
    data[face] = faces[face].data();
  }
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  texture->SetWrapR(vtkTextureObject::ClampToEdge);
  texture->CreateCubeFromRaw(size, size, 4, VTK_FLOAT, data);
}
}

//------------------------------------------------------------------------------
std::vector<CubeTexel> LookUpCube(int size, const std::vector<glm::vec3>& directions)
{
  const vtkSmartPointer<vtkRenderWindow> made = MakeWindow(16, 16);
  vtkOpenGLRenderWindow* window = vtkOpenGLRenderWindow::SafeDownCast(made);
  if (!RELIEVO_CHECK_THAT(window, "VTK made no OpenGL window"))
  {
    return {};
  }
  GLCheck watch(made);
  vtkOpenGLQuadHelper quad(window, nullptr, FragmentShader().c_str(), nullptr);
  if (!RELIEVO_CHECK_THAT(quad.Program && quad.Program->GetCompiled(), "cubeLookupFS.glsl"))
  {
    return {};
  }
  const unsigned int rows = static_cast<unsigned int>((directions.size() + Width - 1) / Width);
  std::vector<float> input(std::size_t(rows) * Width * 4, 1.f);
  for (std::size_t i = 0; i < directions.size(); ++i)
  {
    input[4 * i] = directions[i].x;
    input[4 * i + 1] = directions[i].y;
    input[4 * i + 2] = directions[i].z;
  }
  vtkNew<vtkTextureObject> cube;
  vtkNew<vtkTextureObject> places;
  vtkNew<vtkTextureObject> output;
  cube->SetContext(window);
  places->SetContext(window);
  output->SetContext(window);
  FillCube(cube, size);
  places->Create2DFromRaw(Width, rows, 4, VTK_FLOAT, input.data());
  output->Allocate2D(Width, rows, 4, VTK_FLOAT);

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
  window->GetShaderCache()->ReadyShaderProgram(quad.Program);
  cube->Activate();
  places->Activate();
  quad.Program->SetUniformi("cube", cube->GetTextureUnit());
  quad.Program->SetUniformi("directions", places->GetTextureUnit());
  quad.Render();
  cube->Deactivate();
  places->Deactivate();
  state->PopFramebufferBindings();

  std::vector<float> words(input.size());
  vtkSmartPointer<vtkPixelBufferObject> buffer;
  buffer.TakeReference(output->Download());
  if (RELIEVO_CHECK_THAT(buffer, "no texels came back"))
  {
    unsigned int extent[2] = { Width, rows };
    vtkIdType increments[2] = { 0, 0 };
    buffer->Download2D(VTK_FLOAT, words.data(), extent, 4, increments);
  }
  for (vtkTextureObject* texture : { cube.Get(), places.Get(), output.Get() })
  {
    texture->ReleaseGraphicsResources(window);
  }
  frame->ReleaseGraphicsResources(window);
  watch.Poll("looking up a cube map");

  std::vector<CubeTexel> texels;
  for (std::size_t i = 0; i < directions.size(); ++i)
  {
    const auto whole = [&words, i](int c) { return int(std::lround(words[4 * i + c])); };
    texels.push_back({ whole(0), whole(1), whole(2) });
  }
  return texels;
}
}
