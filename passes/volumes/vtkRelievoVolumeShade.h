// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The shade of a renderer's volumes: their optical depths towards lights, for shaders
// (shaders/volumes/shade.glsl). Nothing is held without volumes that cast.
#ifndef vtkRelievoVolumeShade_h
#define vtkRelievoVolumeShade_h

#include "vtkRelievoOpticalDepths.h"
#include "vtkRelievoPlacedVolume.h"
#include "vtkRelievoVolumeExtinction.h"
#include "vtkRelievoVolumesModule.h" // for the export macro
#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <glm/mat4x4.hpp>

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

class vtkMultiProcessController;
class vtkOpenGLRenderWindow;
class vtkRelievoVolumeExchange;
class vtkShaderProgram;
class vtkWindow;

class VTKRELIEVOVOLUMES_EXPORT vtkRelievoVolumeShade
{
public:
  vtkRelievoVolumeShade();
  ~vtkRelievoVolumeShade();
  vtkRelievoVolumeShade(const vtkRelievoVolumeShade&) = delete;
  void operator=(const vtkRelievoVolumeShade&) = delete;

  // Processes that each hold a part of the volumes, and update their shade together; nullptr: this
  // one holds all.
  void SetController(vtkMultiProcessController* controller);

  // Where other processes have volumes that cast: corners in the world, eight for each.
  const std::vector<glm::dvec3>& GetOthers() const { return this->Others; }

  // An upper bound of the distance of two nodes.
  double GetNodeDistance() const;

  // The volumes that cast in this frame. `colored`: their colours colour the light.
  void SetCasters(const std::vector<vtkRelievoPlacedVolume>& volumes, bool colored)
  {
    this->Casters = volumes;
    this->Colored = colored;
  }

  // Goals for the number of nodes. Tolerance: the share of places whose light may be wrong by more
  // than Slack. Milliseconds: of making the depths towards all lights. 0: none.
  struct Goal
  {
    double Tolerance = 0.0;
    double Milliseconds = 0.0;

    bool IsSet() const { return this->Tolerance > 0.0 || this->Milliseconds > 0.0; }
  };
  static constexpr double Slack = 0.02;

  // The most nodes along an axis, and the harmonics of a series instead of those along rays,
  // without a goal. `varies`: the lights differ between the samples of one picture, which all have
  // the grid that was chosen for the first.
  void SetNodes(int most, int harmonics, const Goal& goal, bool varies = false)
  {
    this->Nodes = most;
    this->Harmonics = goal.IsSet() ? 0 : harmonics;
    this->Goals = goal;
    this->SourcesVary = varies;
  }

  // Larger textures are refused; goals choose smaller ones. Default: 1 GiB.
  void SetMostBytes(double bytes) { this->MostBytes = bytes; }

  // For each light that Update is given, the tangent of half the angle of its rays; 0 unless it is
  // a sun with a size.
  void SetSpreads(const std::vector<double>& tangents) { this->Spreads = tangents; }

  // Brings the depths towards these lights up to date: those that a change of the volumes or of a
  // light concerns. Returns why there are none, or ""; also if the volumes let all light pass. The
  // context is current.
  std::string Update(
    vtkOpenGLRenderWindow* window, std::vector<vtkRelievoOpticalDepths::Source> sources);

  // Whether shaders have to look the depths up; whether a light is among the volumes.
  bool IsMade() const { return this->Texture != 0; }
  bool IsAround() const;

  // Whether the light that passes is coloured.
  bool IsTinted() const { return this->Tinted; }

  // Of the series that shaders evaluate; 0: they interpolate nodes.
  int GetHarmonics() const { return this->Harmonics; }

  // The most nodes of the latest grids, and the expected share of wrong places; -1: unknown.
  int GetNodesMade() const { return this->Texture ? this->NodesMade : 0; }
  double GetExpectedWrongShare() const { return this->Texture ? this->WrongShare : -1.0; }

  // Whether a sun's rays are spread.
  bool IsSpread() const;

  // Between Bind and Unbind, a texture unit is taken. False if there is none.
  bool Bind();
  void Unbind();

  // For the first `lights` lights of the program. `placeToWorld`: from the places that it asks for.
  void SetUniforms(vtkShaderProgram* program, const glm::dmat4& placeToWorld) const;

  // For the frame's report: ", WORDS", or "".
  std::string GetReport() const;

  vtkIdType GetBytes() const; // of the texture
  void Release(vtkWindow* window);

private:
  int ChooseNodes(const std::vector<vtkRelievoOpticalDepths::Source>& sources, int limit);
  void EstimateShares(int limit);
  void MakeDepths(const vtkRelievoOpticalDepths::Source& source, std::size_t light);
  void TakeFirst(std::vector<vtkRelievoOpticalDepths::Source>& sources);
  double CountBytes(const std::vector<vtkRelievoOpticalDepths::Source>& sources, int most) const;
  int GetChannels() const { return this->Tinted ? 4 : 1; } // of a texel
  bool Allocate(int lights);
  bool Upload(std::size_t light);

  std::unique_ptr<vtkRelievoVolumeExchange> Exchange;
  std::vector<vtkRelievoPlacedVolume> Casters;
  bool Colored = false;
  bool Tinted = false;
  int Nodes = 256;
  int Harmonics = 0;
  Goal Goals;
  int NodesMade = 0;
  double WrongShare = -1.0;
  double MillisecondsPerNode = 0.0; // the latest; 0: unknown
  double MostBytes = 1073741824.0;
  bool SourcesVary = false;
  using Estimates = std::vector<std::pair<int, double>>;
  Estimates Shares;                       // expected, by the most nodes
  std::vector<std::uint64_t> SharesState; // of the fields that they were estimated for
  int Chosen = 0;                         // the most nodes, for the goals
  std::vector<std::uint64_t> ChosenState; // the state for which they were chosen
  std::vector<vtkRelievoOpticalDepths::Source> ChosenSources;
  std::vector<std::uint64_t> State; // of the fields and the settings
  std::vector<vtkRelievoVolumeExtinction> Fields;
  vtkRelievoOpticalDepths::Extent Extent; // of all processes' fields
  std::vector<glm::dvec3> Others;
  std::string Fault;     // why this OpenGL refused them
  std::string NotTraced; // the volumes that cast none, with reasons
  std::vector<vtkRelievoOpticalDepths::Source> Sources;
  std::vector<vtkRelievoOpticalDepths> Depths; // one per source
  std::vector<double> Spreads;                 // of their rays
  int Made = 0;                                // in this frame
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  vtkWindow* Owner = nullptr; // equals Window, also in its destructor; only compared
  unsigned int Texture = 0;
  int Size[3] = { 0, 0, 0 }; // of the texture
  int Slices = 0;            // of a light
  int Channels = 1;          // of its texels
  int Unit = -1;
};

#endif
