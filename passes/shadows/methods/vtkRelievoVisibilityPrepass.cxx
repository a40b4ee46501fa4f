// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoVisibilityPrepass.h"

#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkObject.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkProperty.h"
#include "vtkRelievoBoundFramebuffer.h"
#include "vtkRelievoCasterDraw.h"
#include "vtkRelievoScopedContext.h"
#include "vtkRelievoShaderLibrary.h"
#include "vtkShaderProgram.h"
#include "vtkTextureUnitManager.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace
{
// Floats count exactly to 2^24: that is the capacity for verdicts of two levels, or three of 256.
constexpr double Most = 16777216.0;
constexpr double Fine = 256.0;
constexpr float Nowhere = -1e30f; // behind everything

void Append(std::vector<double>& state, const glm::dmat4& matrix)
{
  state.insert(state.end(), &matrix[0][0], &matrix[0][0] + 16);
}

// Pixels across by x or y alone, like seen.glsl.
bool IsUpright(const glm::dmat4& p)
{
  return p[0][1] == 0.0 && p[1][0] == 0.0 && p[0][3] == 0.0 && p[1][3] == 0.0 && p[0][0] != 0.0 &&
    p[1][1] != 0.0;
}
}

//------------------------------------------------------------------------------
vtkRelievoVisibilityPrepass::vtkRelievoVisibilityPrepass() = default;

//------------------------------------------------------------------------------
vtkRelievoVisibilityPrepass::~vtkRelievoVisibilityPrepass()
{
  this->Release(this->Window);
}

//------------------------------------------------------------------------------
bool vtkRelievoVisibilityPrepass::TakeUnits(vtkOpenGLRenderWindow* window)
{
  if (this->Window != window)
  {
    this->Release(this->Window);
    this->Window = window;
    this->Owner = window;
  }
  vtkTextureUnitManager* units = window->GetState()->GetTextureUnitManager();
  for (int& unit : this->Units)
  {
    unit = unit < 0 ? units->Allocate() : unit;
  }
  return this->Units[0] >= 0 && this->Units[1] >= 0;
}

//------------------------------------------------------------------------------
bool vtkRelievoVisibilityPrepass::Begin(
  vtkOpenGLRenderWindow* window, const vtkRelievoFrameCamera& view, Kind kind)
{
  const bool bound = this->TakeUnits(window);
  this->View = view;
  this->Levels = kind == Whole ? 2.0 : Fine;
  this->Colored = kind == Colors;
  this->Lights = 0;
  this->Fits =
    bound && !this->Broken && IsUpright(view.ViewToNDC) && this->Allocate() && this->IsReady();
  return bound;
}

//------------------------------------------------------------------------------
int vtkRelievoVisibilityPrepass::GetMostLights() const
{
  return this->Fits ? static_cast<int>(std::log(Most) / std::log(this->Levels) + 1e-6) : 0;
}

//------------------------------------------------------------------------------
void vtkRelievoVisibilityPrepass::BeginDrawing(unsigned int target, int width, int height)
{
  vtkOpenGLState* state = this->Window->GetState();
  this->SavedState.reset(new vtkRelievoScopedState(state));
  this->Framebuffer->Bind();
  glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target, 0);
  // VTK caches the buffers of the previously bound framebuffer and may skip changes.
  const unsigned int buffer = GL_COLOR_ATTACHMENT0;
  unsigned int buffers[1] = { buffer };
  state->vtkglDrawBuffers(1, buffers);
  glDrawBuffers(1, buffers);
  state->vtkglReadBuffer(buffer);
  glReadBuffer(buffer);
  state->vtkglViewport(0, 0, width, height);
  state->vtkglScissor(0, 0, width, height);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_CULL_FACE);
}

//------------------------------------------------------------------------------
void vtkRelievoVisibilityPrepass::EndDrawing()
{
  glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, 0, 0);
  this->SavedState.reset();
}

//------------------------------------------------------------------------------
bool vtkRelievoVisibilityPrepass::SetGlyphs(const std::vector<vtkRelievoPlacedMesh>& glyphs)
{
  return this->Fits && this->Glyphs.Update(this->Window, glyphs);
}

//------------------------------------------------------------------------------
int vtkRelievoVisibilityPrepass::DrawSurfaces(
  const std::vector<vtkActor*>& actors, vtkRelievoCasterDraw& draw)
{
  if ((actors.empty() && this->Glyphs.IsEmpty()) || !this->Fits)
  {
    this->Glyphs.Unbind();
    this->SurfacesDrawn.clear();
    return 0;
  }
  bool offset = false;
  std::vector<double> seen;
  Append(seen, this->View.WorldToView);
  Append(seen, this->View.ViewToNDC);
  for (vtkActor* actor : actors)
  {
    // Buffers are rebuilt, with a time of their own, for other data and other mappers.
    seen.push_back(static_cast<double>(draw.GetBuildTime(actor)));
    Append(seen, vtkRelievoToGlm(actor->GetMatrix()));
    const glm::vec2 moved = vtkRelievoCasterDraw::GetOffset(actor);
    seen.insert(seen.end(), { moved.x, moved.y });
    offset = offset || moved != glm::vec2(0.f);
  }
  this->Glyphs.AddState(seen);
  if (seen == this->SurfacesDrawn)
  {
    this->Glyphs.Unbind();
    return 0;
  }
  constexpr std::ptrdiff_t camera = 32; // number of values
  this->HasBefore = !this->SurfacesDrawn.empty() && !this->SurfacesAreNew &&
    std::equal(seen.begin(), seen.begin() + camera, this->SurfacesDrawn.begin()) &&
    this->KeepSurfaces();
  this->SurfacesAreNew = true;
  this->SurfacesDrawn.clear();
  this->BeginDrawing(this->Textures[Surfaces], this->Width, this->Height);
  glFramebufferTexture2D(
    GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, this->Textures[Depth], 0);
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglDepthMask(GL_TRUE);
  const GLfloat nothing[4] = { Nowhere, 0.f, 0.f, 0.f };
  const GLfloat farthest = 1.f;
  glClearBufferfv(GL_COLOR, 0, nothing);
  glClearBufferfv(GL_DEPTH, 0, &farthest);
  int calls = 0;
  const glm::dmat4 toNDC = this->View.ViewToNDC * this->View.WorldToView;
  bool draws = true;
  if (!actors.empty())
  {
    draws = draw.Begin(this->Window, toNDC, this->View.WorldToView, "shadow/seenVS.glsl",
      "shadow/seenFS.glsl", offset ? "#define RELIEVO_SEEN_OFFSET" : "");
    for (vtkActor* actor : draws ? actors : std::vector<vtkActor*>())
    {
      calls += draw.Draw(actor);
    }
    draw.End();
  }
  if (draws && !this->Glyphs.IsEmpty())
  {
    draws = draw.Begin(this->Window, toNDC, this->View.WorldToView, "shadow/seenGlyphsVS.glsl",
      "shadow/seenFS.glsl");
    draws = draws && this->Glyphs.Draw(draw.GetProgram(), toNDC, this->View.WorldToView, calls);
    draw.End();
  }
  if (draws)
  {
    this->SurfacesDrawn = seen;
  }
  this->Broken = !draws;
  glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, 0, 0);
  this->EndDrawing();
  return calls;
}

//------------------------------------------------------------------------------
int vtkRelievoVisibilityPrepass::DrawVerdicts(const std::vector<glm::vec4>& sources,
  const std::vector<double>& rays, const Past& past,
  const std::function<void(vtkShaderProgram*)>& tell)
{
  if (this->SurfacesDrawn.empty())
  {
    return 0;
  }
  const int lights = std::min(this->GetMostLights(), static_cast<int>(sources.size()));
  std::vector<double> shine(1, this->Levels);
  for (const glm::vec4& source : sources)
  {
    shine.insert(shine.end(), &source.x, &source.x + 4);
  }
  std::vector<double> found = rays;
  found.push_back(past.Version);
  found.insert(found.end(), shine.begin(), shine.end());
  int calls = 0;
  if (found != this->VerdictsDrawn || this->SurfacesAreNew)
  {
    static const std::vector<vtkRelievoBoxTree::Box> nothing;
    const bool keeps = rays == this->RaysOfVerdicts && this->KeepsVerdicts(shine, past);
    const auto* moved = past.Version == this->VersionOfVerdicts ? &nothing : past.Moved;
    this->VerdictsDrawn.clear();
    calls = this->FindVerdicts(sources, lights, keeps ? moved : nullptr, tell);
    if (calls == 0)
    {
      this->Broken = true;
      return 0;
    }
    this->VerdictsDrawn = found;
    this->LightsOfVerdicts = shine;
    this->VersionOfVerdicts = past.Version;
    this->RaysOfVerdicts = rays;
    this->SurfacesAreNew = false;
  }
  this->Bind(Surfaces, Verdicts);
  this->Lights = lights;
  return calls;
}

//------------------------------------------------------------------------------
// Whether verdicts stay valid if their rays avoid everything that has moved.
bool vtkRelievoVisibilityPrepass::KeepsVerdicts(
  const std::vector<double>& lights, const Past& past) const
{
  const bool follows = past.Version == this->VersionOfVerdicts ||
    (past.Moved && past.Version == this->VersionOfVerdicts + 1.0);
  return !this->VerdictsDrawn.empty() && follows && lights == this->LightsOfVerdicts &&
    (this->HasBefore || !this->SurfacesAreNew);
}

//------------------------------------------------------------------------------
int vtkRelievoVisibilityPrepass::FindVerdicts(const std::vector<glm::vec4>& sources, int lights,
  const std::vector<vtkRelievoBoxTree::Box>* moved,
  const std::function<void(vtkShaderProgram*)>& tell)
{
  const int tiles[2] = { CountTiles(this->Width), CountTiles(this->Height) };
  for (const bool whole : { true, false })
  {
    const std::string name = whole ? "shadow/tiles" : "shadow/verdicts";
    vtkShaderProgram* program = this->Window->GetShaderCache()->ReadyShaderProgram(
      this->GetSource(name + "VS.glsl").c_str(), this->GetSource(name + "FS.glsl").c_str(), "");
    if (!program)
    {
      return 0;
    }
    whole ? this->BeginDrawing(this->Textures[Tiles], tiles[0], tiles[1])
          : this->BeginDrawing(this->Textures[Verdicts], this->Width, this->Height);
    this->Window->GetState()->vtkglDisable(GL_DEPTH_TEST);
    tell(program);
    this->Tell(program, lights);
    program->SetUniform4fv(
      "relievoSeenSource", lights, reinterpret_cast<const float(*)[4]>(sources.data()));
    program->SetUniformi("relievoSeenKeeps", moved ? 1 : 0);
    glBindVertexArray(this->Arrays);
    if (whole)
    {
      this->Bind(Surfaces, !moved ? -1 : this->SurfacesAreNew ? Before : Surfaces);
      program->SetUniformi("relievoSeenBefore", this->Units[1]);
      program->SetUniformi("relievoMovedCount", moved ? static_cast<int>(moved->size()) : 0);
      if (moved && !moved->empty())
      {
        std::vector<glm::vec3> sides;
        for (const vtkRelievoBoxTree::Box& box : *moved)
        {
          sides.insert(sides.end(), { box.Min, box.Max });
        }
        program->SetUniform3fv("relievoMoved", static_cast<int>(sides.size()),
          reinterpret_cast<const float(*)[3]>(sides.data()));
      }
      glDrawArrays(GL_TRIANGLES, 0, 3);
    }
    else
    {
      this->Bind(Surfaces, Tiles);
      program->SetUniformi("cameraParallel", this->View.Parallel ? 1 : 0);
      program->SetUniformi("relievoSeenTiles", this->Units[1]);
      program->SetUniform2i("relievoSeenTileCount", tiles);
      if (!moved)
      {
        // Without casters all lights reach the visible surfaces.
        const std::vector<GLfloat> lit(
          4, static_cast<GLfloat>(std::pow(this->Levels, lights) - 1.0));
        glClearBufferfv(GL_COLOR, 0, lit.data());
      }
      glDrawArrays(GL_TRIANGLES, 0, 6 * tiles[0] * tiles[1]);
    }
    glBindVertexArray(0);
    this->EndDrawing();
  }
  return 2;
}

//------------------------------------------------------------------------------
void vtkRelievoVisibilityPrepass::Bind(int first, int second)
{
  vtkOpenGLState* state = this->Window->GetState();
  const int bound[2] = { first, second };
  for (int i = 0; i < 2; ++i)
  {
    state->vtkglActiveTexture(GL_TEXTURE0 + static_cast<unsigned int>(this->Units[i]));
    glBindTexture(GL_TEXTURE_2D, bound[i] < 0 ? 0 : this->Textures[bound[i]]);
  }
  state->vtkglActiveTexture(GL_TEXTURE0);
}

//------------------------------------------------------------------------------
void vtkRelievoVisibilityPrepass::Tell(vtkShaderProgram* program, int lights) const
{
  const glm::dmat4& p = this->View.ViewToNDC;
  const glm::dvec2 size(this->View.Viewport[2], this->View.Viewport[3]);
  const glm::vec2 pixels(size);
  const glm::vec3 x(0.5 * size.x * glm::dvec3(p[0][0], p[2][0], p[3][0]));
  const glm::vec3 y(0.5 * size.y * glm::dvec3(p[1][1], p[2][1], p[3][1]));
  const glm::vec2 z(p[2][2], p[3][2]);
  const glm::vec2 w(p[2][3], p[3][3]);
  program->SetUniform2f("relievoSeenSize", &pixels.x);
  program->SetUniform3f("relievoSeenX", &x.x);
  program->SetUniform3f("relievoSeenY", &y.x);
  program->SetUniform2f("relievoSeenZ", &z.x);
  program->SetUniform2f("relievoSeenW", &w.x);
  program->SetUniformf("relievoSeenLevels", static_cast<float>(this->Levels));
  program->SetUniformi("relievoSeenLights", lights);
  program->SetUniformi("relievoSeen", this->Units[0]);
}

//------------------------------------------------------------------------------
void vtkRelievoVisibilityPrepass::SetUniforms(vtkShaderProgram* program) const
{
  this->Tell(program, this->Lights);
  program->SetUniformi("relievoSeenVerdicts", this->Units[1]);
}

//------------------------------------------------------------------------------
void vtkRelievoVisibilityPrepass::SetActorUniforms(vtkShaderProgram* program, vtkActor* actor) const
{
  // Among several samples of a pixel, some may see past the surface at its centre; lines, edges and
  // depth offsets are drawn over nearer surfaces.
  GLint samples = 0;
  glGetIntegerv(GL_SAMPLES, &samples);
  vtkProperty* property = actor->GetProperty();
  const bool hides = this->Lights > 0 && samples <= 1 && actor->HasOpaqueGeometry() &&
    vtkMapper::GetResolveCoincidentTopology() == VTK_RESOLVE_OFF &&
    property->GetRepresentation() == VTK_SURFACE && !property->GetEdgeVisibility() &&
    !property->GetVertexVisibility();
  program->SetUniformi("relievoSeenHides", hides ? 1 : 0);
}

//------------------------------------------------------------------------------
void vtkRelievoVisibilityPrepass::Unbind()
{
  this->Glyphs.Unbind();
  for (int& unit : this->Units)
  {
    if (unit >= 0 && this->Window)
    {
      vtkOpenGLState* state = this->Window->GetState();
      state->vtkglActiveTexture(GL_TEXTURE0 + static_cast<unsigned int>(unit));
      glBindTexture(GL_TEXTURE_2D, 0);
      state->vtkglActiveTexture(GL_TEXTURE0);
      state->GetTextureUnitManager()->Free(unit);
    }
    unit = -1;
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoVisibilityPrepass::Allocate()
{
  const int* size = this->View.Viewport + 2;
  const unsigned int depths = vtkRelievoBoundFramebuffer::GetDepth().GetFormat();
  if (this->Textures[0] && this->Width == size[0] && this->Height == size[1] &&
    this->DepthFormat == depths && this->AllocatedColored == this->Colored)
  {
    return this->Room;
  }
  this->DepthFormat = depths;
  this->AllocatedColored = this->Colored;
  this->Width = size[0];
  this->Height = size[1];
  this->SurfacesDrawn.clear();
  this->VerdictsDrawn.clear();
  this->Checked = false;
  if (!this->Arrays)
  {
    glGenVertexArrays(1, &this->Arrays);
    glGenTextures(Count, this->Textures);
    this->Framebuffer = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
    this->Framebuffer->SetContext(this->Window);
  }
  for (int i = 0; i < 16 && glGetError() != GL_NO_ERROR; ++i)
  {
    // Clears earlier errors, to detect errors of the calls below.
  }
  // Surfaces within one step of the picture's depth hide each other as in the picture.
  const bool stencil = depths == GL_DEPTH24_STENCIL8;
  const GLint formats[Count] = { GL_RG32F, GL_RG32F, this->Colored ? GL_RGBA32F : GL_R32F,
    static_cast<GLint>(depths), GL_R32F };
  const GLenum channels[Count] = { GL_RG, GL_RG,
    static_cast<GLenum>(this->Colored ? GL_RGBA : GL_RED),
    static_cast<GLenum>(stencil ? GL_DEPTH_STENCIL : GL_DEPTH_COMPONENT), GL_RED };
  this->Window->GetState()->vtkglActiveTexture(
    GL_TEXTURE0 + static_cast<unsigned int>(this->Units[0]));
  for (int i = 0; i < Count; ++i)
  {
    const int width = i == Before ? 1 : i == Tiles ? CountTiles(this->Width) : this->Width;
    const int height = i == Before ? 1 : i == Tiles ? CountTiles(this->Height) : this->Height;
    glBindTexture(GL_TEXTURE_2D, this->Textures[i]);
    glTexImage2D(GL_TEXTURE_2D, 0, formats[i], width, height, 0, channels[i],
      i == Depth && stencil ? GL_UNSIGNED_INT_24_8 : GL_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  }
  glBindTexture(GL_TEXTURE_2D, 0);
  this->Window->GetState()->vtkglActiveTexture(GL_TEXTURE0);
  this->Room = glGetError() == GL_NO_ERROR; // otherwise each fragment traces rays
  this->RoomForBefore = false;
  return this->Room;
}

//------------------------------------------------------------------------------
// The present surfaces become the previous ones. False if OpenGL has no memory for both.
bool vtkRelievoVisibilityPrepass::KeepSurfaces()
{
  if (!this->RoomForBefore)
  {
    for (int i = 0; i < 16 && glGetError() != GL_NO_ERROR; ++i)
    {
      // Clears earlier errors, to detect errors of the calls below.
    }
    this->Bind(Before, -1);
    this->Window->GetState()->vtkglActiveTexture(
      GL_TEXTURE0 + static_cast<unsigned int>(this->Units[0]));
    glTexImage2D(
      GL_TEXTURE_2D, 0, GL_RG32F, this->Width, this->Height, 0, GL_RG, GL_FLOAT, nullptr);
    this->RoomForBefore = glGetError() == GL_NO_ERROR;
    this->Bind(-1, -1);
  }
  if (this->RoomForBefore)
  {
    std::swap(this->Textures[Surfaces], this->Textures[Before]);
  }
  return this->RoomForBefore;
}

//------------------------------------------------------------------------------
std::string vtkRelievoVisibilityPrepass::GetSource(const std::string& name) const
{
  std::string source = vtkRelievoShaderLibrary::Get(name);
  if (this->Colored)
  {
    vtkShaderProgram::Substitute(
      source, "//VTK::System::Dec", "//VTK::System::Dec\n#define RELIEVO_SHADOW_COLORED", false);
  }
  return source;
}

//------------------------------------------------------------------------------
// Before building shaders that look up verdicts.
bool vtkRelievoVisibilityPrepass::IsReady()
{
  if (this->Checked)
  {
    return !this->Broken;
  }
  this->Checked = true;
  std::string fault;
  for (const std::string name :
    { "shadow/seen", "shadow/seenGlyphs", "shadow/tiles", "shadow/verdicts" })
  {
    const std::string fragments = name == "shadow/seenGlyphs" ? "shadow/seen" : name;
    const bool compiles =
      this->Window->GetShaderCache()->ReadyShaderProgram(this->GetSource(name + "VS.glsl").c_str(),
        this->GetSource(fragments + "FS.glsl").c_str(), "");
    fault = compiles ? fault : "the shader " + name + " does not compile";
  }
  for (const int target : { Surfaces, Verdicts, Tiles })
  {
    this->BeginDrawing(this->Textures[target], 1, 1);
    const bool deep = target == Surfaces;
    glFramebufferTexture2D(
      GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, deep ? this->Textures[Depth] : 0, 0);
    const GLenum status = glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER);
    glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, 0, 0);
    this->EndDrawing();
    fault = status == GL_FRAMEBUFFER_COMPLETE ? fault : "its framebuffer is incomplete";
  }
  this->Broken = !fault.empty();
  if (this->Broken)
  {
    vtkGenericWarningMacro("Exact shadows are found by each fragment, slowly: " << fault << ".");
  }
  return !this->Broken;
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoVisibilityPrepass::GetBytes() const
{
  const vtkIdType more =
    (this->Colored ? BytesOfColors : 0) + (this->RoomForBefore ? BytesOfBefore : 0);
  return this->Room ? GetBytes(this->Width, this->Height) + more * this->Width * this->Height +
      this->Glyphs.GetBytes()
                    : 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoVisibilityPrepass::GetBytes(int width, int height)
{
  const vtkIdType tiles = static_cast<vtkIdType>(CountTiles(width)) * CountTiles(height);
  return BytesPerPixel * width * height + 4 * tiles;
}

//------------------------------------------------------------------------------
void vtkRelievoVisibilityPrepass::Release(vtkWindow* window)
{
  if (window && this->Window && this->Window != window)
  {
    return; // the resources belong to another window
  }
  const vtkRelievoScopedContext context(window);
  if (window)
  {
    this->Unbind(); // also units without textures
  }
  if (window && window == this->Owner && this->Textures[0])
  {
    glDeleteTextures(Count, this->Textures);
    glDeleteVertexArrays(1, &this->Arrays);
    this->Framebuffer->ReleaseGraphicsResources(window);
  }
  this->Glyphs.Release(window == this->Owner ? window : nullptr);
  std::fill_n(this->Textures, Count, 0);
  std::fill_n(this->Units, 2, -1);
  this->Arrays = 0;
  this->Framebuffer = nullptr;
  this->Room = this->RoomForBefore = this->Fits = this->Broken = this->Checked = false;
  this->Width = this->Height = this->Lights = 0;
  this->SurfacesDrawn.clear();
  this->VerdictsDrawn.clear();
}
