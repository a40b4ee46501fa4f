// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoCasterDraw.h"

#include "vtkActor.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPlaneCollection.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRelievoAccess.h"
#include "vtkRelievoCutSurface.h"
#include "vtkRelievoDepthRaster.h"
#include "vtkRelievoFrameCamera.h"
#include "vtkRelievoHiddenPoints.h"
#include "vtkRelievoPlainActor.h"
#include "vtkRelievoScopedContext.h"
#include "vtkRelievoShaderLibrary.h"
#include "vtkShaderProgram.h"
#include "vtkShaderProperty.h"
#include "vtkSmartPointer.h"
#include "vtkTexture.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <new>
#include <set>

namespace
{
using Access = vtkRelievoAccess::Mapper;

#ifdef RELIEVO_VTK_COMPOSITE_HELPERS
// The helpers of a composite mapper if all are up to date, visible and opaque; else none.
std::vector<vtkOpenGLPolyDataMapper*> GetHelpers(
  vtkCompositePolyDataMapper2* mapper, vtkActor* actor)
{
  using Composite = vtkRelievoAccess::CompositeMapper;
  using Helper = vtkRelievoAccess::CompositeHelper;
  if (!Composite::AreHelpersOf(mapper, actor))
  {
    return {};
  }
  // The helpers may have been deleted after a change of nested blocks.
  std::set<vtkPolyData*> leaves;
  std::size_t drawn = 0;
  auto* tree = vtkCompositeDataSet::SafeDownCast(mapper->GetInputDataObject(0, 0));
  if (!tree)
  {
    return {};
  }
  auto it = vtkSmartPointer<vtkCompositeDataIterator>::Take(tree->NewIterator());
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
  {
    auto* leaf = vtkPolyData::SafeDownCast(it->GetCurrentDataObject());
    drawn += leaf && leaf->GetNumberOfCells() > 0 ? 1 : 0;
    leaves.insert(leaf);
  }
  std::size_t blocks = 0;
  for (const auto& named : Composite::GetHelpers(mapper))
  {
    for (const auto& block : Helper::Blocks(named.second))
    {
      ++blocks;
      if (leaves.count(block.first) == 0)
      {
        return {};
      }
    }
  }
  if (blocks < drawn)
  {
    return {};
  }
  std::vector<vtkOpenGLPolyDataMapper*> found;
  for (const auto& named : Composite::GetHelpers(mapper))
  {
    vtkCompositeMapperHelper2* helper = named.second;
    if (std::strcmp(helper->GetClassName(), "vtkCompositeMapperHelper2") != 0 ||
      Access::BuildTime(helper) < helper->GetMTime() || !Helper::AreBuffersOf(helper, actor))
    {
      return {};
    }
    for (const auto& block : Helper::Blocks(helper))
    {
      if (!block.second->Visibility || !block.second->IsOpaque)
      {
        return {};
      }
    }
    found.push_back(helper);
  }
  return found;
}
#endif

// A buffer of OpenGL's to read in place: software OpenGL does not copy it.
class MappedBuffer
{
public:
  MappedBuffer(vtkOpenGLBufferObject* buffer, std::size_t bytes)
    : Handle(static_cast<GLuint>(buffer->GetHandle()))
  {
    this->WhileBound([&]() {
      this->Data =
        glMapBufferRange(GL_COPY_READ_BUFFER, 0, static_cast<GLsizeiptr>(bytes), GL_MAP_READ_BIT);
    });
  }
  ~MappedBuffer()
  {
    if (this->Data)
    {
      this->WhileBound([]() { glUnmapBuffer(GL_COPY_READ_BUFFER); });
    }
  }
  MappedBuffer(const MappedBuffer&) = delete;
  MappedBuffer& operator=(const MappedBuffer&) = delete;

  const void* Get() const { return this->Data; }

private:
  template <typename Work>
  void WhileBound(Work&& work) const
  {
    GLint other = 0;
    glGetIntegerv(GL_COPY_READ_BUFFER, &other); // its binding has the number of the target
    glBindBuffer(GL_COPY_READ_BUFFER, this->Handle);
    work();
    glBindBuffer(GL_COPY_READ_BUFFER, static_cast<GLuint>(other));
  }

  GLuint Handle;
  void* Data = nullptr;
};
}

//------------------------------------------------------------------------------
vtkRelievoCasterDraw::~vtkRelievoCasterDraw()
{
  this->Release(this->Window);
}

//------------------------------------------------------------------------------
glm::vec2 vtkRelievoCasterDraw::GetOffset(vtkActor* actor)
{
  double factor = 0.0;
  double units = 0.0;
  if (actor->GetMapper() && vtkMapper::GetResolveCoincidentTopology() == VTK_RESOLVE_POLYGON_OFFSET)
  {
    actor->GetMapper()->GetCoincidentTopologyPolygonOffsetParameters(factor, units);
  }
  return glm::vec2(factor, units);
}

//------------------------------------------------------------------------------
bool vtkRelievoCasterDraw::IsOffset(vtkActor* actor)
{
  return GetOffset(actor) != glm::vec2(0.f);
}

//------------------------------------------------------------------------------
vtkActor* vtkRelievoCasterDraw::GetPlainActor(vtkProp* prop) const
{
  vtkActor* actor = this->GetSurface(prop);
  return actor && !IsOffset(actor) ? actor : nullptr;
}

//------------------------------------------------------------------------------
vtkActor* vtkRelievoCasterDraw::GetSurface(vtkProp* prop) const
{
  auto* actor = vtkActor::SafeDownCast(prop);
  return actor && !this->GetBuffers(actor).empty() ? actor : nullptr;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkRelievoCasterDraw::GetBuildTime(vtkActor* actor) const
{
  vtkMTimeType time = 0;
  for (vtkOpenGLPolyDataMapper* mapper : this->GetBuffers(actor))
  {
    time = std::max(time, Access::BuildTime(mapper));
  }
  return time;
}

//------------------------------------------------------------------------------
bool vtkRelievoCasterDraw::DrawsOnlyFaces(vtkActor* actor)
{
  // Exactly these classes of actors and mappers: derived ones may draw differently.
  vtkMapper* mapper = actor->GetMapper();
  if (!mapper || !vtkRelievoPlainActor::IsOfClass(actor))
  {
    return false;
  }
  // The buffers of a mapper that draws several pieces hold the last one.
  auto* pieces = vtkPolyDataMapper::SafeDownCast(mapper);
  if (pieces && pieces->GetNumberOfSubPieces() > 1)
  {
    return false;
  }
  vtkProperty* property = actor->GetProperty();
  vtkPlaneCollection* planes = mapper->GetClippingPlanes();
  return property->GetRepresentation() == VTK_SURFACE && !property->GetVertexVisibility() &&
    !property->GetEdgeVisibility() && !actor->GetTexture() &&
    vtkMapper::GetResolveCoincidentTopology() != VTK_RESOLVE_SHIFT_ZBUFFER &&
    property->GetNumberOfTextures() == 0 && !vtkRelievoPlainActor::HasOwnShaders(actor) &&
    !(vtkRelievoCutSurface::GetCutoff(actor->GetPropertyKeys()) > 0.0) &&
    !(planes && planes->GetNumberOfItems() > 0);
}

//------------------------------------------------------------------------------
std::vector<vtkOpenGLPolyDataMapper*> vtkRelievoCasterDraw::GetBuffers(vtkActor* actor) const
{
  if (!DrawsOnlyFaces(actor))
  {
    return {};
  }
  vtkMapper* mapper = actor->GetMapper();
  std::vector<vtkOpenGLPolyDataMapper*> mappers;
  if (std::strcmp(mapper->GetClassName(), "vtkOpenGLPolyDataMapper") == 0)
  {
    auto* own = static_cast<vtkOpenGLPolyDataMapper*>(mapper);
    mappers.assign(IsCurrent(own, actor) ? 1 : 0, own);
  }
#ifdef RELIEVO_VTK_COMPOSITE_HELPERS
  else if (std::strcmp(mapper->GetClassName(), "vtkCompositePolyDataMapper2") == 0)
  {
    mappers = GetHelpers(static_cast<vtkCompositePolyDataMapper2*>(mapper), actor);
  }
#endif
  const bool built = std::all_of(mappers.begin(), mappers.end(),
    [this](vtkOpenGLPolyDataMapper* each) { return this->IsBuilt(each); });
  return built ? mappers : std::vector<vtkOpenGLPolyDataMapper*>();
}

//------------------------------------------------------------------------------
bool vtkRelievoCasterDraw::IsCurrent(vtkOpenGLPolyDataMapper* mapper, vtkActor* actor)
{
  vtkPolyData* input = mapper->GetInput();
  return input && mapper->CurrentInput == input && Access::BuildTime(mapper) >= input->GetMTime() &&
    Access::BuildTime(mapper) >= mapper->GetMTime() && Access::AreBuffersOf(mapper, actor);
}

//------------------------------------------------------------------------------
bool vtkRelievoCasterDraw::LacksBuffers(vtkProp* prop) const
{
  auto* actor = vtkActor::SafeDownCast(prop);
  if (!actor || !DrawsOnlyFaces(actor) || IsOffset(actor))
  {
    return false;
  }
  const char* kind = actor->GetMapper()->GetClassName();
  if (std::strcmp(kind, "vtkOpenGLPolyDataMapper") == 0)
  {
    auto* mapper = static_cast<vtkOpenGLPolyDataMapper*>(actor->GetMapper());
    vtkPolyData* input = mapper->GetInput();
    return input && input->GetNumberOfVerts() == 0 && input->GetNumberOfLines() == 0 &&
      !(this->IsKnown(mapper) && IsCurrent(mapper, actor));
  }
#ifdef RELIEVO_VTK_COMPOSITE_HELPERS
  return std::strcmp(kind, "vtkCompositePolyDataMapper2") == 0 && this->GetBuffers(actor).empty();
#else
  return false;
#endif
}

//------------------------------------------------------------------------------
bool vtkRelievoCasterDraw::IsKnown(vtkOpenGLPolyDataMapper* mapper) const
{
  const auto known = this->Built.find(mapper);
  return known != this->Built.end() && known->second.Mapper == mapper &&
    known->second.BuildTime == Access::BuildTime(mapper);
}

//------------------------------------------------------------------------------
bool vtkRelievoCasterDraw::IsBuilt(vtkOpenGLPolyDataMapper* mapper) const
{
  if (!this->IsKnown(mapper))
  {
    return false;
  }
  vtkOpenGLVertexBufferObject* vertices = Access::Buffers(mapper)->GetVBO("vertexMC");
  const bool flat = Access::IndexCount(mapper, vtkOpenGLPolyDataMapper::PrimitivePoints) == 0 &&
    Access::IndexCount(mapper, vtkOpenGLPolyDataMapper::PrimitiveLines) == 0;
  return vertices && vertices->GetDataType() == VTK_FLOAT &&
    vertices->GetNumberOfComponents() == 3 && flat;
}

//------------------------------------------------------------------------------
void vtkRelievoCasterDraw::SetWindow(vtkOpenGLRenderWindow* window)
{
  if (this->Window != window)
  {
    this->Release(this->Window);
    this->Window = window;
  }
  // Removes deleted mappers.
  for (auto it = this->Built.begin(); it != this->Built.end();)
  {
    it = it->second.Mapper ? std::next(it) : this->Built.erase(it);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoCasterDraw::Learn(vtkOpenGLPolyDataMapper* mapper)
{
  Known& known = this->Built[mapper];
  if (known.Mapper != mapper)
  {
    known.Mapper = mapper;
  }
  known.BuildTime = Access::BuildTime(mapper);
}

//------------------------------------------------------------------------------
bool vtkRelievoCasterDraw::Begin(vtkOpenGLRenderWindow* window, const glm::dmat4& worldToNDC)
{
  return this->Begin(
    window, worldToNDC, glm::dmat4(1.0), "shadow/casterVS.glsl", "shadow/casterFS.glsl");
}

//------------------------------------------------------------------------------
bool vtkRelievoCasterDraw::Begin(vtkOpenGLRenderWindow* window, const glm::dmat4& worldToNDC,
  const glm::dmat4& worldToView, const std::string& vertexShader, const std::string& fragmentShader,
  const std::string& defines)
{
  std::string fragment = vtkRelievoShaderLibrary::Get(fragmentShader);
  vtkShaderProgram::Substitute(
    fragment, "//VTK::System::Dec", "//VTK::System::Dec\n" + defines, false);
  this->WorldToNDC = worldToNDC;
  this->WorldToView = worldToView;
  this->Program = window->GetShaderCache()->ReadyShaderProgram(
    vtkRelievoShaderLibrary::Get(vertexShader).c_str(), fragment.c_str(), "");
  if (!this->Program)
  {
    return false;
  }
  if (this->Arrays == 0)
  {
    glGenVertexArrays(1, &this->Arrays);
  }
  glBindVertexArray(this->Arrays);
  this->Attribute =
    glGetAttribLocation(static_cast<unsigned int>(this->Program->GetHandle()), "vertexMC");
  glEnableVertexAttribArray(static_cast<unsigned int>(this->Attribute));
  return true;
}

//------------------------------------------------------------------------------
int vtkRelievoCasterDraw::Draw(vtkActor* actor)
{
  int calls = 0;
  for (vtkOpenGLPolyDataMapper* mapper : this->GetBuffers(actor))
  {
    calls += this->Draw(mapper, actor);
  }
  return calls;
}

//------------------------------------------------------------------------------
glm::dmat4 vtkRelievoCasterDraw::GetBufferToWorld(vtkOpenGLPolyDataMapper* mapper, vtkActor* actor)
{
  const glm::dmat4 modelToWorld = vtkRelievoToGlm(actor->GetMatrix());
  return Access::Buffers(mapper)->GetVBO("vertexMC")->GetCoordShiftAndScaleEnabled()
    ? modelToWorld * glm::transpose(vtkRelievoToGlm(Access::ShiftScale(mapper)))
    : modelToWorld;
}

//------------------------------------------------------------------------------
int vtkRelievoCasterDraw::Draw(vtkOpenGLPolyDataMapper* mapper, vtkActor* actor)
{
  vtkOpenGLVertexBufferObject* vertices = Access::Buffers(mapper)->GetVBO("vertexMC");
  const glm::dmat4 modelToWorld = GetBufferToWorld(mapper, actor);
  const glm::mat4 matrix(this->WorldToNDC * modelToWorld);
  this->Program->SetUniformMatrix4x4("MCDCMatrix", const_cast<float*>(&matrix[0][0]));
  if (this->Program->IsUniformUsed("MCVCMatrix"))
  {
    const glm::mat4 toView(this->WorldToView * modelToWorld);
    this->Program->SetUniformMatrix4x4("MCVCMatrix", const_cast<float*>(&toView[0][0]));
  }
  if (this->Program->IsUniformUsed("relievoSeenOffset"))
  {
    const glm::vec2 offset = GetOffset(actor);
    this->Program->SetUniform2f("relievoSeenOffset", &offset.x);
  }
  vertices->Bind();
  glVertexAttribPointer(static_cast<unsigned int>(this->Attribute), 3, GL_FLOAT, GL_FALSE,
    static_cast<GLsizei>(vertices->GetStride()), nullptr);
  const int last = Access::Buffers(mapper)->GetNumberOfTuples("vertexMC") - 1;
  int calls = 0;
  for (const int type :
    { vtkOpenGLPolyDataMapper::PrimitiveTris, vtkOpenGLPolyDataMapper::PrimitiveTriStrips })
  {
    const int count = Access::IndexCount(mapper, type);
    if (count > 0)
    {
      Access::Indices(mapper, type)->Bind();
      glDrawRangeElements(
        GL_TRIANGLES, 0, static_cast<GLuint>(last), count, GL_UNSIGNED_INT, nullptr);
      ++calls;
    }
  }
  vertices->Release();
  return calls;
}

//------------------------------------------------------------------------------
void vtkRelievoCasterDraw::End()
{
  glBindVertexArray(0);
}

//------------------------------------------------------------------------------
void vtkRelievoCasterDraw::Build(vtkProp* prop, vtkRenderer* renderer)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  // Opaque actors are drawn in any frame that is not aborted.
  if (!actor || !actor->GetMapper() || actor->HasTranslucentPolygonalGeometry() ||
    std::strcmp(actor->GetMapper()->GetClassName(), "vtkOpenGLPolyDataMapper") != 0)
  {
    return;
  }
  auto* mapper = static_cast<vtkOpenGLPolyDataMapper*>(actor->GetMapper());
  vtkPolyData* input = mapper->GetInput();
  const bool faces = DrawsOnlyFaces(actor) && input && input->GetNumberOfPoints() > 0 &&
    input->GetNumberOfVerts() == 0 && input->GetNumberOfLines() == 0;
  const bool missing = faces ? this->GetBuffers(actor).empty()
                             : vtkRelievoHiddenPoints::GetMesh(actor) && !IsCurrent(mapper, actor);
  // Buffers that were filled before, but not for this window, may be another window's, which VTK
  // releases when it draws.
  const bool ours = Access::BuildTime(mapper) == 0 || this->IsKnown(mapper);
  if (missing && ours)
  {
    Access::Build(mapper, renderer, actor);
    this->Learn(mapper);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoCasterDraw::Rasterize(vtkActor* actor, const glm::dmat4& worldToNDC,
  const int region[4], bool clamps, vtkRelievoDepthRaster& raster) const
{
  for (vtkOpenGLPolyDataMapper* mapper : this->GetBuffers(actor))
  {
    vtkOpenGLVertexBufferObject* vertices = Access::Buffers(mapper)->GetVBO("vertexMC");
    const auto stride = static_cast<std::size_t>(vertices->GetStride());
    const auto tuples =
      static_cast<std::size_t>(Access::Buffers(mapper)->GetNumberOfTuples("vertexMC"));
    if (tuples == 0)
    {
      continue;
    }
    const MappedBuffer places(vertices, stride * tuples);
    for (const int type :
      { vtkOpenGLPolyDataMapper::PrimitiveTris, vtkOpenGLPolyDataMapper::PrimitiveTriStrips })
    {
      const auto count = static_cast<std::size_t>(Access::IndexCount(mapper, type));
      if (count == 0)
      {
        continue;
      }
      const MappedBuffer corners(Access::Indices(mapper, type), count * sizeof(unsigned int));
      if (!places.Get() || !corners.Get())
      {
        throw std::bad_alloc();
      }
      vtkRelievoDepthRaster::Mesh mesh;
      mesh.Places = static_cast<const float*>(places.Get());
      mesh.Step = stride / sizeof(float);
      mesh.NumberOfPlaces = tuples;
      mesh.Corners = static_cast<const unsigned int*>(corners.Get());
      mesh.Triangles = count / 3;
      raster.Draw(mesh, worldToNDC * GetBufferToWorld(mapper, actor), region, clamps);
    }
  }
}

//------------------------------------------------------------------------------
void vtkRelievoCasterDraw::Release(vtkWindow* window)
{
  if (window && this->Window && this->Window != window)
  {
    return; // the resources belong to another window
  }
  if (window && this->Arrays)
  {
    const vtkRelievoScopedContext context(window);
    glDeleteVertexArrays(1, &this->Arrays);
  }
  this->Arrays = 0;
  this->Program = nullptr;
  this->Built.clear();
}
