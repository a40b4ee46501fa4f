// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reflection of an environment by a surface, and lighting by the environment: text for VTK's
// shaders, and its uniforms.
#ifndef vtkRelievoReflection_h
#define vtkRelievoReflection_h

#include "vtkRelievoEnvironmentTextures.h"

#include <string>

class vtkOpenGLRenderWindow;
class vtkRelievoEnvironment;
class vtkShaderProgram;

namespace vtkRelievoReflection
{
struct Values
{
  double Reflectivity = 0.0;
  double Roughness = 0.0;
  double ReflectionWeight = 0.0;
  double IrradianceWeight = 0.0;
};

void Mark(std::string& fragment);

// Returns an error message, or an empty string.
std::string Fill(std::string& vertex, std::string& geometry, std::string& fragment,
  const vtkRelievoEnvironmentTextures::Structure& structure);

bool IsIn(vtkShaderProgram* program);
void SetParameters(vtkShaderProgram* program, vtkOpenGLRenderWindow* window,
  vtkRelievoEnvironment* environment, const Values& values);
}

#endif
