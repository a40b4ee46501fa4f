// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The lamps of a frame: those of all sets that the camera can see light of, in eye space.
#ifndef vtkRelievoLampList_h
#define vtkRelievoLampList_h

#include "vtkRelievoDeferredModule.h"
#include "vtkRelievoFrameCamera.h"
#include "vtkRelievoSphereBounds.h"
#include "vtkType.h"

#include <vector>

class vtkRelievoLamps;

class VTKRELIEVODEFERRED_EXPORT vtkRelievoLampList
{
public:
  struct Lamp
  {
    vtkRelievoSphereBounds::Sphere Sphere; // eye space; enlarged by what a float's rounding moves
    float Rectangle[4];                    // in NDC, cut to the view; empty where it is not seen
    const double* Row;                     // of its set
    vtkIdType Number;                      // among all that were given
    double Size;                           // brightness times area in the picture; -1: beside it
  };

  // Takes the lamps, which are shared or up to date, in their order. What lies behind the eye,
  // beyond the clipping planes, beside the view, or between the centres of all pixels, is left out.
  // A view of a tile comes with what turns its NDC into those of the picture.
  void Take(const vtkRelievoFrameCamera& view, const std::vector<vtkRelievoLamps*>& sets,
    const glm::dmat4& tileToPicture = glm::dmat4(1.0));

  // Takes those out that cast shadows, eight at most, and returns them: those that always do, and
  // of the others so many of the largest, by brightness times the area of their rectangle in the
  // picture. They are the same in all its tiles, also where one does not see them. Where
  // the next one is almost as large, the strength of a shadow falls to 0, so that none comes or
  // goes at once while the camera moves.
  vtkRelievoLampList TakeCasting(int largest, std::vector<double>& strengths);

  const std::vector<Lamp>& GetLamps() const { return this->Lamps; }
  int GetNumberGiven() const { return this->NumberGiven; }
  bool IsWhite() const { return this->White; }
  bool IsLinear() const; // the light of all falls off in a line

  // For shaders/deferred/lamp.glsl: two texels of four floats for each lamp.
  const std::vector<float>& GetTexels() const { return this->Texels; }

  // And one for each set: its attenuation values.
  const std::vector<float>& GetAttenuations() const { return this->Attenuations; }

private:
  void TakeOut(vtkIdType number);

  std::vector<Lamp> Lamps;
  std::vector<float> Texels;
  std::vector<Lamp> Beside; // that other tiles of the picture see, and that may cast
  std::vector<float> BesideTexels;
  std::vector<float> Attenuations;
  int NumberGiven = 0;
  bool White = true;
};

#endif
