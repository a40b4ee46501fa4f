// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ColorStage.h
 * @brief A stage of the tests' own: the linear colour times Factor plus Shift, where something is.
 */
#ifndef relievoTestColorStage_h
#define relievoTestColorStage_h

#include <vtkObjectFactory.h>
#include <vtkRelievoFrameContext.h>
#include <vtkRelievoFramePlan.h>
#include <vtkRelievoScreenQuad.h>
#include <vtkRelievoShaderLibrary.h>
#include <vtkRelievoStage.h>
#include <vtkShaderProgram.h>

#include <string>

namespace relievoTest
{
class ColorStage : public vtkRelievoStage
{
public:
  static ColorStage* New() { VTK_STANDARD_NEW_BODY(ColorStage); }
  vtkTypeMacro(ColorStage, vtkRelievoStage);

  std::string Name = "shift";
  int Slot = vtkRelievoStageDescription::COMPOSITE;
  double Factor = 1.0;
  double Shift = 0.0;
  int Executed = 0;

  void ReleaseGraphicsResources(vtkWindow* window) override { this->Quad.Release(window); }

protected:
  void Describe(vtkRelievoStageDescription& description) override
  {
    description.Name = this->Name;
    description.Help = "Changes the colour.";
    description.Slot = this->Slot;
    description.Reads = { vtkRelievoResources::Color };
    description.Writes = { vtkRelievoResources::Color };
    description.AddNumber(
      "factor", this->Factor, [this](double v) { this->Factor = v; }, 0.0, 10.0, "", "Times this.");
  }

  void Execute(vtkRelievoFrameContext& context) override
  {
    static const bool added = vtkRelievoShaderLibrary::Add("test/shiftFS.glsl",
      "//VTK::System::Dec\n//RELIEVO::Defines\n//VTK::Output::Dec\n"
      "//RELIEVO::Include(frame/color.glsl)\n"
      "in vec2 texCoord;\nuniform vec2 relievoSize;\nuniform float factor;\nuniform float shift;\n"
      "void main() {\n  vec4 c = relievoFetchColor(ivec2(floor(texCoord * relievoSize)));\n"
      "  gl_FragData[0] = vec4(factor * c.rgb + shift, c.a);\n}\n");
    vtkShaderProgram* program = added
      ? this->Quad.Ready(context, "test/shiftFS.glsl", { vtkRelievoResources::Color })
      : nullptr;
    if (program)
    {
      program->SetUniformf("factor", static_cast<float>(this->Factor));
      program->SetUniformf("shift", static_cast<float>(this->Shift));
      this->Executed += context.DrawColor(this->Quad) ? 1 : 0;
    }
  }

private:
  vtkRelievoScreenQuad Quad;
};
}

#endif
