// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BlendScene.h
 * @brief Two panes in front of a wall lit by a lamp, and their expected picture.
 */
#ifndef relievoTestBlendScene_h
#define relievoTestBlendScene_h

#include "Layers.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkRelievoBlendStage.h>
#include <vtkRelievoLampsStage.h>
#include <vtkRelievoPass.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace relievoTest
{
/** How VTK blends where panes overlap: in order of depth, or by their weighted average. */
enum class Blending
{
  Sorted,
  Averaged
};

/**
 * In parallel projection, with the borders of everything on borders of pixels, so that each pixel
 * shows one known surface. The panes are not lit; the wall is, by a lamp in front of it.
 */
struct BlendScene
{
  explicit BlendScene(int samples = 0);

  /** Puts the panes in the scene or takes them out. */
  void ShowPanes(bool on);

  /** Renders, and reads layers of the frame. */
  Layers Read(const std::vector<std::string>& names);

  /** The layer `blend` at a pixel, in double. */
  glm::dvec4 GetBlend(int x, int y, Blending blending) const;

  /** z of the pane in front at a pixel; very far where there is none. */
  double GetNearest(int x, int y) const;

  /** A volume that covers a part of the picture alike, nearer than the panes. */
  void ShowVolume(bool on);

  vtkNew<vtkRenderer> Renderer;
  vtkSmartPointer<vtkRenderWindow> Window;
  vtkSmartPointer<vtkActor> Wall;
  vtkSmartPointer<vtkActor> Panes[2]; // the first is behind
  vtkSmartPointer<vtkProp> Volume;
  vtkRelievoPass* Frame;
  vtkRelievoLampsStage* Lamps;
  vtkRelievoBlendStage* Blend;

private:
  bool IsBefore(int pane, int x, int y) const;
};

/** One premultiplied colour over another. */
glm::dvec4 Over(const glm::dvec4& front, const glm::dvec4& behind);

/** The largest error of a component, relative but for dark values. */
double GetError(const glm::dvec4& value, const glm::dvec4& expected);

/** Half floats for display, then in linear light; Mesa's software cuts their last bits off. */
constexpr double Halves = 8.0 / 1024.0;
/** VTK peels into 8 bits, up to three times one after the other; the curve is steeper than 2. */
constexpr double Bytes = 4.0 / 255.0;

/** A layer of four components at a pixel. */
glm::dvec4 GetColor(const Layers& layers, const std::string& name, int x, int y);
}

#endif
