// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lights with a size, and the samples of their shapes that a frame draws.
#ifndef vtkRelievoSoftLights_h
#define vtkRelievoSoftLights_h

#include "vtkRelievoLightSamples.h"

#include <glm/vec2.hpp>

#include <string>

class vtkRelievoFrameContext;
class vtkRelievoShadowLights;
class vtkRenderer;

class vtkRelievoSoftLights
{
public:
  // Room in the shaders of this OpenGL.
  struct Room
  {
    int Maps;
    int Rays;
  };

  vtkRelievoLightSizes Sizes;

  bool HasSized(const vtkRelievoShadowLights& lights, vtkRenderer* renderer) const;

  // Whether this number of samples of all lights can share a few maps.
  bool CanFollow(int samples, const vtkRelievoShadowLights& lights, vtkRenderer* renderer) const;

  // Moves the lights that cast to the frame's sample, or divides them into parts where it draws all
  // samples at once. `soft`: samples are wanted; `maps`: of each sun, for all of its parts.
  void Begin(const vtkRelievoFrameContext& context, bool soft, int maps, const Room& room,
    vtkRelievoShadowLights& lights);

  ///@{
  // In this frame: samples, those gathered until now, and the step of the numbers of parts where
  // all samples are drawn at once (vtkRelievoSampleLattice::GetNumberStep); 0, 0 elsewhere.
  int GetSamples() const { return this->Samples; }
  int GetGathered() const { return this->Gathered; }
  const glm::vec2& GetPartStep() const { return this->PartStep; }
  ///@}

  // As a part of a sentence: ", WORDS". `together`: with other processes.
  std::string GetReport(bool together) const;

private:
  int Samples = 1;
  int Gathered = 0;
  glm::vec2 PartStep{ 0.f };
};

#endif
