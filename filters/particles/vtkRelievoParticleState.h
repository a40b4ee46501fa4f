// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The positions of particles, and the view that each belongs to.
#ifndef vtkRelievoParticleState_h
#define vtkRelievoParticleState_h

#include <glm/vec3.hpp>

#include <cstddef>
#include <vector>

struct vtkRelievoParticleState
{
  std::vector<glm::dvec3> Positions;
  std::vector<unsigned char> Views;

  static std::size_t GetBytesPerParticle() { return sizeof(glm::dvec3) + 1; }
};

#endif
