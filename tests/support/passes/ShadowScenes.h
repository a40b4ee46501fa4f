// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadowScenes.h
 * @brief Small scenes that cast shadows, and the verdicts of their pictures against rays.
 */
#ifndef relievoTestShadowScenes_h
#define relievoTestShadowScenes_h

#include "EmbreeScene.h"
#include "ShadowErrors.h"
#include "Stage.h"

#include <vtkActor.h>
#include <vtkLight.h>
#include <vtkSmartPointer.h>

#include <glm/glm.hpp>

#include <string>

class vtkImageData;
class vtkRelievoPass;
class vtkRelievoShadowStage;

namespace relievoTest
{
/** A stage without lights and with grey background; `scale` and `origin` place it in the world. */
struct ShadowStage : Stage
{
  ShadowStage(int width = 240, int height = 180, double scale = 1.,
    const glm::dvec3& origin = glm::dvec3(0.));

  /** A point of the scene in the world. */
  glm::dvec3 Place(const glm::dvec3& p) const { return this->Origin + this->Scale * p; }

  /** A square ground of half width 3 at y = 0 that looks up. */
  vtkSmartPointer<vtkActor> AddGround();

  /** A box about `middle`, its points placed in double. */
  vtkSmartPointer<vtkActor> AddBox(const glm::dvec3& middle, const glm::dvec3& size);

  /** Ground, a tall box and a low one with a gap to the ground: what most tests look at. */
  void AddThings();

  /** Two rows of poles to the horizon before a camera of its own, and a low sun. */
  void AddPolesToHorizon();

  /** A sun towards that direction. */
  vtkSmartPointer<vtkLight> AddSun(double x, double y, double z);

  /** A lamp there that shines at `focus`; from 90 degrees on in all directions. */
  vtkSmartPointer<vtkLight> AddLamp(
    const glm::dvec3& place, const glm::dvec3& focus, double coneAngle);

  /** The shadow stage, attached on first use. */
  vtkRelievoPass* GetFrame();
  vtkRelievoShadowStage* GetShadows();

  double Scale;
  glm::dvec3 Origin;
};

/**
 * Verdicts of the layer shadow_N for the renderer's light N against rays at the triangles that the
 * renderer's actors have, or at those of `truth`.
 */
ShadowErrors JudgeShadow(ShadowStage& stage, int number, const EmbreeScene* truth = nullptr);

/**
 * Judges, prints, and fails unless at most `limit` of the pixels are wrong, at least `leastDark` of
 * them truly dark.
 */
ShadowErrors CheckShadow(ShadowStage& stage, int number, double limit, const std::string& what,
  double leastDark = 0.01, const EmbreeScene* truth = nullptr);

/** The layer shadow_N of a frame that is drawn for it. */
vtkSmartPointer<vtkImageData> CaptureShadow(ShadowStage& stage, int number);

/** What every pixel of the stage must show of its light N, with the pixel's surface. */
ShadowTruth TraceStage(ShadowStage& stage, int number, const EmbreeScene* truth = nullptr);

/** The truth without the pixels that have a neighbour of another verdict, or of none. */
ShadowTruth GetInner(const ShadowTruth& truth, int radius = 1);
}

#endif
