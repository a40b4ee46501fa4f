// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lights with a size, and the samples of their shapes in a frame.
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
  // Limits of this OpenGL's shaders.
  struct Room
  {
    int Maps;
    int Rays;
  };

  vtkRelievoLightSizes Sizes;

  bool HasSized(const vtkRelievoShadowLights& lights, vtkRenderer* renderer) const;

  // Whether so many samples of all lights can share a few maps.
  bool CanFollow(int samples, const vtkRelievoShadowLights& lights, vtkRenderer* renderer) const;

  // Moves the casting lights to the frame's sample, or divides them into parts if the frame draws
  // all samples at once. `soft`: samples are requested; `maps`: maps of each sun, shared by its
  // parts.
  void Begin(const vtkRelievoFrameContext& context, bool soft, int maps, const Room& room,
    vtkRelievoShadowLights& lights);

  ///@{
  // In this frame: the number of samples, the number gathered so far, and, if all samples are drawn
  // at once, the step of the parts' numbers (vtkRelievoSampleLattice::GetNumberStep), else 0, 0.
  int GetSamples() const { return this->Samples; }
  int GetGathered() const { return this->Gathered; }
  const glm::vec2& GetPartStep() const { return this->PartStep; }
  ///@}

  // A clause for the frame report, ", WORDS". `together`: several processes draw the frame.
  std::string GetReport(bool together) const;

private:
  int Samples = 1;
  int Gathered = 0;
  glm::vec2 PartStep{ 0.f };
};

#endif
