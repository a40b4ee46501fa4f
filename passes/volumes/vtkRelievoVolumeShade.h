// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The shade of a renderer's volumes: their optical depths towards lights, for shaders
// (shaders/volumes/shade.glsl). Nothing is held without volumes that cast.
#ifndef vtkRelievoVolumeShade_h
#define vtkRelievoVolumeShade_h

#include "vtkRelievoOpticalDepths.h"
#include "vtkRelievoVolumeExtinction.h"
#include "vtkRelievoVolumesModule.h" // for the export macro
#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <glm/mat4x4.hpp>

#include <cstdint>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

class VTKRELIEVOVOLUMES_EXPORT vtkRelievoVolumeShade
{
public:
  vtkRelievoVolumeShade();
  ~vtkRelievoVolumeShade();
  vtkRelievoVolumeShade(const vtkRelievoVolumeShade&) = delete;
  void operator=(const vtkRelievoVolumeShade&) = delete;

  // The volumes that cast in this frame.
  void SetCasters(const std::vector<vtkRelievoPlacedVolume>& volumes) { this->Casters = volumes; }

  // For each light that Update is given, the tangent of half the angle of its rays; 0 unless it is
  // a sun with a size.
  void SetSpreads(const std::vector<double>& tangents) { this->Spreads = tangents; }

  // Brings the depths towards these lights up to date: those that a change of the volumes or of a
  // light concerns. Returns why there are none, or ""; also if the volumes let all light pass. The
  // context is current.
  std::string Update(
    vtkOpenGLRenderWindow* window, const std::vector<vtkRelievoOpticalDepths::Source>& sources);

  // Whether shaders have to look the depths up; whether a light is among the volumes.
  bool IsMade() const { return this->Texture != 0; }
  bool IsAround() const;

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

  // Nodes along each axis of a grid.
  static constexpr int Most = 256;

private:
  bool Allocate(int lights);
  bool Upload(std::size_t light);

  std::vector<vtkRelievoPlacedVolume> Casters;
  std::vector<std::uint64_t> State; // of the fields and the most nodes
  std::vector<vtkRelievoVolumeExtinction> Fields;
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
  int Unit = -1;
};

#endif
