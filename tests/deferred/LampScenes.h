// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LampScenes.h
 * @brief A scene with lamps, and their contribution: in double, from position and normal.
 */
#ifndef relievoTestLampScenes_h
#define relievoTestLampScenes_h

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRelievoLamps.h>
#include <vtkRelievoLampsStage.h>
#include <vtkRelievoPass.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <glm/glm.hpp>

#include <string>
#include <vector>

class vtkImageData;

namespace relievoTest
{
/** One lamp, as data. */
struct Lamp
{
  glm::dvec3 Place;
  double Radius;
  double Intensity;
  glm::dvec3 Color;
};

/** A sphere and a cone on a floor with a wall behind, in a window with a frame and its lamps. */
struct LampScene
{
  /** All is moved by `offset`, camera included. */
  LampScene(int width, int height, const glm::dvec3& offset = glm::dvec3(0.0));

  /** Adds a set of lamps to the stage. */
  vtkSmartPointer<vtkRelievoLamps> AddLamps(const std::vector<Lamp>& lamps);

  /** Renders, and reads layers of the frame. */
  vtkSmartPointer<vtkImageData> Read(const std::vector<std::string>& layers);

  vtkNew<vtkRenderer> Renderer;
  vtkSmartPointer<vtkRenderWindow> Window;
  vtkRelievoPass* Frame;
  vtkRelievoLampsStage* Stage;
};

/** Lamps in a box around the scene of LampScene; the same for the same numbers. */
std::vector<Lamp> RandomLamps(
  int count, double radius, bool white, const glm::dvec3& offset = glm::dvec3(0.0));

/** The lamps as points with the arrays radius, intensity and color. */
vtkSmartPointer<vtkPolyData> ToPolyData(const std::vector<Lamp>& lamps);

/** The light of lamps at a point. */
struct LampSum
{
  glm::dvec3 Light = glm::dvec3(0.0);
  /** How many lamps reach it. */
  int Reaching = 0;
  /** By how much the light may change, at most, for each unit that the point is moved. */
  double Slope = 0.0;
};
LampSum SumLight(const std::vector<Lamp>& lamps, int falloff, const glm::dvec3& attenuation,
  const glm::dvec3& place, const glm::dvec3& normal);

/**
 * Compares the layer `light` of an image with the sum at its `position` and `normal`, and fails the
 * test where they differ by more than the rounding to half floats and of the point's place, which
 * is a float in eye space: `place` of the distance from the eye. Returns the number of lit pixels.
 */
long long CheckLight(vtkImageData* image, const std::vector<Lamp>& lamps, int falloff,
  const glm::dvec3& attenuation, const std::string& what, double place = 1e-6);
}

#endif
