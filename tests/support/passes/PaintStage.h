// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PaintStage.h
 * @brief A stage for tests: the linear colour is an image of floats, independent of the scene.
 */
#ifndef relievoTestPaintStage_h
#define relievoTestPaintStage_h

#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkRelievoFormulas.h>
#include <vtkRelievoFrameContext.h>
#include <vtkRelievoScreenQuad.h>
#include <vtkRelievoShaderLibrary.h>
#include <vtkRelievoStage.h>
#include <vtkShaderProgram.h>
#include <vtkSmartPointer.h>
#include <vtkTextureObject.h>

#include <glm/vec4.hpp>

#include <vector>

namespace relievoTest
{
class PaintStage : public vtkRelievoStage
{
public:
  static PaintStage* New() { VTK_STANDARD_NEW_BODY(PaintStage); }
  vtkTypeMacro(PaintStage, vtkRelievoStage);

  int Width = 0;
  std::vector<glm::vec4> Pixels; ///< by rows of Width from the bottom, premultiplied

  /** Sets all width x height pixels to one colour. */
  void Fill(int width, int height, const glm::vec4& pixel)
  {
    this->Width = width;
    this->Pixels.assign(static_cast<std::size_t>(width) * height, pixel);
  }

  /** A number rounded to half float. */
  static double GetHalf(double value)
  {
    return relievo::bits::FromHalf(relievo::bits::ToHalf(static_cast<float>(value)));
  }

  void ReleaseGraphicsResources(vtkWindow* window) override { this->Quad.Release(window); }

protected:
  void Describe(vtkRelievoStageDescription& description) override
  {
    description.Name = "paint";
    description.Help = "Paints the colour.";
    description.Slot = vtkRelievoStageDescription::COMPOSITE;
    description.Writes = { vtkRelievoResources::Color };
  }

  void Execute(vtkRelievoFrameContext& context) override
  {
    static const bool added = vtkRelievoShaderLibrary::Add("test/paintFS.glsl",
      "//VTK::System::Dec\n//RELIEVO::Defines\n//VTK::Output::Dec\n"
      "in vec2 texCoord;\nuniform vec2 relievoSize;\nuniform sampler2D paint;\n"
      "void main() {\n"
      "  gl_FragData[0] = texelFetch(paint, ivec2(floor(texCoord * relievoSize)), 0);\n}\n");
    vtkShaderProgram* program =
      added ? this->Quad.Ready(context, "test/paintFS.glsl", {}) : nullptr;
    if (!program || this->Pixels.empty())
    {
      return;
    }
    // Pixels are rounded to half floats before the upload: OpenGL may round either way.
    std::vector<glm::vec4> halves = this->Pixels;
    for (glm::vec4& pixel : halves)
    {
      for (int c = 0; c < 4; ++c)
      {
        pixel[c] = static_cast<float>(GetHalf(pixel[c]));
      }
    }
    vtkNew<vtkTextureObject> texture;
    texture->SetContext(context.Window);
    texture->SetMinificationFilter(vtkTextureObject::Nearest);
    texture->SetMagnificationFilter(vtkTextureObject::Nearest);
    texture->Create2DFromRaw(static_cast<unsigned int>(this->Width),
      static_cast<unsigned int>(this->Pixels.size() / this->Width), 4, VTK_FLOAT, halves.data());
    texture->Activate();
    program->SetUniformi("paint", texture->GetTextureUnit());
    context.DrawColor(this->Quad);
    texture->Deactivate();
    texture->ReleaseGraphicsResources(context.Window);
  }

private:
  vtkRelievoScreenQuad Quad;
};
}

#endif
