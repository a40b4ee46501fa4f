// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShadowTree.h"

#include "vtkOpenGLError.h" // for OpenGL
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPolyData.h"
#include "vtkTextureUnitManager.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <sstream>

namespace
{
constexpr std::size_t Grain = 16; // texels: where meshes begin
constexpr double Ulp = 1.0 / (1 << 23);

bool IsSame(const vtkRelievoCaster& a, const vtkRelievoCaster& b)
{
  return a.Mesh == b.Mesh && a.MeshToWorld == b.MeshToWorld && a.Passes == b.Passes;
}

std::size_t RoundUp(std::size_t texels)
{
  return (texels + Grain - 1) / Grain * Grain;
}

// The next smaller and greater floats hold what was rounded.
glm::vec3 Below(const glm::dvec3& v)
{
  const glm::vec3 f(v);
  return glm::vec3(std::nextafter(f.x, -HUGE_VALF), std::nextafter(f.y, -HUGE_VALF),
    std::nextafter(f.z, -HUGE_VALF));
}
}

//------------------------------------------------------------------------------
vtkRelievoShadowTree::~vtkRelievoShadowTree()
{
  this->Release(this->Window);
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowTree::UpdateMeshes(const std::vector<vtkRelievoCaster>& casters)
{
  bool changed = false;
  this->MeshesBuilt = 0;
  this->MeshesRefitted = 0;
  std::map<vtkPolyData*, std::unique_ptr<Held>> before = std::move(this->Meshes);
  this->Meshes.clear();
  for (const vtkRelievoCaster& caster : casters)
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
std::vector<glm::vec4> vtkRelievoShadowTree::MakeRecords()
{
  glm::dmat4 localToWorld(1.0);
  localToWorld[3] = glm::dvec4(this->Origin, 1.0);
  std::vector<vtkRelievoBoxTree::Box> boxes;
  std::vector<glm::vec4> records;
  for (const vtkRelievoCaster& caster : this->Casters)
  {
    const Held& held = *this->Meshes[caster.Mesh];
    if (held.Mesh.GetNumberOfTriangles() == 0)
    {
      continue;
    }
    glm::dmat4 aboutToMesh(1.0);
    aboutToMesh[3] = glm::dvec4(held.Mesh.GetOrigin(), 1.0);
    const glm::dmat4 aboutToLocal = glm::inverse(localToWorld) * (caster.MeshToWorld * aboutToMesh);
    const glm::dmat4 localToAbout = glm::inverse(aboutToLocal);
    glm::dvec3 low;
    glm::dvec3 high;
    held.Mesh.GetBounds(low, high);
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
    // The ray is rounded once more on its way into the mesh's coordinates.
    const glm::dvec3 room = 4.0 * Ulp * glm::max(glm::abs(least), glm::abs(most));
    boxes.push_back({ Below(least - room), -Below(-(most + room)) });
    double scale = 0.0;
    for (int row = 0; row < 3; ++row)
    {
      const glm::dvec4 numbers(
        localToAbout[0][row], localToAbout[1][row], localToAbout[2][row], localToAbout[3][row]);
      records.emplace_back(numbers);
      scale = std::max(scale, glm::length(glm::dvec3(numbers)));
    }
    records.emplace_back(static_cast<float>(held.Texel / Grain),
      static_cast<float>(held.Mesh.GetNumberOfNodes()), static_cast<float>(caster.Passes), 0.f);
    records.emplace_back(
      static_cast<float>(scale), static_cast<float>(Ulp * held.Mesh.GetReach()), 0.f, 0.f);
  }
  vtkRelievoBoxTree tree;
  tree.Build(boxes, 1);
  std::vector<glm::vec4> front;
  for (const auto& node : tree.GetNodes())
  {
    front.push_back(node.Low);
    front.push_back(node.High);
  }
  for (const int caster : tree.GetOrder())
  {
    front.insert(front.end(), records.begin() + 5 * caster, records.begin() + 5 * caster + 5);
  }
  this->Nodes = static_cast<int>(tree.GetNodes().size());
  return front;
}

//------------------------------------------------------------------------------
std::string vtkRelievoShadowTree::Update(vtkOpenGLRenderWindow* window,
  const std::vector<vtkRelievoCaster>& casters, const glm::dvec3& origin)
{
  if (this->Window != window)
  {
    this->Release(this->Window);
    this->Window = window;
  }
  const bool meshes = this->UpdateMeshes(casters);
  const bool same = !meshes && this->Texture && origin == this->Origin &&
    std::equal(casters.begin(), casters.end(), this->Casters.begin(), this->Casters.end(), IsSame);
  if (same)
  {
    return {};
  }
  this->Version += 1.0;
  this->Origin = origin;
  this->Casters = casters;
  const auto count = std::count_if(casters.begin(), casters.end(), [this](const auto& caster) {
    return this->Meshes[caster.Mesh]->Mesh.GetNumberOfTriangles() > 0;
  });
  const int nodes = vtkRelievoBoxTree::GetNumberOfNodes(static_cast<int>(count), 1);
  std::size_t texels = RoundUp(1 + 2 * static_cast<std::size_t>(nodes) + 5 * count);
  for (auto& held : this->Meshes)
  {
    held.second->Texel = texels;
    texels += RoundUp(held.second->Mesh.GetTexels().size());
  }
  const bool all = meshes || !this->Buffer || texels != this->Texels;
  this->Texels = texels;
  this->Front = this->MakeRecords();
  return this->Upload(all);
}

//------------------------------------------------------------------------------
std::string vtkRelievoShadowTree::Upload(bool all)
{
  GLint most = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
  if (this->Texels > static_cast<std::size_t>(most))
  {
    std::ostringstream out;
    out << "the casters' triangles take " << this->Texels << " texels, and this OpenGL has buffers "
        << "of at most " << most;
    this->Casters.clear();
    this->Release(this->Window);
    return out.str();
  }
  for (int i = 0; i < 16 && glGetError() != GL_NO_ERROR; ++i)
  {
    // Others' errors: what follows is to be known.
  }
  if (!this->Buffer)
  {
    glGenBuffers(1, &this->Buffer);
    glGenTextures(1, &this->Texture);
  }
  glBindBuffer(GL_TEXTURE_BUFFER, this->Buffer);
  const auto write = [](std::size_t texel, const std::vector<glm::vec4>& texels) {
    if (!texels.empty())
    {
      glBufferSubData(GL_TEXTURE_BUFFER, static_cast<GLintptr>(texel * sizeof(glm::vec4)),
        static_cast<GLsizeiptr>(texels.size() * sizeof(glm::vec4)), texels.data());
    }
  };
  if (all)
  {
    this->Bytes = static_cast<vtkIdType>(this->Texels * sizeof(glm::vec4));
    glBufferData(GL_TEXTURE_BUFFER, this->Bytes, nullptr, GL_STATIC_DRAW);
    for (const auto& held : this->Meshes)
    {
      write(held.second->Texel, held.second->Mesh.GetTexels());
    }
  }
  write(0, this->Front);
  glBindBuffer(GL_TEXTURE_BUFFER, 0);
  glBindTexture(GL_TEXTURE_BUFFER, this->Texture);
  glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, this->Buffer);
  glBindTexture(GL_TEXTURE_BUFFER, 0);
  if (glGetError() != GL_NO_ERROR)
  {
    this->Release(this->Window);
    return "this OpenGL has no memory for the casters' triangles";
  }
  return {};
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoShadowTree::GetNumberOfTriangles() const
{
  vtkIdType count = 0;
  for (const auto& held : this->Meshes)
  {
    count += held.second->Mesh.GetNumberOfTriangles();
  }
  return count;
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowTree::HasTranslucent() const
{
  return std::any_of(this->Casters.begin(), this->Casters.end(),
    [](const vtkRelievoCaster& caster) { return caster.Passes > 0.0; });
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowTree::Bind()
{
  if (!this->Window || !this->Texture)
  {
    return false;
  }
  vtkOpenGLState* state = this->Window->GetState();
  if (this->Unit < 0)
  {
    this->Unit = state->GetTextureUnitManager()->Allocate();
  }
  if (this->Unit < 0)
  {
    return false;
  }
  state->vtkglActiveTexture(GL_TEXTURE0 + static_cast<unsigned int>(this->Unit));
  glBindTexture(GL_TEXTURE_BUFFER, this->Texture);
  state->vtkglActiveTexture(GL_TEXTURE0);
  return true;
}

//------------------------------------------------------------------------------
void vtkRelievoShadowTree::Unbind()
{
  if (this->Unit >= 0 && this->Window)
  {
    vtkOpenGLState* state = this->Window->GetState();
    state->vtkglActiveTexture(GL_TEXTURE0 + static_cast<unsigned int>(this->Unit));
    glBindTexture(GL_TEXTURE_BUFFER, 0);
    state->vtkglActiveTexture(GL_TEXTURE0);
    state->GetTextureUnitManager()->Free(this->Unit);
  }
  this->Unit = -1;
}

//------------------------------------------------------------------------------
void vtkRelievoShadowTree::Release(vtkWindow* window)
{
  if (window && this->Window && this->Window != window)
  {
    return; // what is held is another window's
  }
  if (window && this->Texture)
  {
    window->MakeCurrent();
    this->Unbind();
    glDeleteTextures(1, &this->Texture);
    glDeleteBuffers(1, &this->Buffer);
  }
  this->Texture = 0;
  this->Buffer = 0;
  this->Unit = -1;
  this->Bytes = 0;
  this->Texels = 0;
  this->Meshes.clear();
  this->Casters.clear();
  this->Front.clear();
}
