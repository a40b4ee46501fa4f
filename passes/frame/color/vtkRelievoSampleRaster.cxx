// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSampleRaster.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkGlyph3DMapper.h"
#include "vtkIdList.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPlane.h"
#include "vtkPolyData.h"
#include "vtkPolygon.h"
#include "vtkProperty.h"
#include "vtkRelievoColorBuffers.h"
#include "vtkRelievoColorTarget.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoPlainActor.h"
#include "vtkRelievoSampleLattice.h"
#include "vtkRelievoScopedState.h"
#include "vtkRelievoShaderLibrary.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkShaderProperty.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <regex>
#include <sstream>

namespace
{
// Cells of a raster that is drawn at once: 12 bytes each.
constexpr double MostCells = 1 << 24;

// Lines and points are as wide as pixels are.
bool DrawsSurfacesOnly(vtkDataObject* data)
{
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    auto leaf = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
    {
      if (!DrawsSurfacesOnly(leaf->GetCurrentDataObject()))
      {
        return false;
      }
    }
    return true;
  }
  auto* mesh = vtkPolyData::SafeDownCast(data);
  return mesh && mesh->GetNumberOfVerts() == 0 && mesh->GetNumberOfLines() == 0;
}

// Whether a mesh lies in one plane: then no part is behind another, and it blends in any order.
bool IsFlat(vtkDataObject* data)
{
  auto* mesh = vtkPolyData::SafeDownCast(data);
  if (!mesh || mesh->GetNumberOfPolys() == 0)
  {
    return false;
  }
  // Of the polygons alone: asked for a cell, the mesh would build a table of all.
  vtkNew<vtkIdList> corners;
  mesh->GetPolys()->GetCellAtId(0, corners);
  const double tolerance = 1e-6 * mesh->GetLength();
  double origin[3];
  double normal[3];
  mesh->GetPoint(corners->GetId(0), origin);
  vtkPolygon::ComputeNormal(
    mesh->GetPoints(), static_cast<int>(corners->GetNumberOfIds()), corners->GetPointer(0), normal);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double point[3];
    mesh->GetPoint(i, point);
    if (!(vtkPlane::DistanceToPlane(point, normal, origin) <= tolerance))
    {
      return false;
    }
  }
  return vtkMath::Norm(normal) > 0.0;
}

// Whether a user's own shader code depends on the pixel: the raster has other ones.
bool ReadsPixel(vtkActor* actor)
{
  vtkShaderProperty* shaders = actor->GetShaderProperty();
  std::string all;
  for (const char* code : { shaders->GetFragmentShaderCode(), shaders->GetGeometryShaderCode() })
  {
    all += code ? code : "";
  }
  for (int i = 0; i < shaders->GetNumberOfShaderReplacements(); ++i)
  {
    std::string name;
    std::string text;
    bool first = false;
    bool each = false;
    shaders->GetNthShaderReplacement(i, name, first, text, each);
    all += text;
  }
  if (all.empty())
  {
    return false;
  }
  std::istringstream pattern(vtkRelievoShaderLibrary::GetSection("frame/pixel.glsl", "Use"));
  std::string use;
  std::getline(pattern, use);
  return std::regex_search(all, std::regex(use));
}

// Classes are compared by name: what is derived from them may draw anything.
std::string FindObstacle(vtkActor* actor)
{
  vtkMapper* mapper = actor->GetMapper();
  if (!mapper)
  {
    return {}; // draws nothing
  }
  vtkProperty* property = actor->GetProperty();
  if (!vtkRelievoPlainActor::IsOfClass(actor))
  {
    return std::string("a ") + actor->GetClassName() + " draws otherwise than plain actors";
  }
  if (property->GetRepresentation() != VTK_SURFACE || property->GetEdgeVisibility() ||
    property->GetVertexVisibility())
  {
    return "lines or points are drawn";
  }
  if (ReadsPixel(actor))
  {
    return "an actor's own shaders know the pixel";
  }
  mapper->GetBounds(); // brings its input up to date
  const std::string name = mapper->GetClassName();
  if (auto* glyphs = vtkGlyph3DMapper::SafeDownCast(mapper))
  {
    const bool tree = glyphs->GetSourceTableTree() != nullptr;
    for (int i = 0; !tree && i < glyphs->GetNumberOfInputConnections(1); ++i)
    {
      if (!DrawsSurfacesOnly(glyphs->GetInputDataObject(1, i)))
      {
        return "lines or points are drawn";
      }
    }
    return tree || name != "vtkOpenGLGlyph3DMapper" ? "glyphs are drawn in a way of their own"
                                                    : std::string();
  }
  if (name != "vtkOpenGLPolyDataMapper" && name != "vtkCompositePolyDataMapper2" &&
    name != "vtkCompositePolyDataMapper" && name != "vtkDataSetMapper")
  {
    return "a " + name + " draws";
  }
  return DrawsSurfacesOnly(mapper->GetInputDataObject(0, 0)) ? std::string()
                                                             : "lines or points are drawn";
}
}

//------------------------------------------------------------------------------
std::string vtkRelievoSampleRaster::FindObstacle(const vtkRelievoFrameContext& context)
{
  vtkRenderer* renderer = context.Renderer;
  if (!context.OwnSteps || context.Nested || context.Controller)
  {
    return "a pass draws the picture";
  }
  if (renderer->GetUseFXAA() || renderer->GetUseSSAO() || context.Window->GetStereoRender())
  {
    return "VTK draws several pictures";
  }
  int translucent = 0;
  vtkProp** props = context.State->GetPropArray();
  for (int i = 0; i < context.State->GetPropArrayCount(); ++i)
  {
    if (props[i]->IsA("vtkActor2D") && !props[i]->IsA("vtkCaptionActor2D"))
    {
      continue; // over the finished picture, which leaders of captions are not
    }
    auto* actor = vtkActor::SafeDownCast(props[i]);
    const std::string obstacle = actor
      ? ::FindObstacle(actor)
      : std::string("a ") + props[i]->GetClassName() + " is no plain surface";
    if (!obstacle.empty())
    {
      return obstacle;
    }
    if (actor->GetMapper() && actor->HasTranslucentPolygonalGeometry() &&
      (++translucent > 1 || !IsFlat(actor->GetMapper()->GetInputDataObject(0, 0))))
    {
      return "translucent surfaces may be behind each other";
    }
  }
  return {};
}

//------------------------------------------------------------------------------
// The part that is drawn on, in columns and rows that the raster has room for.
void vtkRelievoSampleRaster::FindParts(const vtkRelievoFrameContext& context, const int drawn[4])
{
  this->Parts.clear();
  if (drawn[2] <= 0 || drawn[3] <= 0)
  {
    return;
  }
  const glm::ivec2 all(drawn[2], drawn[3]);
  glm::ivec2 count(1);
  const auto getPixels = [&]() { return (all + count - 1) / count; };
  const auto countCells = [&]() {
    const glm::dvec2 size(context.Lattice->GetSize(getPixels()));
    return size.x * size.y;
  };
  while (countCells() > MostCells && (getPixels().x > 1 || getPixels().y > 1))
  {
    const glm::ivec2 pixels = getPixels();
    pixels.x > pixels.y ? ++count.x : ++count.y;
  }
  const glm::ivec2 pixels = getPixels();
  const glm::ivec2 size = context.Lattice->GetSize(pixels);
  this->Size[0] = size.x;
  this->Size[1] = size.y;
  for (int y = 0; y < all.y; y += pixels.y)
  {
    for (int x = 0; x < all.x; x += pixels.x)
    {
      this->Parts.push_back({ drawn[0] + x, drawn[1] + y, std::min(pixels.x, all.x - x),
        std::min(pixels.y, all.y - y) });
    }
  }
}

//------------------------------------------------------------------------------
void vtkRelievoSampleRaster::Begin(
  vtkRelievoFrameContext& context, const vtkRelievoColorTarget& target)
{
  const vtkRelievoSampleLattice& lattice = *context.Lattice;
  std::copy_n(&lattice.GetRight().x, 2, this->Right);
  std::copy_n(&lattice.GetUp().x, 2, this->Up);
  this->Cells.clear();
  for (const glm::ivec2& cell : lattice.GetCells())
  {
    this->Cells.push_back(static_cast<float>(cell.x));
    this->Cells.push_back(static_cast<float>(cell.y));
  }
  int drawn[4];
  target.GetDrawnPart(drawn);
  this->FindParts(context, drawn);
  vtkOpenGLState* state = context.Window->GetState();
  state->PushFramebufferBindings();
  if (this->Parts.empty())
  {
    return;
  }
  const auto width = static_cast<unsigned int>(this->Size[0]);
  const auto height = static_cast<unsigned int>(this->Size[1]);
  this->Color =
    vtkRelievoColorBuffers::MakeTexture(context.Window, GL_RGBA16F, this->Size[0], this->Size[1]);
  this->Depth = vtkSmartPointer<vtkTextureObject>::New();
  this->Depth->SetContext(context.Window);
  this->Depth->AllocateDepth(width, height, vtkTextureObject::Float32);
  this->Framebuffer = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
  this->Framebuffer->SetContext(context.Window);
  this->Framebuffer->Bind();
  this->Framebuffer->AddColorAttachment(0, this->Color);
  this->Framebuffer->AddDepthAttachment(this->Depth);
  this->Framebuffer->ActivateDrawBuffer(0);
  if (glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
  {
    this->Fault = "this OpenGL cannot draw to half floats of " + std::to_string(width) + " x " +
      std::to_string(height) + " pixels";
    this->Leave(context);
    return;
  }
  this->BeginPart(context, this->Parts.front());
}

//------------------------------------------------------------------------------
void vtkRelievoSampleRaster::BeginPart(vtkRelievoFrameContext& context, const Part& part)
{
  const vtkRelievoFrameCamera& view = context.View;
  const glm::ivec2 pixels(part[2], part[3]);
  const glm::ivec2 size = context.Lattice->GetSize(pixels);
  const glm::dmat4 projection =
    context.Lattice->GetToRaster({ view.Viewport[2], view.Viewport[3] }, part.data()) *
    view.ViewToNDC;
  vtkNew<vtkMatrix4x4> matrix;
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      matrix->SetElement(row, column, projection[column][row]);
    }
  }
  this->Projection.reset();
  this->Projection.emplace(context.Renderer->GetActiveCamera(), matrix);
  vtkOpenGLState* state = context.Window->GetState();
  this->Framebuffer->Bind();
  state->vtkglViewport(0, 0, size.x, size.y);
  state->vtkglScissor(0, 0, size.x, size.y);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglDepthMask(GL_TRUE);
  const float nothing[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
  const float far = 1.0f;
  glClearBufferfv(GL_COLOR, 0, nothing);
  glClearBufferfv(GL_DEPTH, 0, &far);
}

//------------------------------------------------------------------------------
void vtkRelievoSampleRaster::EndPart(
  vtkRelievoFrameContext& context, vtkRelievoColorTarget& target, const Part& part)
{
  this->Projection.reset();
  const glm::ivec2 first = context.Lattice->GetOrigin({ part[2], part[3] }) -
    part[0] * context.Lattice->GetRight() - part[1] * context.Lattice->GetUp();
  this->First[0] = first.x;
  this->First[1] = first.y;
  context.Provide("samples", this);
  const std::string samples =
    "#define RELIEVO_SAMPLES " + std::to_string(this->Cells.size() / 2) + "\n";
  if (!this->Mean.Ready(context, "frame/samplesFS.glsl", { "drawn", "samples" }, samples) ||
    !this->Nearest.Ready(
      context, "frame/samplesFS.glsl", { "samples" }, samples + "#define RELIEVO_DEPTH\n"))
  {
    this->Fault = this->Mean.GetWrong() + this->Nearest.GetWrong();
    return;
  }
  target.Put(context, this->Mean, this->Nearest, part.data());
}

//------------------------------------------------------------------------------
// The delegate draws translucent surfaces again later, beneath the means.
void vtkRelievoSampleRaster::DrawTranslucent(vtkRelievoFrameContext& context)
{
  vtkOpenGLState* state = context.Window->GetState();
  const vtkRelievoScopedState kept(state);
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(
    GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  vtkProp** props = context.State->GetPropArray();
  for (int i = 0; i < context.State->GetPropArrayCount(); ++i)
  {
    if (vtkActor::SafeDownCast(props[i]) && props[i]->HasTranslucentPolygonalGeometry())
    {
      props[i]->RenderTranslucentPolygonalGeometry(context.Renderer);
    }
  }
}

//------------------------------------------------------------------------------
void vtkRelievoSampleRaster::End(vtkRelievoFrameContext& context, vtkRelievoColorTarget& target)
{
  if (!this->Parts.empty())
  {
    target.Resolve(context);
    this->DrawTranslucent(context);
    this->EndPart(context, target, this->Parts.front());
  }
  vtkProp** props = context.State->GetPropArray();
  for (std::size_t i = 1; i < this->Parts.size(); ++i)
  {
    this->BeginPart(context, this->Parts[i]);
    for (int j = 0; j < context.State->GetPropArrayCount(); ++j)
    {
      if (vtkActor::SafeDownCast(props[j]))
      {
        props[j]->RenderOpaqueGeometry(context.Renderer);
      }
    }
    this->DrawTranslucent(context);
    this->EndPart(context, target, this->Parts[i]);
  }
  this->Leave(context);
}

//------------------------------------------------------------------------------
void vtkRelievoSampleRaster::Leave(vtkRelievoFrameContext& context)
{
  vtkOpenGLState* state = context.Window->GetState();
  state->PopFramebufferBindings();
  const int* v = context.View.Viewport;
  state->vtkglViewport(v[0], v[1], v[2], v[3]);
  state->vtkglScissor(v[0], v[1], v[2], v[3]);
  // Nothing of it is needed until another picture is drawn.
  this->Free(context.Window);
}

//------------------------------------------------------------------------------
void vtkRelievoSampleRaster::Activate(vtkShaderProgram* program)
{
  this->Color->Activate();
  this->Depth->Activate();
  program->SetUniformi("relievoRasterColor", this->Color->GetTextureUnit());
  program->SetUniformi("relievoRasterZ", this->Depth->GetTextureUnit());
  program->SetUniform2i("relievoRasterFirst", this->First);
  program->SetUniform2i("relievoRasterRight", this->Right);
  program->SetUniform2i("relievoRasterUp", this->Up);
  program->SetUniform2fv("relievoRasterCells", static_cast<int>(this->Cells.size() / 2),
    reinterpret_cast<const float(*)[2]>(this->Cells.data()));
}

//------------------------------------------------------------------------------
void vtkRelievoSampleRaster::Deactivate()
{
  this->Color->Deactivate();
  this->Depth->Deactivate();
}

//------------------------------------------------------------------------------
void vtkRelievoSampleRaster::Release(vtkWindow* window)
{
  this->Free(window);
  this->Mean.Release(window);
  this->Nearest.Release(window);
  this->Fault.clear();
}

//------------------------------------------------------------------------------
void vtkRelievoSampleRaster::Free(vtkWindow* window)
{
  this->Projection.reset();
  if (this->Framebuffer)
  {
    this->Framebuffer->ReleaseGraphicsResources(window);
    this->Color->ReleaseGraphicsResources(window);
    this->Depth->ReleaseGraphicsResources(window);
  }
  this->Framebuffer = nullptr;
  this->Color = nullptr;
  this->Depth = nullptr;
  this->Parts.clear();
}
