// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoTreeBuffer.h"

#include "vtkObject.h"
#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLRenderWindow.h"
#include "vtkPolyData.h"
#include "vtkRelievoMatrix.h"
#include "vtkRelievoThreads.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <new>
#include <sstream>

namespace
{
constexpr std::size_t MostRecords = vtkRelievoBoxTree::MostLeaves;

bool IsSame(const vtkRelievoPlacedMesh& a, const vtkRelievoPlacedMesh& b)
{
  return a.Mesh == b.Mesh && a.MeshToWorld == b.MeshToWorld && a.Places == b.Places &&
    a.Opacity == b.Opacity && a.Color == b.Color && a.Reach == b.Reach;
}

constexpr double Ulp = 1.0 / (1 << 23);

// The next smaller and greater floats enclose the unrounded value.
glm::vec3 Below(const glm::dvec3& v)
{
  const glm::vec3 f(v);
  return glm::vec3(std::nextafter(f.x, -HUGE_VALF), std::nextafter(f.y, -HUGE_VALF),
    std::nextafter(f.z, -HUGE_VALF));
}

// In several threads if there is enough work.
template <typename Do>
void ForEach(std::size_t count, Do each)
{
  constexpr std::size_t Many = 4096;
  const auto part = [&each](vtkIdType from, vtkIdType to) {
    for (vtkIdType i = from; i < to; ++i)
    {
      each(static_cast<std::size_t>(i));
    }
  };
  if (count < Many)
  {
    part(0, static_cast<vtkIdType>(count));
    return;
  }
  vtkRelievoWithThreads([&]() { vtkSMPTools::For(0, static_cast<vtkIdType>(count), part); });
}
}

//------------------------------------------------------------------------------
vtkRelievoTreeBuffer::~vtkRelievoTreeBuffer()
{
  this->Release(this->Window);
}

//------------------------------------------------------------------------------
bool vtkRelievoTreeBuffer::UpdateMeshes(const std::vector<vtkRelievoPlacedMesh>& casters)
{
  bool changed = false;
  this->MeshesBuilt = 0;
  this->MeshesRefitted = 0;
  std::map<vtkPolyData*, std::unique_ptr<Held>> before = std::move(this->Meshes);
  this->Meshes.clear();
  for (const vtkRelievoPlacedMesh& caster : casters)
  {
    std::unique_ptr<Held>& held = this->Meshes[caster.Mesh];
    if (held)
    {
      continue;
    }
    held = std::move(before[caster.Mesh]);
    if (!held || held->Data != caster.Mesh)
    {
      held = std::make_unique<Held>();
      held->Data = caster.Mesh;
    }
    if (held->Mesh.Update(caster.Mesh))
    {
      changed = true;
      ++(held->Mesh.WasRefitted() ? this->MeshesRefitted : this->MeshesBuilt);
    }
  }
  const bool gone = std::any_of(
    before.begin(), before.end(), [](const auto& each) { return each.second != nullptr; });
  return changed || gone;
}

//------------------------------------------------------------------------------
std::size_t vtkRelievoTreeBuffer::CountRecords() const
{
  std::size_t count = 0;
  for (const vtkRelievoPlacedMesh& caster : this->Casters)
  {
    const Held& held = *this->Meshes.at(caster.Mesh);
    count += held.Mesh.GetNumberOfTriangles() > 0 ? caster.GetNumberOfPlaces() : 0;
  }
  return count;
}

//------------------------------------------------------------------------------
std::string vtkRelievoTreeBuffer::FindFault(std::size_t records) const
{
  const std::size_t most = vtkRelievoTextureBuffer::GetMostTexels();
  std::ostringstream out;
  if (records > MostRecords)
  {
    out << "there are " << records << " casters and glyphs, and at most " << MostRecords
        << " are supported";
  }
  else if (this->Texels > most)
  {
    out << "the casters' triangles take " << this->Texels << " texels, but this OpenGL supports "
        << "buffers of at most " << most;
  }
  return out.str();
}

//------------------------------------------------------------------------------
std::string vtkRelievoTreeBuffer::Update(vtkOpenGLRenderWindow* window,
  const std::vector<vtkRelievoPlacedMesh>& casters, const glm::dvec3& origin)
{
  try
  {
    return this->TryUpdate(window, casters, origin);
  }
  catch (const std::bad_alloc&)
  {
    this->Release(window); // some meshes may be incomplete
    return "memory ran out while a tree of the casters' triangles was built";
  }
}

//------------------------------------------------------------------------------
std::string vtkRelievoTreeBuffer::TryUpdate(vtkOpenGLRenderWindow* window,
  const std::vector<vtkRelievoPlacedMesh>& casters, const glm::dvec3& origin)
{
  if (this->Window != window)
  {
    this->Release(this->Window);
    this->Window = window;
  }
  const bool meshes = this->UpdateMeshes(casters);
  const bool same = !meshes && this->Buffer.IsIn(window) && origin == this->Origin &&
    std::equal(casters.begin(), casters.end(), this->Casters.begin(), this->Casters.end(), IsSame);
  if (same)
  {
    return {};
  }
  const bool comparable = !meshes && this->Buffer.IsIn(window) && origin == this->Origin;
  const std::vector<vtkRelievoPlacedMesh> castersBefore = std::move(this->Casters);
  const std::vector<vtkRelievoBoxTree::Box> boxesBefore = std::move(this->Boxes);
  this->OnlyMoved = false;
  this->Version += 1.0;
  this->Origin = origin;
  this->Casters = casters;
  const std::size_t count = this->CountRecords();
  const int nodes =
    vtkRelievoBoxTree::GetNumberOfNodes(static_cast<int>(std::min(count, MostRecords)), 1);
  std::size_t texels = RoundUp(1 + 2 * static_cast<std::size_t>(nodes) + RecordTexels * count);
  for (auto& held : this->Meshes)
  {
    held.second->Texel = texels;
    texels += RoundUp(held.second->Mesh.GetTexels().size());
  }
  const bool all = meshes || !this->Buffer.IsIn(window) || texels != this->Texels;
  this->Texels = texels;
  const std::string fault = this->FindFault(count);
  if (!fault.empty())
  {
    this->ReleaseBuffer(window);
    return fault;
  }
  const std::vector<glm::vec4> front = this->MakeFront();
  this->OnlyMoved = comparable && this->FindMoved(castersBefore, boxesBefore);
  return this->Upload(all, front);
}

//------------------------------------------------------------------------------
bool vtkRelievoTreeBuffer::FindMoved(const std::vector<vtkRelievoPlacedMesh>& castersBefore,
  const std::vector<vtkRelievoBoxTree::Box>& boxesBefore)
{
  this->Moved.clear();
  if (castersBefore.size() != this->Casters.size() || boxesBefore.size() != this->Boxes.size())
  {
    return false;
  }
  std::size_t first = 0;
  for (std::size_t i = 0; i < this->Casters.size(); ++i)
  {
    const vtkRelievoPlacedMesh& before = castersBefore[i];
    const vtkRelievoPlacedMesh& now = this->Casters[i];
    if (before.Mesh != now.Mesh || before.GetNumberOfPlaces() != now.GetNumberOfPlaces())
    {
      return false;
    }
    const bool empty = this->Meshes.at(now.Mesh)->Mesh.GetNumberOfTriangles() == 0;
    const std::size_t places = empty ? 0 : now.GetNumberOfPlaces();
    if (!IsSame(before, now))
    {
      if (this->Moved.size() + places > MostMoved)
      {
        return false;
      }
      for (std::size_t k = first; k < first + places; ++k)
      {
        this->Moved.push_back({ glm::min(boxesBefore[k].Min, this->Boxes[k].Min),
          glm::max(boxesBefore[k].Max, this->Boxes[k].Max) });
      }
    }
    first += places;
  }
  return true;
}

//------------------------------------------------------------------------------
std::string vtkRelievoTreeBuffer::Upload(bool all, const std::vector<glm::vec4>& front)
{
  for (int i = 0; i < 16 && glGetError() != GL_NO_ERROR; ++i)
  {
    // Discards earlier errors, so that later ones are this code's.
  }
  const auto write = [this](std::size_t texel, const std::vector<glm::vec4>& texels) {
    if (!texels.empty())
    {
      this->Buffer.Write(4 * texel, &texels[0].x, 4 * texels.size());
    }
  };
  if (all)
  {
    this->Buffer.Allocate(this->Window, this->Texels, 4); // FindFault has checked the size
    for (const auto& held : this->Meshes)
    {
      write(held.second->Texel, held.second->Mesh.GetTexels());
    }
  }
  write(0, front);
  if (glGetError() != GL_NO_ERROR)
  {
    this->Release(this->Window);
    return "this OpenGL has no memory for the casters' triangles";
  }
  return {};
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoTreeBuffer::GetNumberOfTriangles() const
{
  vtkIdType count = 0;
  for (const auto& held : this->Meshes)
  {
    count += held.second->Mesh.GetNumberOfTriangles();
  }
  return count;
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoTreeBuffer::GetNumberOfGlyphs() const
{
  std::size_t count = 0;
  for (const vtkRelievoPlacedMesh& caster : this->Casters)
  {
    count += caster.Places ? caster.Places->size() : 0;
  }
  return static_cast<vtkIdType>(count);
}

//------------------------------------------------------------------------------
bool vtkRelievoTreeBuffer::HasTranslucent() const
{
  return std::any_of(this->Casters.begin(), this->Casters.end(),
    [](const vtkRelievoPlacedMesh& caster) { return caster.Opacity < 1.0; });
}

//------------------------------------------------------------------------------
bool vtkRelievoTreeBuffer::HasColors() const
{
  return std::any_of(
    this->Casters.begin(), this->Casters.end(), [](const vtkRelievoPlacedMesh& caster) {
      return caster.Opacity < 1.0 && caster.Color != glm::dvec3(1.0);
    });
}

//------------------------------------------------------------------------------
bool vtkRelievoTreeBuffer::Bind()
{
  this->Buffer.Activate();
  return this->Buffer.GetTextureUnit() >= 0;
}

//------------------------------------------------------------------------------
void vtkRelievoTreeBuffer::Release(vtkWindow* window)
{
  if (window && this->Window && this->Window != window)
  {
    return; // the buffer belongs to another window
  }
  this->ReleaseBuffer(window);
  this->Meshes.clear();
}

//------------------------------------------------------------------------------
void vtkRelievoTreeBuffer::ReleaseBuffer(vtkWindow* window)
{
  this->Buffer.Release(window);
  this->Texels = 0;
  this->Casters.clear();
  this->Boxes.clear();
}

//------------------------------------------------------------------------------
std::vector<glm::vec4> vtkRelievoTreeBuffer::MakeFront()
{
  const std::size_t count = this->CountRecords();
  std::vector<vtkRelievoBoxTree::Box> boxes(count);
  std::vector<glm::vec4> records(RecordTexels * count);
  std::size_t first = 0;
  for (const vtkRelievoPlacedMesh& caster : this->Casters)
  {
    const Held& held = *this->Meshes[caster.Mesh];
    if (held.Mesh.GetNumberOfTriangles() == 0)
    {
      continue;
    }
    glm::dmat4 aboutToMesh(1.0);
    aboutToMesh[3] = glm::dvec4(held.Mesh.GetOrigin(), 1.0);
    glm::dmat4 worldToLocal(1.0);
    worldToLocal[3] = glm::dvec4(-this->Origin, 1.0);
    glm::dvec3 low;
    glm::dvec3 high;
    held.Mesh.GetBounds(low, high);
    // Error of glyphs' positions in OpenGL, in world units: OpenGL rounds their coordinates in the
    // actor's space, which VTK does not shift.
    const double size =
      glm::length(glm::max(glm::abs(low), glm::abs(high)) + glm::abs(held.Mesh.GetOrigin()));
    const double actorUlp = Ulp * vtkRelievoGetScale(caster.MeshToWorld);
    const double transmittance = 1.0 - caster.Opacity;
    const glm::vec3 colors(transmittance * caster.Color);
    const auto make = [&](std::size_t i) {
      const glm::dmat4 aboutToLocal = worldToLocal * caster.GetPlace(i) * aboutToMesh;
      const glm::dmat4 localToAbout = glm::inverse(aboutToLocal);
      const double rounding = caster.Places ? actorUlp *
          (glm::length(glm::dvec3((*caster.Places)[i][3])) +
            size * vtkRelievoGetScale((*caster.Places)[i]))
                                            : 0.0;
      glm::dvec3 least(1e300);
      glm::dvec3 most(-1e300);
      for (int corner = 0; corner < 8; ++corner)
      {
        const glm::dvec3 p(aboutToLocal *
          glm::dvec4(corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y,
            corner & 4 ? high.z : low.z, 1.0));
        least = glm::min(least, p);
        most = glm::max(most, p);
      }
      // The transform of rays into the mesh's coordinates rounds once more.
      const glm::dvec3 room = 4.0 * Ulp * glm::max(glm::abs(least), glm::abs(most));
      boxes[first + i] = { Below(least - room), -Below(-(most + room)) };
      glm::vec4* record = &records[RecordTexels * (first + i)];
      double scale = 0.0;
      for (int row = 0; row < 3; ++row)
      {
        const glm::dvec4 numbers(
          localToAbout[0][row], localToAbout[1][row], localToAbout[2][row], localToAbout[3][row]);
        record[row] = glm::vec4(numbers);
        scale = std::max(scale, glm::length(glm::dvec3(numbers)));
      }
      record[3] = glm::vec4(static_cast<float>(held.Texel / Grain),
        static_cast<float>(held.Mesh.GetNumberOfLeaves()), static_cast<float>(transmittance),
        colors.r);
      record[4] = glm::vec4(static_cast<float>(scale),
        static_cast<float>(Ulp * caster.Reach + scale * rounding), colors.g, colors.b);
    };
    const std::size_t places = caster.GetNumberOfPlaces();
    ForEach(places, make);
    first += places;
  }
  vtkRelievoBoxTree tree;
  tree.Build(boxes, 1);
  std::vector<glm::vec4> front;
  for (std::size_t i = 0; i < tree.GetNodes().size(); ++i)
  {
    const std::array<glm::vec4, 2> texels = tree.GetNodes()[i].GetTexels(static_cast<int>(i), 1);
    front.insert(front.end(), texels.begin(), texels.end());
  }
  for (const int caster : tree.GetOrder())
  {
    const auto record = records.begin() + RecordTexels * static_cast<std::ptrdiff_t>(caster);
    front.insert(front.end(), record, record + RecordTexels);
  }
  this->Nodes = static_cast<int>(tree.GetNodes().size());
  this->Boxes = std::move(boxes);
  return front;
}
