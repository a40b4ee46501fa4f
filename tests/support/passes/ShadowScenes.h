// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadowScenes.h
 * @brief Small scenes that cast shadows, and verdicts of their pictures compared with rays.
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
/** A stage without lights and with grey background; `scale` and `origin` map it to the world. */
struct ShadowStage : Stage
{
  ShadowStage(int width = 240, int height = 180, double scale = 1.,
    const glm::dvec3& origin = glm::dvec3(0.));

  /** A point of the scene in the world. */
  glm::dvec3 Place(const glm::dvec3& p) const { return this->Origin + this->Scale * p; }

  /** A square ground of half width 3 at y = 0, facing up. */
  vtkSmartPointer<vtkActor> AddGround();

  /** A box about `middle`, its points placed in double. */
  vtkSmartPointer<vtkActor> AddBox(const glm::dvec3& middle, const glm::dvec3& size);

  /** Ground, a tall box and a low one with a gap to the ground, used by most tests. */
  void AddThings();

  /** Two rows of poles to the horizon, with their own camera, and a low sun. */
  void AddPolesToHorizon();

  /** Adds a sun towards this direction. */
  vtkSmartPointer<vtkLight> AddSun(double x, double y, double z);

  /** A lamp at this position aimed at `focus`; from 90 degrees on it shines in all directions. */
  vtkSmartPointer<vtkLight> AddLamp(
    const glm::dvec3& place, const glm::dvec3& focus, double coneAngle);

  /** The shadow stage, attached on first use. */
  vtkRelievoPass* GetFrame();
  vtkRelievoShadowStage* GetShadows();

  double Scale;
  glm::dvec3 Origin;
};

/**
 * Compares the layer shadow_N for the renderer's light N with rays to the triangles of the
 * renderer's actors, or of `truth`.
 */
ShadowErrors JudgeShadow(ShadowStage& stage, int number, const EmbreeScene* truth = nullptr);

/**
 * Compares, prints, and fails unless at most `limit` of the pixels are wrong and at least
 * `leastDark` of them truly dark.
 */
ShadowErrors CheckShadow(ShadowStage& stage, int number, double limit, const std::string& what,
  double leastDark = 0.01, const EmbreeScene* truth = nullptr);

/** The layer shadow_N of a frame drawn for it. */
vtkSmartPointer<vtkImageData> CaptureShadow(ShadowStage& stage, int number);

/** The truth for every pixel of the stage and its light N, with the pixel's surface. */
ShadowTruth TraceStage(ShadowStage& stage, int number, const EmbreeScene* truth = nullptr);

/** The truth without pixels next to others with another verdict, or without any. */
ShadowTruth GetInner(const ShadowTruth& truth, int radius = 1);
}

#endif
