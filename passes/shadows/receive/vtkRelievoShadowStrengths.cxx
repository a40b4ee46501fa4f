// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShadowStrengths.h"

#include "vtkLight.h"
#include "vtkRelievoShadowContext.h"
#include "vtkShaderProgram.h"

//------------------------------------------------------------------------------
void vtkRelievoShadowStrengths::Set(const vtkRelievoShadowContext& work, double strength)
{
  this->Work = &work;
  this->Strengths.assign(static_cast<std::size_t>(work.Structure.Numbers), 0.0f);
  for (const auto& entry : work.Cache.GetEntries())
  {
    this->Strengths[entry.Light.Number] = static_cast<float>(strength * entry.Light.GetStrength());
  }
}

//------------------------------------------------------------------------------
std::string vtkRelievoShadowStrengths::GetDefines() const
{
  return this->Strengths.empty()
    ? std::string()
    : "#define RELIEVO_SHADOW_NUMBERS " + std::to_string(this->Strengths.size()) + "\n";
}

//------------------------------------------------------------------------------
void vtkRelievoShadowStrengths::Activate(vtkShaderProgram* program)
{
  if (!this->Strengths.empty())
  {
    program->SetUniform1fv(
      "relievoShadowStrengths", static_cast<int>(this->Strengths.size()), this->Strengths.data());
  }
}
