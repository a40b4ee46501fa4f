// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The plan of a frame's shadows: method and map size as set, or chosen by vtkRelievoShadowPlanner
// for a tolerance or a time, from rays and earlier frames.
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
  // The settings.
  struct Settings
  {
    int Method = 0;
    int MapSize = 0;
    double Tolerance = 0.0;
    double TimeBudget = 0.0;
    double Bias = 0.0;
    int FilterRadius = 0;
    bool ColoredShadows = false;
    int VolumeNodes = 0;
    int VolumeHarmonics = 0;

    bool HasGoal() const { return this->Tolerance > 0.0 || this->TimeBudget > 0.0; }
  };

  // The scene to draw.
  struct Scene
  {
    vtkRelievoShadowContext& Work;
    const vtkRelievoShadowLights& Lights;
    bool Together = false;     // with other processes
    bool ExactRefused = false; // OpenGL has no room for the casters' triangles
  };

  // Call when a goal has changed.
  void ForgetRoom(const Settings& settings);
  void ForgetTimes() { this->Planner.Forget(); }

  void ReleaseProbe() { this->Probe.Release(); }
  vtkRelievoShadowProbe& GetProbe() { return this->Probe; }

  ///@{
  // The expected share of wrong verdicts of a method in the picture, by the probe's rays if they
  // apply. Updates the probe first.
  void UpdateProbe(const Scene& scene, const Settings& settings, vtkRenderer* renderer);
  double GetShareInView(const Scene& scene, const Settings& settings, int method, int size);
  ///@}

  ///@{
  // A frame: its plan, renewed if the planned method is impossible, and its time.
  void Begin(bool picture);
  void FindMoves(const Scene& scene, const vtkRelievoFrameCamera& view);
  void Make(const Scene& scene, const Settings& settings, const vtkRelievoFrameContext& context);
  void RefuseRoom(int size); // OpenGL had no memory for such maps
  void SetMade(bool made) { this->Failed = !made; }
  void End(const Scene& scene, bool picture, bool mapsDrawn, vtkMTimeType shaderTime);
  void ForgetView() { this->TimedView = glm::dmat4(0.0); } // the next frame counts as new
  void SetNone() { this->Planned = false; }
  ///@}

  // Whether a goal determined the frame's choice.
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
  vtkRelievoShadowPlanner::Plan Plan; // of the frame; without a goal, the settings
  vtkRelievoShadowPlanner::SceneCost Cost;
  vtkRelievoShadowPlanner::Invalidated Moves; // changes since the previous frame
  bool Planned = false;
  bool Fresh = false;       // differs from the previous frame's
  bool Failed = false;      // the chosen method is impossible
  double RoomRefused = 0.0; // texels of maps that OpenGL had no memory for; 0: none
  double Began = 0.0;       // milliseconds
  double Took = -1.0;       // of the last picture
  double Spent = 0.0;       // planning time in this frame
  vtkMTimeType TimedShaders = 0;
  glm::dmat4 TimedView{ 0.0 };
  std::vector<std::uint64_t> TimedCasters;
  std::vector<double> TimedLights;
};

#endif
