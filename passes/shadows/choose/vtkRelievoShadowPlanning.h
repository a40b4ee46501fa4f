// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The plan of a frame's shadows: method and map size, as they are set, or for a tolerance or a
// time chosen by vtkRelievoShadowPlanner from what rays and earlier frames tell.
#ifndef vtkRelievoShadowPlanning_h
#define vtkRelievoShadowPlanning_h

#include "vtkRelievoFrameCamera.h"
#include "vtkRelievoShadowPlanner.h"
#include "vtkRelievoShadowProbe.h"
#include "vtkType.h"

#include <cstdint>
#include <vector>

class vtkRelievoFrameContext;
class vtkRelievoShadowLights;
class vtkRenderer;
struct vtkRelievoShadowContext;

class vtkRelievoShadowPlanning
{
public:
  // What is set.
  struct Settings
  {
    int Method = 0;
    int MapSize = 0;
    double Tolerance = 0.0;
    double TimeBudget = 0.0;
    double Bias = 0.0;
    int FilterRadius = 0;
    bool ColoredShadows = false;

    bool HasGoal() const { return this->Tolerance > 0.0 || this->TimeBudget > 0.0; }
  };

  // What is to be drawn.
  struct Scene
  {
    vtkRelievoShadowContext& Work;
    const vtkRelievoShadowLights& Lights;
    bool Together = false;     // with other processes
    bool ExactRefused = false; // OpenGL has no room for rays past what casts
  };

  // A goal is another than before.
  void ForgetRoom(const Settings& settings);
  void ForgetTimes() { this->Planner.Forget(); }

  void ReleaseProbe() { this->Probe.Release(); }
  vtkRelievoShadowProbe& GetProbe() { return this->Probe; }

  ///@{
  // The share of wrong verdicts that a method is expected to have in the picture, by the probe's
  // rays where they can tell. The probe is brought up to date first.
  void UpdateProbe(const Scene& scene, const Settings& settings, vtkRenderer* renderer);
  double GetShareInView(const Scene& scene, const Settings& settings, int method, int size);
  ///@}

  ///@{
  // A frame: its plan, made again if what was planned could not be had, and what the frame
  // took.
  void Begin(bool picture);
  void FindMoves(const Scene& scene, const vtkRelievoFrameCamera& view);
  void Make(const Scene& scene, const Settings& settings, const vtkRelievoFrameContext& context);
  void RefuseRoom(int size); // OpenGL had no memory for such maps
  void SetMade(bool made) { this->Failed = !made; }
  void End(const Scene& scene, bool picture, bool mapsDrawn, vtkMTimeType shaderTime);
  void ForgetView() { this->TimedView = glm::dmat4(0.0); } // the next frame finds everything anew
  void SetNone() { this->Planned = false; }
  ///@}

  // Whether the frame's choice was made for a goal.
  bool IsPlanned() const { return this->Planned; }
  const vtkRelievoShadowPlanner::Plan& Get() const { return this->Plan; }
  double GetMillisecondsTaken() const { return this->Took; } // by the last picture; -1: unknown

private:
  bool HasRoom(int size) const;
  bool Fits(int method, int size, int lights) const;
  std::vector<vtkRelievoShadowPlanner::Choice> GetChoices(
    const Scene& scene, const Settings& settings);

  vtkRelievoShadowProbe Probe;
  vtkRelievoShadowPlanner Planner;
  vtkRelievoShadowPlanner::Plan Plan; // of the frame; without a goal, what is set
  vtkRelievoShadowPlanner::SceneCost Cost;
  vtkRelievoShadowPlanner::Invalidated Moves; // since the frame before
  bool Planned = false;
  bool Fresh = false;       // other than in the frame before
  bool Failed = false;      // what was chosen could not be made
  double RoomRefused = 0.0; // texels of maps that OpenGL had no memory for; 0: none
  double Began = 0.0;       // milliseconds
  double Took = -1.0;       // the last picture
  double Spent = 0.0;       // on planning, in this frame
  vtkMTimeType TimedShaders = 0;
  glm::dmat4 TimedView{ 0.0 };
  std::vector<std::uint64_t> TimedCasters;
  std::vector<double> TimedLights;
};

#endif
