// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Particles' way through the steps of time. What they are at a step follows from their start alone:
// some steps are kept, and others computed from the kept one before.
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
  // Gives all that the maps see its velocity.
  static void SetVelocities(vtkRelievoParticleMaps& maps, const vtkRelievoParticleField& field);

  // Held on what the maps see, whose texels have velocities, or inside.
  vtkRelievoParticleSteps(
    const vtkRelievoParticleMaps& maps, const vtkRelievoParticleField& field, bool inside);

  // Starts anew; keeps up to so many checkpoints, beside the first and the last step computed.
  void Begin(vtkRelievoParticleState start, double timeStep, int numberOfSteps, int checkpoints);

  // The particles after so many steps, a part of one included. Between steps, goesOn is asked with
  // the share that is done; nullptr if it says no.
  const vtkRelievoParticleState* Get(double steps, const std::function<bool(double)>& goesOn);

  // What is held now, and what so many particles of so many steps take, output included.
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
  std::map<int, vtkRelievoParticleState> Kept; // by step
  int Latest = 0;
  vtkRelievoParticleState Between; // a part of a step beyond a kept one
};

#endif
