// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSampleStage.h"

#include "vtkObjectFactory.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoFramePlan.h"
#include "vtkRelievoScreenQuad.h"
#include "vtkShaderProgram.h"

vtkStandardNewMacro(vtkRelievoSampleStage);

//------------------------------------------------------------------------------
vtkRelievoSampleStage::vtkRelievoSampleStage()
  : Quad(new vtkRelievoScreenQuad)
{
}

//------------------------------------------------------------------------------
vtkRelievoSampleStage::~vtkRelievoSampleStage() = default;

//------------------------------------------------------------------------------
void vtkRelievoSampleStage::Describe(vtkRelievoStageDescription& description)
{
  description.Name = "sample";
  description.Help = "Fades distant surfaces towards a colour.";
  description.Slot = vtkRelievoStageDescription::COMPOSITE;
  description.Reads = { vtkRelievoResources::Depth, vtkRelievoResources::Color };
  description.Writes = { vtkRelievoResources::Color };
  description.AddNumber(
    "strength", this->Strength, [this](double strength) { this->SetStrength(strength); }, 0.0, 1.0,
    "", "Fraction of the colour at the far plane.");
  description.AddColor(
    "color", this->Color,
    [this](const double* color) { this->SetColor(color[0], color[1], color[2]); },
    "The colour that things fade to.");
}

//------------------------------------------------------------------------------
void vtkRelievoSampleStage::Declare(
  const vtkRelievoFrameContext&, vtkRelievoDeclaration& declaration) const
{
  if (this->Strength == 0.0)
  {
    declaration.Runs = false;
    declaration.ReasonCode = "idle";
    declaration.Reason = "strength is 0";
  }
}

//------------------------------------------------------------------------------
void vtkRelievoSampleStage::Execute(vtkRelievoFrameContext& context)
{
  this->DrawCalls = 0;
  vtkShaderProgram* program = this->Quad->Ready(
    context, "sample/sampleFS.glsl", { vtkRelievoResources::Depth, vtkRelievoResources::Color });
  if (!program)
  {
    this->Explain("failed", this->Quad->GetError());
    return;
  }
  const float color[3] = { static_cast<float>(this->Color[0]), static_cast<float>(this->Color[1]),
    static_cast<float>(this->Color[2]) };
  program->SetUniform3f("sampleColor", color);
  program->SetUniformf("sampleStrength", static_cast<float>(this->Strength));
  if (context.DrawColor(*this->Quad))
  {
    this->DrawCalls = 1;
  }
}

//------------------------------------------------------------------------------
void vtkRelievoSampleStage::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Quad->Release(window);
  this->Superclass::ReleaseGraphicsResources(window);
}
