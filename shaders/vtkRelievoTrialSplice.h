// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Splices text into a mapper's shaders, and reverts it if they do not compile: VTK's mappers draw
// without a program, or crash, if theirs does not compile.
#ifndef vtkRelievoTrialSplice_h
#define vtkRelievoTrialSplice_h

#include "vtkNew.h"
#include "vtkObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLShaderProperty.h"
#include "vtkShader.h"
#include "vtkShaderProgram.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <array>
#include <map>
#include <string>

// The texts of a shader program that is being built.
struct vtkRelievoShaderTexts
{
  std::string& Vertex;
  std::string& Geometry;
  std::string& Fragment;
};

namespace vtkRelievoTrialSplice
{
// An error message (empty: none), and whether the error is that the shaders do not compile.
struct Outcome
{
  std::string Error;
  bool Compiles = true;

  // Key for reporting once: the compiler's messages differ from shader to shader.
  std::string GetKey(vtkObject* mapper) const
  {
    return mapper->GetClassName() + (this->Compiles ? this->Error : "compiles not");
  }
};

// The last texts that compiled in this thread's window: those of many objects are equal, and VTK
// would compute the checksum of each again.
class Compiled
{
public:
  using Texts = std::array<std::string, 3>;

  static bool Has(vtkOpenGLRenderWindow* window, const Texts& texts)
  {
    const Compiled& last = Get();
    return last.Window == window &&
      std::find(last.Last.begin(), last.Last.end(), texts) != last.Last.end();
  }

  static void Add(vtkOpenGLRenderWindow* window, const Texts& texts)
  {
    Compiled& last = Get();
    if (last.Window != window)
    {
      last = Compiled();
      last.Window = window;
    }
    last.Last[last.Next] = texts;
    last.Next = (last.Next + 1) % last.Last.size();
  }

private:
  static Compiled& Get()
  {
    thread_local Compiled last;
    return last;
  }

  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  std::array<Texts, 8> Last;
  std::size_t Next = 0;
};

// Returns an error message, or an empty string if OpenGL accepts the shaders. The user's
// replacements, which VTK makes last, are included in the trial. The program stays in the window's
// cache, where VTK finds it if the shaders do not change any more.
inline std::string Compile(vtkOpenGLRenderWindow* window, vtkShaderProperty* property,
  std::string vertex, std::string geometry, std::string fragment)
{
  if (auto* users = vtkOpenGLShaderProperty::SafeDownCast(property))
  {
    for (const auto& each : users->GetAllShaderReplacements())
    {
      if (!each.first.ReplaceFirst)
      {
        std::string& source = each.first.ShaderType == vtkShader::Vertex ? vertex
          : each.first.ShaderType == vtkShader::Geometry                 ? geometry
                                                                         : fragment;
        vtkShaderProgram::Substitute(
          source, each.first.OriginalValue, each.second.Replacement, each.second.ReplaceAll);
      }
    }
  }
  const Compiled::Texts texts = { vertex, geometry, fragment };
  if (Compiled::Has(window, texts))
  {
    return std::string();
  }
  vtkNew<vtkShader> shaders[3];
  std::map<vtkShader::Type, vtkShader*> byType;
  auto add = [&](vtkShader* shader, vtkShader::Type type, const std::string& source) {
    shader->SetType(type);
    shader->SetSource(source);
    byType[type] = shader;
  };
  add(shaders[0], vtkShader::Vertex, vertex);
  add(shaders[1], vtkShader::Geometry, geometry);
  add(shaders[2], vtkShader::Fragment, fragment);
  // VTK prints the whole source with the error.
  const int display = vtkObject::GetGlobalWarningDisplay();
  vtkObject::GlobalWarningDisplayOff();
  const bool compiles = window->GetShaderCache()->ReadyShaderProgram(byType) != nullptr;
  vtkObject::SetGlobalWarningDisplay(display);
  if (compiles)
  {
    Compiled::Add(window, texts);
    return std::string();
  }
  for (const auto& shader : shaders)
  {
    if (!shader->GetError().empty())
    {
      const std::string log = shader->GetError();
      return "its shaders do not compile with them: " + log.substr(0, log.find('\n'));
    }
  }
  return "its shaders do not link with them";
}

// Fills the texts by `fill`, which returns an error message or an empty string. On an error they
// remain unchanged. Without a window, or if nothing was filled, nothing is compiled.
template <typename Fill>
Outcome Try(const vtkRelievoShaderTexts& texts, vtkOpenGLRenderWindow* window,
  vtkShaderProperty* property, const Fill& fill)
{
  const std::string vertex = texts.Vertex;
  const std::string geometry = texts.Geometry;
  const std::string fragment = texts.Fragment;
  Outcome outcome;
  outcome.Error = fill();
  const bool changed =
    texts.Vertex != vertex || texts.Geometry != geometry || texts.Fragment != fragment;
  if (outcome.Error.empty() && window && changed)
  {
    outcome.Error = Compile(window, property, texts.Vertex, texts.Geometry, texts.Fragment);
    outcome.Compiles = outcome.Error.empty();
  }
  if (!outcome.Error.empty())
  {
    texts.Vertex = vertex;
    texts.Geometry = geometry;
    texts.Fragment = fragment;
  }
  return outcome;
}
}

#endif
