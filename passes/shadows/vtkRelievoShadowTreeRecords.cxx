// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The front of the buffer: where each caster is, and the tree over them.
#include "vtkRelievoShadowTree.h"
#include "vtkRelievoThreads.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr double Ulp = 1.0 / (1 << 23);

// The next smaller and greater floats hold what was rounded.
glm::vec3 Below(const glm::dvec3& v)
{
  const glm::vec3 f(v);
  return glm::vec3(std::nextafter(f.x, -HUGE_VALF), std::nextafter(f.y, -HUGE_VALF),
    std::nextafter(f.z, -HUGE_VALF));
}

double GetScale(const glm::dmat4& m)
{
  const glm::dmat3 axes(m);
  return std::max({ glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2]) });
}

// In threads where it pays.
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
std::vector<glm::vec4> vtkRelievoShadowTree::MakeFront()
{
  const std::size_t count = this->CountRecords();
  std::vector<vtkRelievoBoxTree::Box> boxes(count);
  std::vector<glm::vec4> records(RecordTexels * count);
  std::size_t first = 0;
  for (const vtkRelievoCaster& caster : this->Casters)
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
    // How far glyphs are off where OpenGL draws them, in units of the world: it rounds their
    // coordinates in the actor, which VTK does not shift.
    const double size =
      glm::length(glm::max(glm::abs(low), glm::abs(high)) + glm::abs(held.Mesh.GetOrigin()));
    const double actorUlp = Ulp * GetScale(caster.MeshToWorld);
    const double reach = std::max(held.Mesh.GetReach(), caster.Reach);
    const glm::vec3 colors(caster.Passes * caster.Color);
    const auto make = [&](std::size_t i) {
      const glm::dmat4 aboutToLocal = worldToLocal * caster.GetPlace(i) * aboutToMesh;
      const glm::dmat4 localToAbout = glm::inverse(aboutToLocal);
      const double rounding = caster.Places ? actorUlp *
          (glm::length(glm::dvec3((*caster.Places)[i][3])) +
            size * GetScale(glm::dmat4((*caster.Places)[i])))
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
      // The ray is rounded once more on its way into the mesh's coordinates.
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
        static_cast<float>(held.Mesh.GetNumberOfNodes()), static_cast<float>(caster.Passes),
        colors.r);
      record[4] = glm::vec4(static_cast<float>(scale),
        static_cast<float>(Ulp * reach + scale * rounding), colors.g, colors.b);
    };
    const std::size_t places = caster.GetNumberOfPlaces();
    ForEach(places, make);
    first += places;
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
    const auto record = records.begin() + RecordTexels * static_cast<std::ptrdiff_t>(caster);
    front.insert(front.end(), record, record + RecordTexels);
  }
  this->Nodes = static_cast<int>(tree.GetNodes().size());
  return front;
}
