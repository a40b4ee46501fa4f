// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Places that are evenly spread in the space inside depth maps. They are drawn from columns between
// what two opposite views see, or from a box where views are not opposite, and kept if no other
// view sees them outside.
#ifndef vtkRelievoParticleInterior_h
#define vtkRelievoParticleInterior_h

#include "vtkRelievoParticleMaps.h"

#include "vtkType.h"

#include <vector>

// From 0 to 1, for a particle and a purpose.
double vtkRelievoParticleRandom(vtkIdType particle, unsigned int purpose, unsigned int seed);

class vtkRelievoParticleInterior
{
public:
  // The box holds all that is seen.
  vtkRelievoParticleInterior(const vtkRelievoParticleMaps& maps, const glm::dvec3& low,
    const glm::dvec3& high, unsigned int seed);

  // The place of a particle, from its number alone; false where there is no space inside, or less
  // than one in 4096 of what places are drawn from.
  bool Find(vtkIdType particle, glm::dvec3& position) const;

private:
  void FindColumns();
  bool Draw(vtkIdType particle, unsigned int attempt, glm::dvec3& position) const;

  const vtkRelievoParticleMaps& Maps;
  glm::dvec3 Low;
  glm::dvec3 High;
  unsigned int Seed;
  std::size_t Front = 0;       // the first of the two views that columns are between
  std::vector<double> Lengths; // of the columns up to each, in texels; empty: places are in the box
  unsigned int Attempts = 0;   // for a place
};

#endif
