// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The lamps of a frame, in eye space: those of all sets whose light is in view.
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
    vtkRelievoSphereBounds::Sphere Sphere; // eye space; enlarged by float rounding
    float Rectangle[4];                    // in NDC, clipped to the view; empty if out of view
    const double* Row;                     // in its set's rows
    vtkIdType Number;                      // index among all given lamps
    double Size;                           // brightness times area in the picture; -1 outside it
  };

  // Takes the lamps, which are shared or up to date, in order. Lamps behind the eye, beyond the
  // clipping planes, outside the view, or between the centres of all pixels are left out. For a
  // tile of a picture, `tileToPicture` maps its NDC to those of the picture.
  void Take(const vtkRelievoFrameCamera& view, const std::vector<vtkRelievoLamps*>& sets,
    const glm::dmat4& tileToPicture = glm::dmat4(1.0));

  // Removes the lamps that cast shadows, at most eight, and returns them: those that always cast,
  // and the `largest` largest others, by brightness times the area of their rectangle in the
  // picture. All tiles of the picture select the same lamps, also where one is out of view. If the
  // next lamp is almost as large, the strength of a shadow falls to 0, so that no shadow appears or
  // disappears abruptly while the camera moves.
  vtkRelievoLampList TakeCasting(int largest, std::vector<double>& strengths);

  const std::vector<Lamp>& GetLamps() const { return this->Lamps; }
  int GetNumberGiven() const { return this->NumberGiven; }
  bool IsWhite() const { return this->White; }
  bool IsLinear() const; // all lamps have linear fall-off

  // Two texels of four floats for each lamp, for shaders/deferred/lamp.glsl.
  const std::vector<float>& GetTexels() const { return this->Texels; }

  // One texel for each set: its attenuation values.
  const std::vector<float>& GetAttenuations() const { return this->Attenuations; }

private:
  void TakeOut(vtkIdType number);

  std::vector<Lamp> Lamps;
  std::vector<float> Texels;
  std::vector<Lamp> Beside; // outside this tile, in view in other tiles, and possible casters
  std::vector<float> BesideTexels;
  std::vector<float> Attenuations;
  int NumberGiven = 0;
  bool White = true;
};

#endif
