// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MarkerScene.h
 * @brief A floor, a ball, a turned wall and a bit of sky with markers, and their expected picture.
 */
#ifndef relievoTestMarkerScene_h
#define relievoTestMarkerScene_h

#include "EffectScene.h"

#include <vtkRelievoMarkers.h>
#include <vtkRelievoMarkersStage.h>

namespace relievoTest
{
/** A point, or, if there is an actor, its box. */
struct Mark
{
  glm::dvec3 Center{ 0. };
  double Radius = 1.;
  double Width = 0.2;
  double Reach = 4.;
  double Opacity = 0.8;
  glm::dvec3 Color{ 1., 0.5, 0. }; // linear
  vtkActor* Actor = nullptr;
};

/** Points with all arrays of vtkRelievoMarkers. */
vtkSmartPointer<vtkPolyData> MakeMarkerPoints(const std::vector<Mark>& marks);

/**
 * Levels of 255 between a picture and the value computed from the plain one: both are rounded, and
 * the colour is in half floats, which are truncated twice, by a tenth of a level each.
 */
constexpr double PictureLimit = 1.2;

struct MarkerErrors
{
  double Covered = 0.; // of the layer `marker`
  double Picture = 0.; // levels of 255, by the coverage in the layer `marker`
  int Marked = 0;      // pixels of which more than a hundredth is covered
  int Edges = 0;       // of these, not wholly
};

class MarkerScene : public EffectScene
{
public:
  MarkerScene(int width, int height, const glm::dvec3& origin = glm::dvec3(0.));

  /** Sets the set's points, moved by the origin, and actors, which share the last mark's values. */
  void Set(int shape, const std::vector<Mark>& marks);

  /** The layer and the picture against the markers in double, with the depths of that frame. */
  MarkerErrors Compare();

  vtkSmartPointer<vtkActor> Ball;
  vtkSmartPointer<vtkActor> Wall;
  vtkRelievoMarkersStage* Stage;
  vtkNew<vtkRelievoMarkers> Markers;

private:
  std::vector<Mark> Marks; // as they are in the world
};
}

#endif
