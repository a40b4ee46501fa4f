// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Positions evenly spread in the space inside depth maps. They are sampled from columns between the
// surfaces that two opposite views see, or from a box if views are not opposite, and kept if no
// other view sees them outside.
#ifndef vtkRelievoParticleInterior_h
#define vtkRelievoParticleInterior_h

#include "vtkRelievoParticleMaps.h"

#include "vtkType.h"

#include <vector>

// A random number in [0, 1) for a particle and a purpose.
double vtkRelievoParticleRandom(vtkIdType particle, unsigned int purpose, unsigned int seed);

class vtkRelievoParticleInterior
{
public:
  // The box encloses everything visible.
  vtkRelievoParticleInterior(const vtkRelievoParticleMaps& maps, const glm::dvec3& low,
    const glm::dvec3& high, unsigned int seed);

  // The position of a particle, which depends only on its number; false if there is no space
  // inside, or less than 1/4096 of the sampled space.
  bool Find(vtkIdType particle, glm::dvec3& position) const;

private:
  void FindColumns();
  bool Draw(vtkIdType particle, unsigned int attempt, glm::dvec3& position) const;

  const vtkRelievoParticleMaps& Maps;
  glm::dvec3 Low;
  glm::dvec3 High;
  unsigned int Seed;
  std::size_t Front = 0; // the first of the two views that bound the columns
  std::vector<double>
    Lengths; // running sum over the columns, in texels; empty: positions are in the box
  unsigned int Attempts = 0; // per position
};

#endif
