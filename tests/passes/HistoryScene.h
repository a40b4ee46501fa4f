// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HistoryScene.h
 * @brief A state that a renderer can be brought into, from the start or from any other state.
 */
#ifndef relievoTestHistoryScene_h
#define relievoTestHistoryScene_h

#include <vtkActor.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <glm/glm.hpp>

#include <array>
#include <random>
#include <string>
#include <vector>

class vtkImageData;

namespace relievoTest
{
/** One of the numbers below `count`. */
int Pick(std::mt19937& random, int count);

/** Everything that a picture may depend on, and nothing that it may not. */
struct HistoryState
{
  struct Prop
  {
    bool Visible = true;
    glm::dvec3 Position{ 0. };
    double Turn = 0.;
    double Opacity = 1.;
    int Representation = 2;
    int Interpolation = 1;
    int Culling = 0;  // 1: back, 2: front
    double Size = 1.; // of points and lines
    bool Edges = false;
    bool Clipped = false;
    int Casts = -1;
    bool Receives = true;
  };
  struct Light
  {
    bool On = true;
    glm::dvec3 Position{ 0. };
    double Attenuation = 1.;
    bool Casts = true;
  };
  static constexpr int NumberOfProps = 7;
  static constexpr int NumberOfLights = 4;

  std::array<Prop, NumberOfProps> Props;
  std::vector<int> Order; // of the props that the renderer has
  std::array<Light, NumberOfLights> Lights;
  glm::dvec3 Eye{ 2.5, 3., 6. };
  glm::dvec3 Focus{ 0., 0.5, 0. };
  double ViewAngle = 30.;
  bool Parallel = false;
  int Size[2] = { 160, 120 };
  bool Part = false; // the renderer takes a part of the window
  bool Peeling = false;
  bool Offset = false; // polygons are pushed back, VTK's setting of the process
  bool Stereo = false;

  bool Attached = true;
  bool Shadows = true;
  int Method = 0;
  int MapSize = 256;
  int Radius = 1;
  double Bias = 1.5;
  double Strength = 1.;
  std::vector<std::string> Layers; // requested
  std::string Shown;               // or empty: the picture

  HistoryState();

  /** One more step of a walk; returns its description. */
  std::string Step(std::mt19937& random);
};

/** A renderer in a window of its own that can be brought into any state. */
class HistoryScene
{
public:
  HistoryScene();
  ~HistoryScene();
  HistoryScene(const HistoryScene&) = delete;
  void operator=(const HistoryScene&) = delete;

  void Take(const HistoryState& state);

  /** The picture, with the layers that are requested as more arrays. */
  vtkSmartPointer<vtkImageData> Draw(const HistoryState& state);

  /** Something that must leave no traces: a frame, a screenshot, a capture, a selection. */
  std::string Disturb(std::mt19937& random);

  long long GetBytesHeld();

  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderer> Back; // draws parts covered by no other renderer, which VTK leaves unchanged
  vtkSmartPointer<vtkRenderWindow> Window;

private:
  bool Offset = false;
  std::vector<vtkSmartPointer<vtkActor>> Actors;
  std::vector<vtkSmartPointer<vtkLight>> Lights;
};
}

#endif
