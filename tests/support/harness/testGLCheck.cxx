// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The watch over OpenGL is silent for a plain VTK frame, and detects wrong calls, living objects
// and their bytes.
#include "Check.h"
#include "GLCheck.h"
#include "Session.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkOpenGLError.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#include <vtkTextureObject.h>

#include <chrono>
#include <iostream>
#include <string>

namespace testGLCheck
{
namespace
{
vtkSmartPointer<vtkRenderer> Sphere()
{
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  renderer->AddActor(actor);
  return renderer;
}

void TestErrors()
{
  const auto window = relievoTest::MakeWindow(64, 48, Sphere());
  relievoTest::GLCheck gl(window);
  window->Render();
  gl.Poll("after a plain frame");
  RELIEVO_CHECK(gl.Errors() == 0);

  const int wrongCall = relievoTest::FailuresOf([] { glEnable(0xffff); });
  RELIEVO_CHECK_THAT(wrongCall == 1, "a wrong call must be seen as it is made");
  RELIEVO_CHECK(relievoTest::FailuresOf([&] { gl.Poll("after a wrong call"); }) == 1);
  RELIEVO_CHECK_THAT(relievoTest::FailuresOf([&] {
    glEnable(0xffff);
    glGetError();
  }) == 1,
    "an error that is swallowed must be seen too");
  RELIEVO_CHECK(gl.Errors() == 3);

  // The picture is drawn: the sphere in the middle, the background at the corner.
  const auto picture = relievoTest::Picture(window);
  RELIEVO_CHECK(picture->GetDimensions()[0] == 64 && picture->GetDimensions()[1] == 48);
  RELIEVO_CHECK(picture->GetScalarComponentAsDouble(32, 24, 0, 0) > 100.);
  RELIEVO_CHECK(picture->GetScalarComponentAsDouble(0, 0, 0, 0) < 10.);
  RELIEVO_CHECK(relievoTest::Picture(window, true)->GetNumberOfScalarComponents() == 4);
}

// Whether the compiler's warning of a variable of this name fails the test.
int FailuresOfWarning(const std::string& name)
{
  return relievoTest::FailuresOf([&name] {
    // Mesa's disk cache emits no warnings for a known text: each run uses a new one.
    const std::string text = "#version 150\nout vec4 color;\nvoid main() { float " + name +
      "; color = vec4(" + name + "); } // " +
      std::to_string(std::chrono::system_clock::now().time_since_epoch().count());
    const char* const lines = text.c_str();
    const GLuint shader = glCreateShader(GL_FRAGMENT_SHADER);
    glShaderSource(shader, 1, &lines, nullptr);
    glCompileShader(shader);
    glDeleteShader(shader);
  });
}

void TestWarnings()
{
  const auto window = relievoTest::MakeWindow(16, 16, Sphere());
  relievoTest::GLCheck gl(window);
  RELIEVO_CHECK_THAT(FailuresOfWarning("Z") == 0, "VTK's own warnings are known");
  const char* version = reinterpret_cast<const char*>(glGetString(GL_VERSION));
  if (version && std::string(version).find("Mesa") != std::string::npos)
  {
    RELIEVO_CHECK_THAT(FailuresOfWarning("depth") == 1, "other warnings must be seen");
  }
}

void TestBytes()
{
  const auto window = relievoTest::MakeWindow(64, 48, Sphere());
  const relievoTest::GLCheck gl(window);
  window->Render();
  const relievoTest::GLObjects before = relievoTest::CountGLObjects(window);
  std::cout << "a plain frame of 64x48: " << before.ToString() << "\n";
  // At least the window's colour and depth.
  RELIEVO_CHECK(before.Bytes > 64 * 48 * 8 && before.Total() > 4);

  vtkNew<vtkTextureObject> texture;
  texture->SetContext(vtkOpenGLRenderWindow::SafeDownCast(window));
  texture->SetInternalFormat(GL_RGBA32F);
  RELIEVO_CHECK(texture->Allocate2D(100, 50, 4, VTK_FLOAT));
  const relievoTest::GLObjects during = relievoTest::CountGLObjects(window);
  RELIEVO_CHECK(during.Bytes - before.Bytes == 100 * 50 * 16);
  RELIEVO_CHECK(during.Textures == before.Textures + 1 && during.Total() == before.Total() + 1);
  texture->ReleaseGraphicsResources(window);
  RELIEVO_CHECK(relievoTest::CountGLObjects(window).Bytes == before.Bytes);
  RELIEVO_CHECK(relievoTest::CountGLObjects(window).Total() == before.Total());
}

void TestClosedWindow()
{
  auto window = relievoTest::MakeWindow(64, 48, Sphere());
  relievoTest::GLCheck first(window);
  window->Render();
  window->Finalize();
  window = nullptr;
  first.Poll("after the window has gone");
  RELIEVO_CHECK(relievoTest::FailuresOf([] { relievoTest::GLCheck none(nullptr); }) == 1);
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testGLCheck)
{
  relievoTest::Session session;
  TestErrors();
  TestWarnings();
  TestBytes();
  TestClosedWindow();
  return session.Result();
}
}
