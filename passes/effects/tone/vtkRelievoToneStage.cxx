// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoToneStage.h"

#include "vtkCameraPass.h"
#include "vtkCollection.h"
#include "vtkImageProcessingPass.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRelievoBlueNoise.h"
#include "vtkRelievoFormulas.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoFramePass.h"
#include "vtkRelievoFramePlan.h"
#include "vtkRelievoLuminanceMeter.h"
#include "vtkRelievoParameter.h"
#include "vtkRelievoReportOnce.h"
#include "vtkRelievoScreenQuad.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderer.h"
#include "vtkSequencePass.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkRelievoToneStage);

namespace
{
// Whether the pass, or one that it delegates to, is VTK's tone mapping.
bool MapsTones(vtkRenderPass* pass)
{
  if (!pass)
  {
    return false;
  }
  if (pass->IsA("vtkToneMappingPass")) // by name: cvista lacks the class
  {
    return true;
  }
  if (auto* frame = vtkRelievoFramePass::SafeDownCast(pass))
  {
    return MapsTones(frame->GetDelegatePass());
  }
  if (auto* image = vtkImageProcessingPass::SafeDownCast(pass))
  {
    return MapsTones(image->GetDelegatePass());
  }
  if (auto* camera = vtkCameraPass::SafeDownCast(pass))
  {
    return MapsTones(camera->GetDelegatePass());
  }
  auto* sequence = vtkSequencePass::SafeDownCast(pass);
  vtkRenderPassCollection* parts = sequence ? sequence->GetPasses() : nullptr;
  for (int i = 0; parts && i < parts->GetNumberOfItems(); ++i)
  {
    if (MapsTones(vtkRenderPass::SafeDownCast(parts->GetItemAsObject(i))))
    {
      return true;
    }
  }
  return false;
}

// Whether pixels that are not opaque hold a colour times its alpha. Over a background that is not
// premultiplied, such as white with VTK's default alpha of 0, pixels contain the background
// whatever their alpha.
bool IsPremultiplied(vtkRenderer* renderer)
{
  const double alpha = renderer->GetBackgroundAlpha();
  const double* background = renderer->GetBackground();
  const bool keeps =
    renderer->GetLayer() > 0 || !renderer->GetErase() || renderer->GetPreserveColorBuffer();
  return !keeps && background[0] <= alpha && background[1] <= alpha && background[2] <= alpha;
}
}

class vtkRelievoToneStage::Internals
{
public:
  vtkRelievoScreenQuad Quad;
  vtkRelievoLuminanceMeter Meter;
  double LastExposure = std::numeric_limits<double>::quiet_NaN(); // of a released meter
  vtkSmartPointer<vtkTextureObject> Thresholds;
  vtkRelievoReportOnce Reported;
};

//------------------------------------------------------------------------------
vtkRelievoToneStage::vtkRelievoToneStage()
  : Internal(new Internals)
{
}

//------------------------------------------------------------------------------
vtkRelievoToneStage::~vtkRelievoToneStage() = default;

//------------------------------------------------------------------------------
void vtkRelievoToneStage::Describe(vtkRelievoStageDescription& description)
{
  description.Name = "tone";
  description.Help =
    "Makes the picture from the linear colour by exposure, tone operator and dithering.";
  description.Slot = vtkRelievoStageDescription::DISPLAY;
  description.Order = -1; // before the display stage, which draws over it
  description.Reads = { vtkRelievoResources::Color };
  description.Writes = { vtkRelievoResources::Picture };
  description.AddChoice(
    "operator", this->Operator, [this](int which) { this->SetOperator(which); },
    { "clamp", "simple", "reinhard", "reinhard_rgb", "neutral" },
    "Maps light to the display's range: cut off at 1, x / (1 + x), Reinhard's curve on the "
    "luminance, or on each component; neutral changes light below 0.8 by at most 0.04.");
  description
    .AddNumber(
      "white", this->White, [this](double white) { this->SetWhite(white); }, 0.01, 65504.0, "",
      "Light that Reinhard's curves show as white.")
    .OnlyIf = "operator!=clamp,operator!=simple,operator!=neutral";
  description.AddNumber(
    "exposure", this->Exposure, [this](double stops) { this->SetExposure(stops); }, -20.0, 20.0,
    "stops", "The light is multiplied by 2 to this power.");
  description.AddFlag(
    "auto_exposure", this->AutoExposure, [this](bool on) { this->SetAutoExposure(on); },
    "Brings the log-average luminance of the drawn pixels to 0.18 first.");
  description
    .AddChoice(
      "dither", this->Dither, [this](int which) { this->SetDither(which); },
      { "none", "ordered", "blue_noise" },
      "Thresholds for rounding to 8 bits, so that slow gradients have no bands.")
    .Advanced = true;
}

//------------------------------------------------------------------------------
bool vtkRelievoToneStage::HasWork() const
{
  return this->Operator != CLAMP || this->Exposure != 0.0 || this->AutoExposure ||
    this->Dither != DITHER_NONE;
}

//------------------------------------------------------------------------------
bool vtkRelievoToneStage::GetChangesPicture()
{
  return this->Enabled && this->HasWork();
}

//------------------------------------------------------------------------------
void vtkRelievoToneStage::Declare(
  const vtkRelievoFrameContext& context, vtkRelievoDeclaration& declaration) const
{
  declaration.HidesColor = false; // the stage shows the colour
  declaration.Presents = true;
  if (!this->HasWork())
  {
    declaration.Runs = false;
    declaration.ReasonCode = "idle";
    declaration.Reason = "the operator is clamp, with neither exposure nor dithering";
  }
  else if (MapsTones(context.Delegate) || MapsTones(context.Renderer->GetPass()))
  {
    declaration.Runs = false;
    declaration.ReasonCode = "refused";
    declaration.Reason = "VTK's own tone mapping, a vtkToneMappingPass, is among the renderer's "
                         "passes, and tones can be mapped only once; remove that pass, or switch "
                         "the stage off";
  }
}

//------------------------------------------------------------------------------
void vtkRelievoToneStage::Fail(const std::string& error)
{
  this->Explain("failed", error);
  if (this->Internal->Reported.IsChange(error))
  {
    vtkErrorMacro("Tones are not mapped: " << error << ".");
  }
}

//------------------------------------------------------------------------------
void vtkRelievoToneStage::UploadThresholds(vtkRelievoFrameContext& context)
{
  auto& thresholds = this->Internal->Thresholds;
  if (thresholds && thresholds->GetContext() == context.Window)
  {
    return;
  }
  std::vector<float> values = vtkRelievoBlueNoise::GetThresholds();
  constexpr unsigned int size = vtkRelievoBlueNoise::Size;
  thresholds = vtkSmartPointer<vtkTextureObject>::New();
  thresholds->SetContext(context.Window);
  thresholds->SetMinificationFilter(vtkTextureObject::Nearest);
  thresholds->SetMagnificationFilter(vtkTextureObject::Nearest);
  thresholds->Create2DFromRaw(size, size, 1, VTK_FLOAT, values.data());
}

//------------------------------------------------------------------------------
// The background after tone mapping. Null if it varies over the picture, or if only the shader can
// compute it.
const float* vtkRelievoToneStage::ToneBackground(
  const vtkRelievoFrameContext& context, float color[4]) const
{
  if (this->AutoExposure || this->Dither != DITHER_NONE)
  {
    return nullptr;
  }
  context.GetBackground(color);
  const float alpha = color[3];
  const bool part = IsPremultiplied(context.Renderer) && alpha > 0.0F && alpha < 1.0F;
  const glm::vec3 linear =
    relievo::f32::relievoLinearColorFromSrgb(glm::vec3(color[0], color[1], color[2]));
  const glm::vec3 shown = relievo::f32::relievoSrgbColorFromLinear(
    relievo::f32::relievoToneCovered(this->Operator, linear, part ? alpha : 1.0F,
      static_cast<float>(std::exp2(this->Exposure)), static_cast<float>(this->White)));
  for (int i = 0; i < 3; ++i)
  {
    color[i] = shown[i];
  }
  return color;
}

//------------------------------------------------------------------------------
void vtkRelievoToneStage::Execute(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  this->DrawCalls = 0;
  if (this->AutoExposure)
  {
    const std::string error = in.Meter.Measure(context);
    if (!error.empty())
    {
      this->Fail(error);
      return;
    }
    this->DrawCalls = in.Meter.GetDrawCalls();
  }
  else if (in.Meter.GetBytes() > 0)
  {
    in.Meter.Release(context.Window);
  }
  // Defines select the code: software OpenGL executes both branches of each `if`.
  std::string chosen = "#define RELIEVO_TONE_OPERATOR " + std::to_string(this->Operator) + "\n";
  chosen += IsPremultiplied(context.Renderer) ? "#define RELIEVO_TONE_PREMULTIPLIED\n" : "";
  chosen += this->AutoExposure ? "#define RELIEVO_TONE_MEASURED\n" : "";
  chosen += this->Dither != DITHER_NONE ? "#define RELIEVO_TONE_DITHER\n" : "";
  chosen += this->Dither == DITHER_BLUE_NOISE ? "#define RELIEVO_TONE_DITHER_TEXTURE\n" : "";
  vtkShaderProgram* program = in.Quad.Ready(context, "tone/toneFS.glsl",
    { vtkRelievoResources::Color, vtkRelievoResources::Drawn }, chosen);
  if (!program)
  {
    this->Fail(in.Quad.GetError());
    return;
  }
  program->SetUniformf("toneWhite", static_cast<float>(this->White));
  program->SetUniformf("toneExposure", static_cast<float>(std::exp2(this->Exposure)));
  if (this->AutoExposure)
  {
    in.Meter.Activate(program);
  }
  if (this->Dither == DITHER_BLUE_NOISE)
  {
    this->UploadThresholds(context);
    in.Thresholds->Activate();
    program->SetUniformi("toneThresholds", in.Thresholds->GetTextureUnit());
  }
  float background[4];
  if (context.Present(in.Quad, this->ToneBackground(context, background)))
  {
    ++this->DrawCalls;
  }
  if (this->AutoExposure)
  {
    in.Meter.Deactivate();
  }
  if (this->Dither == DITHER_BLUE_NOISE)
  {
    in.Thresholds->Deactivate();
  }
}

//------------------------------------------------------------------------------
double vtkRelievoToneStage::GetUsedExposure()
{
  if (!this->AutoExposure)
  {
    return this->Exposure;
  }
  float sums[4];
  if (!this->Internal->Meter.Read(sums))
  {
    return this->GetEnabled() ? this->Internal->LastExposure
                              : std::numeric_limits<double>::quiet_NaN();
  }
  const int which = sums[1] > 0.0F ? 0 : 2;
  return sums[which + 1] > 0.0F ? this->Exposure +
      std::log2(
        relievo::f64::relievoToneAutoExposure(static_cast<double>(sums[which]) / sums[which + 1]))
                                : this->Exposure;
}

//------------------------------------------------------------------------------
double vtkRelievoToneStage::GetBlueNoise(int x, int y)
{
  constexpr int last = vtkRelievoBlueNoise::Size - 1;
  return vtkRelievoBlueNoise::GetThresholds()[(y & last) * (last + 1) + (x & last)];
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoToneStage::GetBytesHeld()
{
  const vtkIdType thresholds =
    this->Internal->Thresholds ? vtkRelievoBlueNoise::Size * vtkRelievoBlueNoise::Size * 4 : 0;
  return this->Internal->Meter.GetBytes() + thresholds;
}

//------------------------------------------------------------------------------
void vtkRelievoToneStage::ReleaseGraphicsResources(vtkWindow* window)
{
  Internals& in = *this->Internal;
  in.Quad.Release(window);
  if (in.Meter.GetBytes() > 0)
  {
    in.LastExposure = this->GetUsedExposure(); // remains after a capture without tone mapping
    in.Meter.Release(window);
  }
  if (in.Thresholds)
  {
    in.Thresholds->ReleaseGraphicsResources(window);
    in.Thresholds = nullptr;
  }
  this->DrawCalls = 0;
  this->Superclass::ReleaseGraphicsResources(window);
}
