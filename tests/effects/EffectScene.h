// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EffectScene.h
 * @brief Helpers shared by the scenes of fog and markers: props, cameras, layers, pictures.
 */
#ifndef relievoTestEffectScene_h
#define relievoTestEffectScene_h

#include "Layers.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoPointStage.h>
#include <vtkRelievoPointValues.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <glm/glm.hpp>

#include <functional>
#include <string>
#include <vector>

namespace relievoTest
{
/** The picture without and with a stage. */
struct EffectPictures
{
  vtkSmartPointer<vtkImageData> Plain;
  vtkSmartPointer<vtkImageData> Shown;

  /**
   * Upper bound of the difference, in levels of 255, between a pixel and the value computed from
   * the plain picture: `passes` of its light, plus `added`.
   */
  double GetError(int x, int y, double passes, const glm::dvec3& added) const;
};

/** A renderer with a frame in a window; all is moved by the origin, camera included. */
class EffectScene
{
public:
  EffectScene(int width, int height, const glm::dvec3& origin);

  /** Layers of a frame that draws the picture as well; depth as the pixel's centre has it. */
  Layers Read(const std::vector<std::string>& names);

  vtkNew<vtkRenderer> Renderer;
  vtkSmartPointer<vtkRenderWindow> Window;
  vtkRelievoPass* Frame;

protected:
  vtkSmartPointer<vtkActor> Add(
    vtkPolyData* mesh, const glm::dvec3& place, double red, double green, double blue);
  void LookFrom(const glm::dvec3& place, const glm::dvec3& focus);
  EffectPictures Draw(vtkRelievoStage* stage);

  glm::dvec3 Origin;
};

/** A way to look at a scene. */
struct Look
{
  const char* Name;
  std::function<void(vtkCamera*)> Set;
};

/** In perspective, in parallel, and in parallel sheared and off-centre. */
extern const std::vector<Look> PlainLooks;

/** Fails the test unless each layer and the colour equal the expectation to the last bit. */
void CheckSame(const Layers& expected, EffectScene& scene, const std::string& layer);

/**
 * A set is added once, a second time is an error; of blocks, of which the second has nothing to
 * draw, the layer is as expected. Leaves the set with `good` without its arrays.
 */
void CheckBlocks(EffectScene& scene, vtkRelievoPointStage* stage, vtkRelievoPointValues* set,
  vtkPolyData* good, vtkPolyData* bad, const Layers& expected, const std::string& layer);

/** An invalid array for a value, and the message. */
struct InvalidArray
{
  const char* Value;
  const char* Array;
  const char* Says;
};

/** Adds the arrays `pairs` and `words`, draws the points, and has each invalid array said once. */
void CheckWrongArrays(EffectScene& scene, vtkRelievoPointValues* set, vtkPolyData* points,
  const std::vector<InvalidArray>& invalid);

/** A picture of 60 pixels' width alone, and in the right half of a window of two viewports. */
void CheckBeside(EffectScene& alone, EffectScene& both, const std::vector<int>& columns, int row);

/**
 * The picture is as shown, and no more is held, after 200 times off and on, in which `change` is
 * called, and after another size; the scene has 60 x 45 pixels.
 */
void CheckToggles(EffectScene& scene, vtkRelievoStage* stage, vtkImageData* shown,
  const std::function<void(int)>& change = nullptr);

/** Switches a stage off: it makes no layer, and says so. */
void CheckOff(EffectScene& scene, const std::string& stage, const std::string& layer);
}

#endif
