// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Every file of shaders/formulas/ compiles by itself as GLSL 1.50 with shaders/extensions.glsl, and
// stands in vtkRelievoFormulaFiles.h, so that C++ has it too.
#include "Check.h"
#include "Session.h"
#include "TestCase.h"
#include "Window.h"
#include "vtkRelievoShaderLibrary.h"

#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkShader.h>

#include <fstream>
#include <sstream>
#include <string>

namespace testFormulasCompile
{
namespace
{
bool Compiles(const std::string& formulas, std::string& error)
{
  const std::string source = "#version 150\n" + vtkRelievoShaderLibrary::Get("extensions.glsl") +
    formulas + "\nvoid main()\n{\n}\n";
  vtkNew<vtkShader> shader;
  shader->SetType(vtkShader::Fragment);
  shader->SetSource(source);
  const bool compiled = shader->Compile();
  error = shader->GetError();
  shader->Cleanup();
  return compiled;
}

std::string Read(const std::string& path)
{
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testFormulasCompile)
{
  relievoTest::Session session;
  {
    const vtkSmartPointer<vtkRenderWindow> window = relievoTest::MakeWindow(16, 16);
    window->Start(); // makes the context and loads OpenGL's functions
    const std::string list = Read(RELIEVO_FORMULA_FILES);
    std::string error;
    int files = 0;
    for (int i = 0; i < vtkRelievoShaderLibrary::GetNumberOfSources(); ++i)
    {
      const std::string name = vtkRelievoShaderLibrary::GetName(i);
      if (name.compare(0, 9, "formulas/") != 0)
      {
        continue;
      }
      ++files;
      const bool compiled = Compiles(vtkRelievoShaderLibrary::Get(name), error);
      RELIEVO_CHECK_THAT(compiled, name + " does not compile: " + error);
      RELIEVO_CHECK_THAT(list.find("\"" + name + "\"") != std::string::npos,
        name + " is not in vtkRelievoFormulaFiles.h");
    }
    RELIEVO_CHECK(files >= 9);
    // The compiler does complain where there is something to complain about.
    RELIEVO_CHECK(!Compiles("float relievoBroken() { return vec2(1.0); }", error));
  }
  return session.Result();
}
}
