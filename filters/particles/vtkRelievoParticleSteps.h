// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Moves particles through time steps. A step's result depends only on the start: some steps are
// cached, and others are computed from the cached step before.
#ifndef vtkRelievoParticleSteps_h
#define vtkRelievoParticleSteps_h

#include "vtkRelievoParticleField.h"
#include "vtkRelievoParticleMaps.h"
#include "vtkRelievoParticleState.h"
#include "vtkType.h"

#include <functional>
#include <map>

class vtkRelievoParticleSteps
{
public:
  // Sets the velocities of everything visible in the maps.
  static void SetVelocities(vtkRelievoParticleMaps& maps, const vtkRelievoParticleField& field);

  // Particles stay on the maps' surface, whose texels have velocities, or inside.
  vtkRelievoParticleSteps(
    const vtkRelievoParticleMaps& maps, const vtkRelievoParticleField& field, bool inside);

  // Starts again; caches up to `checkpoints` steps, besides the first and the last computed step.
  void Begin(vtkRelievoParticleState start, double timeStep, int numberOfSteps, int checkpoints);

  // The particles after a number of steps, which may have a fraction. Between steps, calls goesOn
  // with the fraction done; nullptr if goesOn returns false.
  const vtkRelievoParticleState* Get(double steps, const std::function<bool(double)>& goesOn);

  // Bytes in use now, and an estimate for so many particles and steps, output included.
  double GetBytesHeld() const;
  static double EstimateBytes(vtkIdType particles, int numberOfSteps, int checkpoints);

private:
  void Advance(vtkRelievoParticleState& state, double time) const;
  void AdvanceOnSurface(glm::dvec3& position, unsigned char& view, double time) const;
  void AdvanceInside(
    vtkRelievoParticleField::Reader& field, glm::dvec3& position, double time) const;

  const vtkRelievoParticleMaps& Maps;
  const vtkRelievoParticleField& Field;
  bool Inside;
  double TimeStep = 1.;
  int Interval = 1;
  std::map<int, vtkRelievoParticleState> Cached; // by step
  int Latest = 0;
  vtkRelievoParticleState Between; // a fraction of a step after a cached one
};

#endif
