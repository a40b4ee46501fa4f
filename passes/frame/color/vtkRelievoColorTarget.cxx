// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoColorTarget.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPointData.h"
#include "vtkRelievoDrawnPart.h"
#include "vtkRelievoFormulas.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoScopedState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <iterator>
#include <utility>

//------------------------------------------------------------------------------
class vtkRelievoColorTarget::Input : public vtkRelievoResource
{
public:
  vtkRelievoColorTarget* Target = nullptr;
  int Offset[2] = { 0, 0 };

  std::string GetDefines() const override
  {
    return this->Target->DepthPresented ? "" : "#define RELIEVO_DEPTH_LEFT\n";
  }
  void Activate(vtkShaderProgram* program) override
  {
    this->Target->Buffers.Color->Activate();
    this->Target->Buffers.Depth->Activate();
    program->SetUniformi("relievoDrawn", this->Target->Buffers.Color->GetTextureUnit());
    program->SetUniformi("relievoDrawnZ", this->Target->Buffers.Depth->GetTextureUnit());
    program->SetUniform2i("relievoDrawnOffset", this->Offset);
  }
  void Deactivate() override
  {
    this->Target->Buffers.Color->Deactivate();
    this->Target->Buffers.Depth->Deactivate();
  }
};

//------------------------------------------------------------------------------
vtkRelievoColorTarget::vtkRelievoColorTarget()
  : Drawn(new Input)
{
  this->Drawn->Target = this;
}

//------------------------------------------------------------------------------
vtkRelievoColorTarget::~vtkRelievoColorTarget()
{
  this->Release(this->Buffers.Window);
}

//------------------------------------------------------------------------------
std::string vtkRelievoColorTarget::Prepare(vtkRelievoFrameContext& context, bool single)
{
  this->Valid = false;
  vtkRenderer* renderer = context.Renderer;
  if (context.Picture && (renderer->GetPreserveDepthBuffer() || !renderer->GetErase()))
  {
    return renderer->GetErase()
      ? "the renderer keeps another renderer's depth (PreserveDepthBuffer)"
      : "the renderer keeps the earlier picture (EraseOff)";
  }
  const std::string fault = this->Buffers.Allocate(
    context.Window, context.View.Viewport, single ? 0 : vtkRelievoBoundFramebuffer::GetSamples());
  if (!fault.empty())
  {
    return fault;
  }
  vtkOpenGLState* state = context.Window->GetState();
  state->PushFramebufferBindings();
  this->Buffers.Framebuffer->Bind();
  const bool complete = glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  state->PopFramebufferBindings();
  if (!complete)
  {
    const int samples = this->Buffers.NumberOfSamples;
    this->Release(context.Window);
    return std::string("this OpenGL cannot draw to ") +
      (this->Buffers.Floats ? "floats with " : "half floats with ") + std::to_string(samples) +
      " samples";
  }
  return std::string();
}

//------------------------------------------------------------------------------
void vtkRelievoColorTarget::Begin(vtkRelievoFrameContext& context)
{
  vtkRenderer* renderer = context.Renderer;
  vtkOpenGLState* state = context.Window->GetState();
  this->Separated = false;
  this->DepthPresented = false;
  this->Made = Rectangle();
  vtkRelievoDrawnPart drawn;
  drawn.Find(context);
  this->DrawnOn = this->GetAll().Within(Rectangle::Of(drawn.Part));
  this->TellsByDepth = drawn.TellsByDepth;
  const int before = vtkRelievoBoundFramebuffer::GetNumber();
  const bool resolves = vtkRelievoBoundFramebuffer::GetSamples() > 0;
  state->PushFramebufferBindings();
  this->Buffers.Framebuffer->Bind();
  const bool keeps =
    renderer->GetLayer() > 0 || !renderer->GetErase() || renderer->GetPreserveColorBuffer();
  if (context.Picture && (keeps || context.Nested))
  {
    this->CopyWhatIsThere(context, before, resolves);
  }
  else if (keeps || renderer->GetPreserveDepthBuffer())
  {
    // VTK clears only a part; the rest holds another frame.
    const vtkRelievoScopedState kept(state);
    const float nothing[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
    const float far = 1.0f;
    state->vtkglDisable(GL_SCISSOR_TEST);
    state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    state->vtkglDepthMask(GL_TRUE);
    glClearBufferfv(GL_COLOR, 0, nothing);
    glClearBufferfv(GL_DEPTH, 0, &far);
  }
  if (context.Nested)
  {
    // The outer pass has cleared its own framebuffer, and set its own viewport.
    const int* v = context.View.Viewport;
    state->vtkglViewport(v[0], v[1], v[2], v[3]);
    state->vtkglScissor(v[0], v[1], v[2], v[3]);
    if (!context.Picture && !keeps)
    {
      renderer->Clear();
    }
    state->vtkglDepthMask(GL_TRUE);
    state->vtkglClearDepth(1.0);
    state->vtkglClear(GL_DEPTH_BUFFER_BIT);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoColorTarget::CopyWhatIsThere(
  vtkRelievoFrameContext& context, int framebuffer, bool resolves)
{
  const int* v = context.View.Viewport;
  vtkOpenGLState* state = context.Window->GetState();
  const vtkRelievoScopedState kept(state);
  // Every OpenGL can resolve samples into a texture of their own format.
  vtkSmartPointer<vtkTextureObject> there = vtkRelievoColorBuffers::MakeTexture(
    context.Window, resolves ? GL_RGBA8 : this->Buffers.GetFormat(), v[2], v[3]);
  this->Buffers.Pen->Bind(GL_DRAW_FRAMEBUFFER);
  this->Buffers.Pen->AddColorAttachment(0, there);
  this->Buffers.Pen->ActivateDrawBuffer(0);
  {
    // Reads from the framebuffer's draw buffer, which may differ from its read buffer.
    const auto name = static_cast<unsigned int>(framebuffer);
    GLint drawn = GL_NONE;
    GLint read = GL_NONE;
    state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, name);
    glGetIntegerv(GL_DRAW_BUFFER, &drawn);
    this->Buffers.Pen->Bind(GL_DRAW_FRAMEBUFFER);
    state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, name);
    glGetIntegerv(GL_READ_BUFFER, &read);
    state->vtkglReadBuffer(static_cast<unsigned int>(drawn));
    state->vtkglScissor(0, 0, v[2], v[3]);
    state->vtkglBlitFramebuffer(
      v[0], v[1], v[0] + v[2], v[1] + v[3], 0, 0, v[2], v[3], GL_COLOR_BUFFER_BIT, GL_NEAREST);
    state->vtkglReadBuffer(static_cast<unsigned int>(read));
  }
  this->Buffers.Framebuffer->Bind();
  if (vtkShaderProgram* program = this->Copy.Ready(context, "frame/copyFS.glsl", {}))
  {
    there->Activate();
    program->SetUniformi("relievoSource", there->GetTextureUnit());
    state->vtkglDisable(GL_BLEND);
    this->Copy.Draw(context);
    there->Deactivate();
  }
  there->ReleaseGraphicsResources(context.Window);
}

//------------------------------------------------------------------------------
bool vtkRelievoColorTarget::IsBound(bool reading) const
{
  return this->Buffers.Framebuffer &&
    vtkRelievoBoundFramebuffer::GetNumber(reading) ==
    static_cast<int>(this->Buffers.Framebuffer->GetFBOIndex());
}

//------------------------------------------------------------------------------
void vtkRelievoColorTarget::Resolve(vtkRelievoFrameContext& context)
{
  const int* v = context.View.Viewport;
  vtkOpenGLState* state = context.Window->GetState();
  if (this->Buffers.Resolved)
  {
    const vtkRelievoScopedState kept(state);
    this->Buffers.Framebuffer->Bind(GL_READ_FRAMEBUFFER);
    this->Buffers.Framebuffer->ActivateReadBuffer(0);
    this->Buffers.Resolved->Bind(GL_DRAW_FRAMEBUFFER);
    state->vtkglScissor(0, 0, this->Buffers.Size[0], this->Buffers.Size[1]);
    for (const unsigned int buffer : { GL_COLOR_BUFFER_BIT, GL_DEPTH_BUFFER_BIT })
    {
      state->vtkglBlitFramebuffer(v[0], v[1], v[0] + v[2], v[1] + v[3], v[0], v[1], v[0] + v[2],
        v[1] + v[3], buffer, GL_NEAREST);
    }
  }
  this->Drawn->Offset[0] = v[0];
  this->Drawn->Offset[1] = v[1];
  context.Provide(vtkRelievoResources::Drawn, this->Drawn.get());
}

//------------------------------------------------------------------------------
vtkRelievoColorTarget::Rectangle vtkRelievoColorTarget::Rectangle::With(
  const Rectangle& other) const
{
  if (this->IsEmpty() || other.IsEmpty())
  {
    return this->IsEmpty() ? other : *this;
  }
  Rectangle both;
  for (int axis = 0; axis < 2; ++axis)
  {
    both.From[axis] = std::min(this->From[axis], other.From[axis]);
    both.To[axis] = std::max(this->To[axis], other.To[axis]);
  }
  return both;
}

//------------------------------------------------------------------------------
vtkRelievoColorTarget::Rectangle vtkRelievoColorTarget::Rectangle::Of(const int part[4])
{
  return { { part[0], part[1] }, { part[0] + part[2], part[1] + part[3] } };
}

//------------------------------------------------------------------------------
vtkRelievoColorTarget::Rectangle vtkRelievoColorTarget::Rectangle::Within(
  const Rectangle& other) const
{
  Rectangle both;
  for (int axis = 0; axis < 2; ++axis)
  {
    both.From[axis] = std::max(this->From[axis], other.From[axis]);
    both.To[axis] = std::min(this->To[axis], other.To[axis]);
  }
  return both.IsEmpty() ? Rectangle() : both;
}

//------------------------------------------------------------------------------
vtkRelievoColorTarget::Rectangles vtkRelievoColorTarget::Outside(
  const Rectangles& all, const Rectangle& other)
{
  Rectangles outside;
  for (const Rectangle& each : all)
  {
    const Rectangles rest = each.Without(each.Within(other));
    std::copy_if(rest.begin(), rest.end(), std::back_inserter(outside),
      [](const Rectangle& part) { return !part.IsEmpty(); });
  }
  return outside;
}

//------------------------------------------------------------------------------
std::vector<vtkRelievoColorTarget::Rectangle> vtkRelievoColorTarget::Rectangle::Without(
  const Rectangle& inner) const
{
  if (inner.IsEmpty())
  {
    return { *this };
  }
  const Rectangle around[] = {
    { { this->From[0], this->From[1] }, { this->To[0], inner.From[1] } },
    { { this->From[0], inner.To[1] }, { this->To[0], this->To[1] } },
    { { this->From[0], inner.From[1] }, { inner.From[0], inner.To[1] } },
    { { inner.To[0], inner.From[1] }, { this->To[0], inner.To[1] } },
  };
  std::vector<Rectangle> rest;
  std::copy_if(std::begin(around), std::end(around), std::back_inserter(rest),
    [](const Rectangle& each) { return !each.IsEmpty(); });
  return rest;
}

//------------------------------------------------------------------------------
vtkRelievoColorTarget::Rectangle vtkRelievoColorTarget::GetAll() const
{
  return { { 0, 0 }, { this->Buffers.Size[2], this->Buffers.Size[3] } };
}

//------------------------------------------------------------------------------
bool vtkRelievoColorTarget::IsWhole() const
{
  return this->GetAll().Without(this->Made).empty();
}

//------------------------------------------------------------------------------
void vtkRelievoColorTarget::MakeLinear(vtkRelievoFrameContext& context, const Rectangle& where)
{
  const Rectangle all = this->Made.With(where);
  for (const Rectangle& rest : all.Without(this->Made))
  {
    this->Valid = this->Valid &&
      this->ToLinear.Ready(context, "frame/toLinearFS.glsl", { vtkRelievoResources::Drawn });
    if (this->Valid)
    {
      this->DrawOnto(context, this->ToLinear, 0, false, rest);
    }
  }
  this->Made = all;
}

//------------------------------------------------------------------------------
void vtkRelievoColorTarget::Separate(vtkRelievoFrameContext& context)
{
  this->Resolve(context);
  this->Valid = true;
  this->MakeLinear(context, this->GetAll());
  this->Separated = true;
  context.Provide(vtkRelievoResources::Color, this);
}

//------------------------------------------------------------------------------
void vtkRelievoColorTarget::Clear(vtkRelievoFrameContext& context, float alpha)
{
  vtkOpenGLState* state = context.Window->GetState();
  const vtkRelievoScopedState kept(state);
  this->Buffers.Framebuffer->Bind(GL_DRAW_FRAMEBUFFER);
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  const float nothing[4] = { 0.0f, 0.0f, 0.0f, alpha };
  glClearBufferfv(GL_COLOR, 0, nothing);
}

//------------------------------------------------------------------------------
void vtkRelievoColorTarget::Put(vtkRelievoFrameContext& context, vtkRelievoScreenQuad& colors,
  vtkRelievoScreenQuad* depths, const int part[4])
{
  const Rectangle where = Rectangle::Of(part);
  this->DrawOnto(context, colors, 0, false, where);
  this->Made = this->Made.With(where);
  this->Valid = true;
  if (!depths)
  {
    return;
  }
  const int* v = context.View.Viewport;
  const int place[4] = { v[0] + part[0], v[1] + part[1], part[2], part[3] };
  vtkOpenGLState* state = context.Window->GetState();
  const vtkRelievoScopedState kept(state);
  this->Buffers.Framebuffer->Bind();
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  depths->Draw(context, nullptr, vtkRelievoScreenQuad::WRITES_DEPTH, place);
}

//------------------------------------------------------------------------------
void vtkRelievoColorTarget::End(vtkRelievoFrameContext& context)
{
  this->Resolve(context);
  context.Window->GetState()->PopFramebufferBindings();
  this->Valid = this->Valid || !this->Separated;
  if (context.ReadsColor)
  {
    this->MakeLinear(context, this->GetAll());
  }
  this->Presented = false;
  if (this->Valid)
  {
    context.Provide(vtkRelievoResources::Color, this);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoColorTarget::BeginAside(vtkRelievoFrameContext& context)
{
  context.Window->GetState()->PushFramebufferBindings();
  this->Buffers.Framebuffer->Bind();
}

//------------------------------------------------------------------------------
void vtkRelievoColorTarget::EndAside(vtkRelievoFrameContext& context)
{
  context.Window->GetState()->PopFramebufferBindings();
}

//------------------------------------------------------------------------------
bool vtkRelievoColorTarget::Draw(
  vtkRelievoFrameContext& context, vtkRelievoScreenQuad& quad, bool replaces, const int* part)
{
  if (!this->Buffers.Pen || !this->Valid)
  {
    return false;
  }
  Rectangle where = part ? this->GetAll().Within(Rectangle::Of(part)) : this->GetAll();
  if (where.IsEmpty())
  {
    return true;
  }
  if (replaces)
  {
    where = this->Made.With(where);
    this->Buffers.MakeSecond();
    this->DrawOnto(context, quad, 1, false, where);
    std::swap(this->Buffers.Linear[0], this->Buffers.Linear[1]);
    this->Made = where;
  }
  else
  {
    this->MakeLinear(context, where);
    this->DrawOnto(context, quad, 0, true, where);
  }
  return this->Valid;
}

//------------------------------------------------------------------------------
// Draws into one of the two linear colours, replacing its content unless it blends.
void vtkRelievoColorTarget::DrawOnto(vtkRelievoFrameContext& context, vtkRelievoScreenQuad& quad,
  int which, bool blends, const Rectangle& where)
{
  const int area[4] = { 0, 0, this->Buffers.Size[2], this->Buffers.Size[3] };
  const int part[4] = { where.From[0], where.From[1], where.To[0] - where.From[0],
    where.To[1] - where.From[1] };
  vtkOpenGLState* state = context.Window->GetState();
  const vtkRelievoScopedState kept(state);
  this->Buffers.Pen->Bind();
  this->Buffers.Pen->AddColorAttachment(0, this->Buffers.Linear[which]);
  this->Buffers.Pen->ActivateDrawBuffer(0);
  if (!blends)
  {
    state->vtkglDisable(GL_BLEND);
  }
  quad.Draw(context, area, vtkRelievoScreenQuad::NO_DEPTH, part);
}

//------------------------------------------------------------------------------
bool vtkRelievoColorTarget::Present(vtkRelievoFrameContext& context, vtkRelievoScreenQuad* quad,
  const float* background, const int* part, bool drawnOnly)
{
  if (!this->Valid || this->Presented)
  {
    return false;
  }
  const vtkRelievoScopedState kept(context.Window->GetState());
  context.Window->GetState()->vtkglDisable(GL_BLEND);
  const auto present = [&](vtkRelievoScreenQuad& each, const Rectangle& where, bool drawn) {
    const int* v = context.View.Viewport;
    const int place[4] = { v[0] + where.From[0], v[1] + where.From[1], where.To[0] - where.From[0],
      where.To[1] - where.From[1] };
    each.Draw(context, nullptr,
      !this->DepthPresented           ? vtkRelievoScreenQuad::WRITES_DEPTH
        : drawn && this->TellsByDepth ? vtkRelievoScreenQuad::WHERE_DRAWN
                                      : vtkRelievoScreenQuad::NO_DEPTH,
      place);
  };
  // Presents changed areas, then areas left unchanged since drawing; elsewhere the background, if
  // its colour is known. A quad replaces the sRGB curve, in its part or everywhere.
  vtkRelievoScreenQuad* whole = part ? nullptr : quad;
  float drawn[4];
  this->GetBackground(context, drawn);
  const float* elsewhere = whole ? background : drawn;
  const bool some = this->DepthPresented && elsewhere;
  const Rectangle by = part ? this->GetAll().Within(Rectangle::Of(part)) : Rectangle();
  const Rectangles changed = Outside({ this->Made }, by);
  const Rectangles others =
    Outside(Outside({ some ? this->DrawnOn : this->GetAll() }, this->Made), by);
  if (some)
  {
    this->PresentBackground(context, elsewhere);
  }
  const bool ready = whole ||
    ((changed.empty() ||
       this->ToDisplay.Ready(context, "frame/toDisplayFS.glsl",
         { vtkRelievoResources::Color, vtkRelievoResources::Drawn })) &&
      (others.empty() ||
        this->ToDisplayAsDrawn.Ready(context, "frame/toDisplayFS.glsl",
          { vtkRelievoResources::Drawn }, "#define RELIEVO_AS_DRAWN\n")));
  if (!ready)
  {
    return false;
  }
  for (const Rectangle& where : changed)
  {
    present(whole ? *whole : this->ToDisplay, where, false);
  }
  for (const Rectangle& where : others)
  {
    present(whole ? *whole : this->ToDisplayAsDrawn, where, some);
  }
  if (!by.IsEmpty())
  {
    present(*quad, by, drawnOnly && this->Made.IsEmpty());
  }
  this->Presented = true;
  return true;
}

//------------------------------------------------------------------------------
// Clears to the background, over which the drawn areas follow.
void vtkRelievoColorTarget::PresentBackground(vtkRelievoFrameContext& context, const float* color)
{
  if (!this->TellsByDepth && this->GetAll().Without(this->DrawnOn).empty())
  {
    return;
  }
  const int* v = context.View.Viewport;
  const int* size = context.Window->GetActualSize();
  vtkOpenGLState* state = context.Window->GetState();
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  // Software OpenGL clears everything faster than a part.
  const bool all = v[0] == 0 && v[1] == 0 && v[2] == size[0] && v[3] == size[1];
  state->SetEnumState(GL_SCISSOR_TEST, !all);
  state->vtkglScissor(v[0], v[1], v[2], v[3]);
  glClearBufferfv(GL_COLOR, 0, color);
}

//------------------------------------------------------------------------------
bool vtkRelievoColorTarget::PresentDepth(vtkRelievoFrameContext& context)
{
  if (this->DepthPresented)
  {
    return true;
  }
  if (!this->Valid || this->Presented || this->Buffers.Resolved ||
    vtkRelievoBoundFramebuffer::GetSamples() > 0 || !this->Buffers.HasBoundDepth())
  {
    return false;
  }
  const int* v = context.View.Viewport;
  vtkOpenGLState* state = context.Window->GetState();
  const vtkRelievoScopedState kept(state);
  state->PushReadFramebufferBinding();
  this->Buffers.Framebuffer->Bind(GL_READ_FRAMEBUFFER);
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglDepthMask(GL_TRUE);
  while (!this->Buffers.DepthCopied && glGetError() != GL_NO_ERROR)
  {
    // Discards errors of earlier calls.
  }
  state->vtkglBlitFramebuffer(v[0], v[1], v[0] + v[2], v[1] + v[3], v[0], v[1], v[0] + v[2],
    v[1] + v[3], GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  state->PopReadFramebufferBinding();
  if (!this->Buffers.DepthCopied) // once it has succeeded, it always does
  {
    this->Buffers.DepthCopied = glGetError() == GL_NO_ERROR;
  }
  this->DepthPresented = this->Buffers.DepthCopied;
  return this->DepthPresented;
}

//------------------------------------------------------------------------------
std::string vtkRelievoColorTarget::Read(vtkImageData* image)
{
  if (!this->Valid || !this->Buffers.Window || !this->IsWhole())
  {
    return "the last frame made no linear colour; ask for it (RequestLayer) and render before";
  }
  const int width = this->Buffers.Size[2];
  const int height = this->Buffers.Size[3];
  if (image->GetNumberOfPoints() == 0)
  {
    image->SetDimensions(width, height, 1);
  }
  if (image->GetNumberOfPoints() != static_cast<vtkIdType>(width) * height)
  {
    return "the image has " + std::to_string(image->GetNumberOfPoints()) +
      " points, but the colour has " + std::to_string(width) + " x " + std::to_string(height) +
      " pixels";
  }
  vtkNew<vtkFloatArray> color;
  color->SetName("color");
  color->SetNumberOfComponents(4);
  color->SetNumberOfTuples(image->GetNumberOfPoints());
  this->Buffers.Window->MakeCurrent();
  vtkOpenGLState* state = this->Buffers.Window->GetState();
  state->PushFramebufferBindings();
  this->Buffers.Pen->Bind();
  this->Buffers.Pen->AddColorAttachment(0, this->Buffers.Linear[0]);
  this->Buffers.Pen->ActivateReadBuffer(0);
  state->vtkglPixelStorei(GL_PACK_ALIGNMENT, 4);
  glFinish();
  glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, color->GetPointer(0));
  state->PopFramebufferBindings();
  image->GetPointData()->AddArray(color);
  return std::string();
}

//------------------------------------------------------------------------------
void vtkRelievoColorTarget::GetBackground(
  const vtkRelievoFrameContext& context, float color[4]) const
{
  std::copy_n(context.Renderer->GetBackground(), 3, color);
  color[3] = static_cast<float>(context.Renderer->GetBackgroundAlpha());
  if (!this->Buffers.Floats)
  {
    std::transform(color, color + 4, color, relievo::f32::relievoRoundToHalf);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoColorTarget::GetDrawnPart(int part[4]) const
{
  for (int axis = 0; axis < 2; ++axis)
  {
    part[axis] = this->DrawnOn.From[axis];
    part[axis + 2] = this->DrawnOn.To[axis] - this->DrawnOn.From[axis];
  }
}

//------------------------------------------------------------------------------
std::string vtkRelievoColorTarget::GetDefines() const
{
  return this->Made.IsEmpty() ? "#define RELIEVO_COLOR_DRAWN\n"
    : this->IsWhole()         ? ""
                              : "#define RELIEVO_COLOR_PART\n";
}

//------------------------------------------------------------------------------
void vtkRelievoColorTarget::Activate(vtkShaderProgram* program)
{
  if (!this->IsWhole())
  {
    this->Drawn->Activate(program);
    program->SetUniform2i("relievoColorFrom", this->Made.From);
    program->SetUniform2i("relievoColorTo", this->Made.To);
  }
  this->Buffers.Linear[0]->Activate();
  program->SetUniformi("relievoColor", this->Buffers.Linear[0]->GetTextureUnit());
}

//------------------------------------------------------------------------------
void vtkRelievoColorTarget::Deactivate()
{
  this->Buffers.Linear[0]->Deactivate();
  if (!this->IsWhole())
  {
    this->Drawn->Deactivate();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoColorTarget::Release(vtkWindow* window)
{
  this->Buffers.Release(window);
  for (vtkRelievoScreenQuad* quad :
    { &this->ToLinear, &this->ToDisplay, &this->ToDisplayAsDrawn, &this->Copy })
  {
    quad->Release(window);
  }
  this->Valid = false;
}
