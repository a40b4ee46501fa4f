// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoPlainActor.h"

#include "vtkActor.h"
#include "vtkShaderProperty.h"

#include <set>

namespace
{
std::set<std::string>& GetPlainClasses()
{
  static std::set<std::string> classes{ "vtkOpenGLActor" };
  return classes;
}
}

//------------------------------------------------------------------------------
void vtkRelievoPlainActor::AddClass(const std::string& name)
{
  GetPlainClasses().insert(name);
}

//------------------------------------------------------------------------------
bool vtkRelievoPlainActor::IsOfClass(vtkActor* actor)
{
  return GetPlainClasses().count(actor->GetClassName()) != 0;
}

//------------------------------------------------------------------------------
bool vtkRelievoPlainActor::HasOwnShaders(vtkActor* actor)
{
  vtkShaderProperty* shaders = actor->GetShaderProperty();
  return shaders->HasVertexShaderCode() || shaders->HasGeometryShaderCode() ||
    shaders->HasFragmentShaderCode() || shaders->GetNumberOfShaderReplacements() > 0;
}
