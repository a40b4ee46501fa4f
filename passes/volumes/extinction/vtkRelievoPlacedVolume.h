// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A volume where it is drawn.
#ifndef vtkRelievoPlacedVolume_h
#define vtkRelievoPlacedVolume_h

#include "vtkRelievoVolumesModule.h" // for the export macro

#include <glm/mat4x4.hpp>

#include <cstdint>
#include <string>
#include <vector>

class vtkMatrix4x4;
class vtkVolume;
class vtkVolumeMapper;

struct VTKRELIEVOVOLUMES_EXPORT vtkRelievoPlacedVolume
{
  // Without a matrix to the world: where its own one places it.
  vtkRelievoPlacedVolume(vtkVolume* volume, vtkMatrix4x4* toWorld = nullptr);

  vtkVolume* Volume;
  glm::dmat4 ToWorld;

  // The state of everything that the volume's extinction depends on, for comparison. Cheap.
  // `colored`: with its colours.
  void AddState(bool colored, std::vector<std::uint64_t>& state) const;

  // Why the shader of a volume's mapper, if it has one, cannot place samples in the world by
  // GetTextureToWorld, as the end of a sentence, or "".
  static std::string FindWhyNotPlaced(vtkVolume* volume);

  // From the texture coordinates of the mapper's image, as VTK's ray march has them, to the world.
  static glm::dmat4 GetTextureToWorld(vtkVolumeMapper* mapper, vtkVolume* volume);
};

#endif
