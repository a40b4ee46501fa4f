// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FogScene.h
 * @brief A wall, a ball and a bit of sky with fog, and their expected picture.
 */
#ifndef relievoTestFogScene_h
#define relievoTestFogScene_h

#include "EffectScene.h"

#include <vtkRelievoFogSpheres.h>
#include <vtkRelievoFogStage.h>

namespace relievoTest
{
struct FogSphere
{
  glm::dvec3 Center;
  double Radius;
  double Density;
  glm::dvec3 Color; // linear
};

/** Points with the arrays radius, density and color. */
vtkSmartPointer<vtkPolyData> MakeFogPoints(const std::vector<FogSphere>& spheres);

struct FogErrors
{
  double Transmittance = 0.; // of the layer `fog`
  double Picture = 0.;       // levels of 255
  int Fogged = 0;            // pixels that fog is seen in
  int Sky = 0;               // of these, without a surface
};

class FogScene : public EffectScene
{
public:
  FogScene(int width, int height, const glm::dvec3& origin = glm::dvec3(0.));

  /** Moved by the origin. */
  void Set(const std::vector<FogSphere>& spheres);

  /** A translucent square before everything. */
  void AddGlass();

  /** The layer and the picture against sums over the spheres, with the depths of that frame. */
  FogErrors Compare();

  vtkRelievoFogStage* Stage;
  vtkNew<vtkRelievoFogSpheres> Fog;

private:
  std::vector<FogSphere> Spheres; // as they are in the world
};
}

#endif
