// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What vtkRelievoShadowPass holds beside its settings.
#ifndef vtkRelievoShadowInternals_h
#define vtkRelievoShadowInternals_h

#include "vtkOpenGLRenderWindow.h"
#include "vtkRelievoFramePass.h"
#include "vtkRelievoLampMaps.h"
#include "vtkRelievoLightSamples.h"
#include "vtkRelievoShadowCertificate.h"
#include "vtkRelievoShadowLights.h"
#include "vtkRelievoShadowMethod.h"
#include "vtkRelievoShadowPass.h"
#include "vtkRelievoShadowPlanner.h"
#include "vtkRelievoShadowProbe.h"
#include "vtkRelievoShadowSchedule.h"
#include "vtkRelievoShadowStrengths.h"
#include "vtkRelievoShadowWork.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkTimeStamp.h"
#include "vtkWeakPointer.h"

#include <memory>
#include <set>
#include <string>

class vtkShaderProgram;

class vtkRelievoShadowPass::Internals
{
public:
  vtkRelievoShadowLights Lights;
  vtkRelievoLightSizes Sizes; // of lights
  int Samples = 1;            // of them, in this frame
  int Gathered = 0;
  vtkRelievoShadowCasters Casters; // of all maps
  vtkRelievoShadowWork Work{ Casters };
  vtkRelievoShadowSchedule Schedule;
  vtkRelievoLampMaps Lamps{ Casters }; // from data
  vtkRelievoShadowProbe Probe;
  vtkRelievoShadowPlanner Planner;
  vtkRelievoShadowPlanner::Plan Plan; // of the frame; without a wish, what is set
  vtkRelievoShadowPlanner::Load Load;
  bool Planned = false;
  double RoomRefused = 0.0; // texels of maps that OpenGL had no memory for; 0: none
  bool Fresh = false;       // other than in the frame before
  bool Failed = false;      // what was chosen could not be made
  double Began = 0.0;       // milliseconds
  double Took = -1.0;       // the last picture
  double Planning = 0.0;    // of this frame
  vtkMTimeType TimedStructure = 0;
  glm::dmat4 TimedView{ 0.0 };
  std::vector<std::uint64_t> TimedCasters;
  std::vector<double> TimedLights;
  vtkRelievoShadowPlanner::Anew Moves; // since the frame before
  std::unique_ptr<vtkRelievoShadowMethod> Method = vtkRelievoShadowMethod::Make(METHOD_MAP);
  int MethodMade = METHOD_MAP;
  int MethodRefused = -1; // could not make shadows of what cast so
  std::vector<std::uint64_t> Refused;
  vtkTimeStamp StructureTime;
  bool LayersAsked = false;                     // visibility is asked for as a layer
  bool LightsAsked = false;                     // shadows of the renderer's lights
  bool LampsAsked = false;                      // and of lamps from data
  vtkWeakPointer<vtkOpenGLRenderWindow> Window; // of the frame
  vtkWeakPointer<vtkRenderer> Renderer;
  vtkWeakPointer<vtkRelievoFramePass> Frame;
  vtkSmartPointer<vtkRelievoShadowCertificate> Certificate;
  std::set<vtkShaderProgram*> Told;    // programs that have this frame's uniforms
  std::set<std::string> Said;          // warnings and errors
  vtkRelievoShadowStrengths Strengths; // of the lights of this frame
  bool Spliced = false;
  bool Strayed = false; // shaders without shadows were built with this pass in their keys

  // Makes the method, if it is another one than in the frame before. The context is current.
  void UseMethod(int method, vtkOpenGLRenderWindow* window);

  void BeginTiming(bool picture);
  void FindMoves(const vtkRelievoView& view);

  // Whether a map is being drawn: notes the program that draws into it.
  bool IsDrawingMaps(vtkShaderProgram* program);

  // Shaders are built anew if they are to be others than in the frame before.
  void UpdateStructure();
};

#endif
