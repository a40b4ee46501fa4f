// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Puts text into a mapper's shaders, and takes it back if they do not compile: VTK's mappers
// draw without a program, or crash, when theirs does not.
#ifndef vtkRelievoTrialSplice_h
#define vtkRelievoTrialSplice_h

#include "vtkNew.h"
#include "vtkObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLShaderProperty.h"
#include "vtkShader.h"
#include "vtkShaderProgram.h"

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
// What is wrong, in words (empty: nothing), and whether it is that the shaders do not compile.
struct Outcome
{
  std::string Wrong;
  bool Compiles = true;

  // For reporting once: the compiler's words differ from shader to shader.
  std::string GetKey(vtkObject* mapper) const
  {
    return mapper->GetClassName() + (this->Compiles ? this->Wrong : "compiles not");
  }
};

// What is wrong with the shaders, in words; empty if OpenGL takes them. The user's replacements
// that VTK makes last are made in the trial as well. The program stays in the window's cache, where
// VTK finds it if nothing else changes the shaders.
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
  // VTK prints the whole text beside what is wrong with it.
  const int display = vtkObject::GetGlobalWarningDisplay();
  vtkObject::GlobalWarningDisplayOff();
  const bool compiles = window->GetShaderCache()->ReadyShaderProgram(byType) != nullptr;
  vtkObject::SetGlobalWarningDisplay(display);
  if (compiles)
  {
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

// Fills the texts by `fill`, which returns what is wrong. If anything is, they stay. Without
// a window, and where nothing was filled, nothing is compiled.
template <typename Fill>
Outcome Try(const vtkRelievoShaderTexts& texts, vtkOpenGLRenderWindow* window,
  vtkShaderProperty* property, const Fill& fill)
{
  const std::string vertex = texts.Vertex;
  const std::string geometry = texts.Geometry;
  const std::string fragment = texts.Fragment;
  Outcome outcome;
  outcome.Wrong = fill();
  const bool changed =
    texts.Vertex != vertex || texts.Geometry != geometry || texts.Fragment != fragment;
  if (outcome.Wrong.empty() && window && changed)
  {
    outcome.Wrong = Compile(window, property, texts.Vertex, texts.Geometry, texts.Fragment);
    outcome.Compiles = outcome.Wrong.empty();
  }
  if (!outcome.Wrong.empty())
  {
    texts.Vertex = vertex;
    texts.Geometry = geometry;
    texts.Fragment = fragment;
  }
  return outcome;
}
}

#endif
