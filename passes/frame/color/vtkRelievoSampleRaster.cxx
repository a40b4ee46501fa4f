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
#include "vtkPolyDataMapper.h"
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
#include <functional>
#include <iomanip>
#include <memory>
#include <regex>
#include <sstream>
#include <utility>

namespace
{
// Cells of a raster drawn at once, at 12 bytes each; fewer for marked pixels, if their triangles
// are drawn alone: more rasters have less between the pixels, but each is drawn with all shaders.
constexpr double MostCells = 1 << 24;
constexpr double MostCellsOfMarked = 1 << 21;

double CountCells(const glm::ivec2& size)
{
  return static_cast<double>(size.x) * size.y;
}

bool IsWithin(const glm::ivec2& size, const glm::ivec2& room)
{
  return size.x <= room.x && size.y <= room.y;
}

// Samples per pixel before the marks are known.
constexpr int FewSamples = 5;

// The width of lines and points depends on the size of a pixel.
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

// Whether a mesh lies in one plane: no part hides another, and it can be blended in any order.
bool IsFlat(vtkDataObject* data)
{
  auto* mesh = vtkPolyData::SafeDownCast(data);
  if (!mesh || mesh->GetNumberOfPolys() == 0)
  {
    return false;
  }
  // Reads only the polygons: GetCell() would make the mesh build a table of all cells.
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

// Whether a user's shader code depends on the pixel; the raster has other pixels.
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

// Whether a mesh has no cells.
bool IsEmpty(vtkMapper* mapper)
{
  auto* meshes = vtkPolyDataMapper::SafeDownCast(mapper);
  return meshes && meshes->GetInput() && meshes->GetInput()->GetNumberOfCells() == 0;
}

// Classes are compared by name: subclasses may draw anything.
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
    return std::string("a ") + actor->GetClassName() + " draws in another way than plain actors";
  }
  if (property->GetRepresentation() != VTK_SURFACE || property->GetEdgeVisibility() ||
    property->GetVertexVisibility())
  {
    return "lines or points are drawn";
  }
  if (ReadsPixel(actor))
  {
    return "an actor's own shaders depend on the pixel";
  }
  mapper->GetBounds(); // updates the mapper's input
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
    return tree || name != "vtkOpenGLGlyph3DMapper" ? "glyphs are drawn by another class of mapper"
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
      continue; // drawn over the finished picture, unlike leaders of captions
    }
    auto* actor = vtkActor::SafeDownCast(props[i]);
    const std::string obstacle = actor
      ? ::FindObstacle(actor)
      : std::string("a ") + props[i]->GetClassName() + " is not a plain surface";
    if (!obstacle.empty())
    {
      return obstacle;
    }
    if (actor->GetMapper() && actor->HasTranslucentPolygonalGeometry() &&
      (++translucent > 1 || !IsFlat(actor->GetMapper()->GetInputDataObject(0, 0))))
    {
      return "translucent surfaces may overlap";
    }
  }
  return {};
}

//------------------------------------------------------------------------------
// Divides a part of the viewport into columns and rows whose rasters fit.
std::vector<vtkRelievoSampleRaster::Part> vtkRelievoSampleRaster::Divide(
  const vtkRelievoSampleLattice& lattice, const Part& part,
  const std::function<bool(const glm::ivec2&)>& fits)
{
  const glm::ivec2 all(part[2], part[3]);
  glm::ivec2 count(1);
  const auto getPixels = [&]() { return (all + count - 1) / count; };
  while (!fits(lattice.GetSize(getPixels())) && (getPixels().x > 1 || getPixels().y > 1))
  {
    getPixels().x > getPixels().y ? ++count.x : ++count.y;
  }
  const glm::ivec2 pixels = getPixels();
  std::vector<Part> parts;
  for (int y = 0; y < all.y; y += pixels.y)
  {
    for (int x = 0; x < all.x; x += pixels.x)
    {
      parts.push_back(
        { part[0] + x, part[1] + y, std::min(pixels.x, all.x - x), std::min(pixels.y, all.y - y) });
    }
  }
  return parts;
}

//------------------------------------------------------------------------------
vtkRelievoSampleRaster::vtkRelievoSampleRaster()
  : FewOfEach(FewSamples)
{
}

//------------------------------------------------------------------------------
// Takes another grid's textures if they are large enough.
std::string vtkRelievoSampleRaster::Grid::Make(vtkRelievoFrameContext& context,
  const vtkRelievoSampleLattice& lattice, const std::vector<Part>& parts, Grid* spare)
{
  this->Lattice = &lattice;
  this->Cells.clear();
  for (const glm::ivec2& cell : lattice.GetCells())
  {
    this->Cells.push_back(static_cast<float>(cell.x));
    this->Cells.push_back(static_cast<float>(cell.y));
  }
  glm::ivec2 size(0);
  for (const Part& part : parts)
  {
    size = glm::max(size, lattice.GetSize({ part[2], part[3] }));
  }
  if (spare && IsWithin(size, spare->GetRoom()))
  {
    std::swap(this->Framebuffer, spare->Framebuffer);
    std::swap(this->Color, spare->Color);
    std::swap(this->Depth, spare->Depth);
    return {};
  }
  this->Color = vtkRelievoColorBuffers::MakeTexture(context.Window, GL_RGBA16F, size.x, size.y);
  this->Depth = vtkSmartPointer<vtkTextureObject>::New();
  this->Depth->SetContext(context.Window);
  this->Depth->AllocateDepth(static_cast<unsigned int>(size.x), static_cast<unsigned int>(size.y),
    vtkTextureObject::Float32);
  this->Framebuffer = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
  this->Framebuffer->SetContext(context.Window);
  this->Framebuffer->Bind();
  this->Framebuffer->AddColorAttachment(0, this->Color);
  this->Framebuffer->AddDepthAttachment(this->Depth);
  this->Framebuffer->ActivateDrawBuffer(0);
  return glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE
    ? std::string()
    : "this OpenGL cannot draw to half floats of " + std::to_string(size.x) + " x " +
      std::to_string(size.y) + " pixels";
}

//------------------------------------------------------------------------------
// Size in cells of its textures.
glm::ivec2 vtkRelievoSampleRaster::Grid::GetRoom() const
{
  return this->Color ? glm::ivec2(this->Color->GetWidth(), this->Color->GetHeight())
                     : glm::ivec2(0);
}

//------------------------------------------------------------------------------
glm::dmat4 vtkRelievoSampleRaster::Grid::GetToRaster(
  const vtkRelievoFrameContext& context, const Part& part) const
{
  const int* viewport = context.View.Viewport;
  return this->Lattice->GetToRaster({ viewport[2], viewport[3] }, part.data());
}

//------------------------------------------------------------------------------
// Clears to the nearest depth, and the colour of the drawn area.
void vtkRelievoSampleRaster::Grid::Bind(vtkRelievoFrameContext& context, const Part& part)
{
  const glm::ivec2 pixels(part[2], part[3]);
  const glm::ivec2 size = this->Lattice->GetSize(pixels);
  const glm::ivec2 first = this->Lattice->GetOrigin(pixels) - part[0] * this->Lattice->GetRight() -
    part[1] * this->Lattice->GetUp();
  std::copy_n(&first.x, 2, this->First);
  vtkOpenGLState* state = context.Window->GetState();
  this->Framebuffer->Bind();
  state->vtkglViewport(0, 0, size.x, size.y);
  state->vtkglScissor(0, 0, size.x, size.y);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglDepthMask(GL_TRUE);
  const float nearest = 0.0f;
  glClearBufferfv(GL_DEPTH, 0, &nearest);
}

//------------------------------------------------------------------------------
void vtkRelievoSampleRaster::Grid::Free(vtkWindow* window)
{
  if (this->Framebuffer)
  {
    this->Framebuffer->ReleaseGraphicsResources(window);
    this->Color->ReleaseGraphicsResources(window);
    this->Depth->ReleaseGraphicsResources(window);
  }
  this->Framebuffer = nullptr;
  this->Color = nullptr;
  this->Depth = nullptr;
}

//------------------------------------------------------------------------------
// Whether a first drawing with few samples pays.
bool vtkRelievoSampleRaster::HasFew(const vtkRelievoFrameContext& context)
{
  return context.Lattice->GetNumberOfSamples() > 2 * FewSamples;
}

//------------------------------------------------------------------------------
void vtkRelievoSampleRaster::Begin(
  vtkRelievoFrameContext& context, const vtkRelievoColorTarget& target)
{
  target.GetDrawnPart(this->Drawn.data());
  vtkOpenGLState* state = context.Window->GetState();
  state->PushFramebufferBindings();
  if (this->Drawn[2] <= 0 || this->Drawn[3] <= 0)
  {
    return;
  }
  const vtkRelievoSampleLattice& lattice = HasFew(context) ? this->FewOfEach : *context.Lattice;
  this->Parts =
    Divide(lattice, this->Drawn, [](const auto& size) { return CountCells(size) <= MostCells; });
  this->Fault = this->Few.Make(context, lattice, this->Parts, nullptr);
  this->Fault.empty() ? this->Begin(context, this->Few, this->Parts.front(), false)
                      : this->Leave(context);
}

//------------------------------------------------------------------------------
// Limits shading to the part: the raster extends beyond it.
void vtkRelievoSampleRaster::Begin(
  vtkRelievoFrameContext& context, Grid& grid, const Part& part, bool marked)
{
  const glm::dmat4 toRaster = grid.GetToRaster(context, part);
  const glm::dmat4 projection = toRaster * context.View.ViewToNDC;
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
  grid.Bind(context, part);
  this->Fault = marked ? this->Marks.Draw(context, toRaster)
                       : this->Marks.DrawPart(context, part.data(), toRaster);
  this->Drawing = &grid;
}

//------------------------------------------------------------------------------
// Transfers the raster's drawing to the target.
void vtkRelievoSampleRaster::End(
  vtkRelievoFrameContext& context, vtkRelievoColorTarget& target, const Part& part, bool marked)
{
  this->Projection.reset();
  const std::string defines = marked ? "#define RELIEVO_MARKED\n" : "";
  std::vector<vtkRelievoResourceName> reads = { vtkRelievoResources::Drawn,
    vtkRelievoResources::Samples };
  if (marked)
  {
    reads.push_back(vtkRelievoResources::Marks);
  }
  vtkRelievoScreenQuad& mean = marked ? this->MeanOfMarked : this->Mean;
  if (!mean.Ready(context, "frame/samplesFS.glsl", reads, defines) ||
    (!marked &&
      !this->Nearest.Ready(context, "frame/samplesFS.glsl", { vtkRelievoResources::Samples },
        "#define RELIEVO_DEPTH\n")))
  {
    this->Fault = mean.GetError() + this->Nearest.GetError();
    return;
  }
  target.Put(context, mean, marked ? nullptr : &this->Nearest, part.data());
}

//------------------------------------------------------------------------------
// Draws all samples of the pixels marked by few samples.
void vtkRelievoSampleRaster::DrawMarked(
  vtkRelievoFrameContext& context, vtkRelievoColorTarget& target)
{
  bool possible = true;
  vtkProp** props = context.State->GetPropArray();
  for (int i = 0; i < context.State->GetPropArrayCount(); ++i)
  {
    auto* actor = vtkActor::SafeDownCast(props[i]);
    const bool draws = actor && actor->GetMapper() && !IsEmpty(actor->GetMapper());
    this->Triangles.emplace_back(draws ? new vtkRelievoMarkedTriangles(actor) : nullptr);
    possible = possible && (!draws || this->Triangles.back()->IsPossible());
  }
  Part marked = this->Drawn;
  this->Marks.Choose(marked);
  // New memory costs more than smaller parts, if they are not much smaller. In a much larger raster
  // their rows would be far apart.
  const double most = possible ? MostCellsOfMarked : MostCells;
  const glm::ivec2 room = this->Few.GetRoom();
  const bool reuses = possible && CountCells(room) >= 0.5 * most && CountCells(room) <= 2.0 * most;
  std::vector<Part> parts;
  for (Part part : Divide(*context.Lattice, marked, [&](const auto& size) {
         return CountCells(size) <= most && (!reuses || IsWithin(size, room));
       }))
  {
    if (this->Marks.Choose(part))
    {
      parts.push_back(part);
    }
  }
  for (const auto& triangles : this->Triangles)
  {
    if (triangles)
    {
      triangles->Find(context, this->Marks, parts);
    }
  }
  this->Fault = this->All.Make(context, *context.Lattice, parts, reuses ? &this->Few : nullptr);
  for (std::size_t i = 0; i < parts.size() && this->Fault.empty(); ++i)
  {
    this->Marks.Choose(parts[i]);
    this->Begin(context, this->All, parts[i], true);
    this->DrawActors(context, i, false);
    this->DrawTranslucent(context, i);
    this->End(context, target, parts[i], true);
  }
  this->Triangles.clear();
}

//------------------------------------------------------------------------------
// Draws the actors' opaque or translucent geometry; for marked pixels, the triangles in the part.
void vtkRelievoSampleRaster::DrawActors(
  const vtkRelievoFrameContext& context, std::size_t part, bool translucent)
{
  vtkProp** props = context.State->GetPropArray();
  for (int i = 0; i < context.State->GetPropArrayCount(); ++i)
  {
    auto* actor = vtkActor::SafeDownCast(props[i]);
    if (!actor ||
      !(translucent ? actor->HasTranslucentPolygonalGeometry() : actor->HasOpaqueGeometry()))
    {
      continue;
    }
    vtkRelievoMarkedTriangles* triangles =
      this->Triangles.empty() ? nullptr : this->Triangles[i].get();
    if (!triangles || triangles->Begin(part))
    {
      translucent ? actor->RenderTranslucentPolygonalGeometry(context.Renderer)
                  : actor->RenderOpaqueGeometry(context.Renderer);
    }
    if (triangles)
    {
      triangles->End();
    }
  }
}

//------------------------------------------------------------------------------
void vtkRelievoSampleRaster::DrawTranslucent(vtkRelievoFrameContext& context, std::size_t part)
{
  vtkOpenGLState* state = context.Window->GetState();
  const vtkRelievoScopedState kept(state);
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(
    GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  this->DrawActors(context, part, true);
}

//------------------------------------------------------------------------------
void vtkRelievoSampleRaster::End(vtkRelievoFrameContext& context, vtkRelievoColorTarget& target)
{
  context.Provide(vtkRelievoResources::Samples, this);
  context.Provide(vtkRelievoResources::Marks, &this->Marks);
  const bool marks = !this->Parts.empty() && HasFew(context);
  if (!this->Parts.empty())
  {
    target.Resolve(context);
  }
  if (marks)
  {
    this->Fault = this->Marks.Begin(context, this->Drawn.data());
  }
  for (std::size_t i = 0; i < this->Parts.size() && this->Fault.empty(); ++i)
  {
    if (i > 0)
    {
      this->Begin(context, this->Few, this->Parts[i], false);
      this->DrawActors(context, i, false);
    }
    this->DrawTranslucent(context, i);
    this->End(context, target, this->Parts[i], false);
    if (marks && this->Fault.empty())
    {
      this->Fault = this->Marks.Find(context, this->Parts[i].data());
    }
  }
  if (marks && this->Fault.empty())
  {
    this->Fault = this->Marks.Collect(this->Drawn.data());
    if (this->Fault.empty() && this->Marks.GetNumber() > 0)
    {
      this->DrawMarked(context, target);
    }
  }
  context.MeanWords = this->Describe(context);
  this->Leave(context);
}

//------------------------------------------------------------------------------
std::string vtkRelievoSampleRaster::Describe(const vtkRelievoFrameContext& context) const
{
  std::ostringstream out;
  out << context.Lattice->GetNumberOfSamples() << " samples";
  if (HasFew(context))
  {
    const int* viewport = context.View.Viewport;
    const double pixels = static_cast<double>(viewport[2]) * viewport[3];
    const std::size_t marked = this->Parts.empty() ? 0 : this->Marks.GetNumber();
    out << " in " << std::fixed << std::setprecision(1)
        << 100.0 * static_cast<double>(marked) / std::max(1.0, pixels) << " % of the pixels and "
        << FewSamples << " in the others,";
  }
  out << " drawn at once";
  return out.str();
}

//------------------------------------------------------------------------------
void vtkRelievoSampleRaster::Leave(vtkRelievoFrameContext& context)
{
  vtkOpenGLState* state = context.Window->GetState();
  state->PopFramebufferBindings();
  const int* v = context.View.Viewport;
  state->vtkglViewport(v[0], v[1], v[2], v[3]);
  state->vtkglScissor(v[0], v[1], v[2], v[3]);
  // Frees the buffers until another picture is drawn.
  this->Free(context.Window);
}

//------------------------------------------------------------------------------
std::string vtkRelievoSampleRaster::GetDefines() const
{
  return "#define RELIEVO_SAMPLES " + std::to_string(this->Drawing->Cells.size() / 2) + "\n";
}

//------------------------------------------------------------------------------
void vtkRelievoSampleRaster::Activate(vtkShaderProgram* program)
{
  const Grid& grid = *this->Drawing;
  grid.Color->Activate();
  grid.Depth->Activate();
  program->SetUniformi("relievoRasterColor", grid.Color->GetTextureUnit());
  program->SetUniformi("relievoRasterZ", grid.Depth->GetTextureUnit());
  program->SetUniform2i("relievoRasterFirst", grid.First);
  program->SetUniform2i("relievoRasterRight", &grid.Lattice->GetRight().x);
  program->SetUniform2i("relievoRasterUp", &grid.Lattice->GetUp().x);
  program->SetUniform2fv("relievoRasterCells", static_cast<int>(grid.Cells.size() / 2),
    reinterpret_cast<const float(*)[2]>(grid.Cells.data()));
}

//------------------------------------------------------------------------------
void vtkRelievoSampleRaster::Deactivate()
{
  this->Drawing->Color->Deactivate();
  this->Drawing->Depth->Deactivate();
}

//------------------------------------------------------------------------------
void vtkRelievoSampleRaster::Release(vtkWindow* window)
{
  this->Free(window);
  this->Marks.Release(window);
  this->Mean.Release(window);
  this->MeanOfMarked.Release(window);
  this->Nearest.Release(window);
  this->Fault.clear();
}

//------------------------------------------------------------------------------
void vtkRelievoSampleRaster::Free(vtkWindow* window)
{
  this->Projection.reset();
  this->Few.Free(window);
  this->All.Free(window);
  this->Parts.clear();
}
