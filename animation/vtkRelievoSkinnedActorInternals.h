// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What vtkRelievoSkinnedActor holds.
 */
#ifndef vtkRelievoSkinnedActorInternals_h
#define vtkRelievoSkinnedActorInternals_h

#include "vtkRelievoBoneTexture.h"
#include "vtkRelievoSkin.h"
#include "vtkRelievoSkinBounds.h"
#include "vtkRelievoSkinRest.h"
#include "vtkRelievoSkinShader.h"
#include "vtkRelievoSkinnedActor.h"

#include "vtkPolyData.h"
#include "vtkTimeStamp.h"

#include <glm/mat4x4.hpp>

#include <string>
#include <vector>

struct vtkRelievoSkinnedActor::Internals
{
  vtkNew<vtkRelievoSkinRest> Rest;
  vtkNew<vtkPolyData> Nothing;
  vtkNew<vtkRelievoSkin> Skin; // holds the inputs, and moves on the CPU where that is needed
  relievo::BoneTexture Bones;

  // What the pose was made of.
  vtkMTimeType MeshTime = 0;
  vtkMTimeType RestVersion = 0; // of what is moved, of all that the mesh has
  vtkMTimeType SkeletonTime = 0;
  vtkPolyData* Skeleton = nullptr;
  bool BindPose = false;
  int Method = -1;

  std::vector<glm::dmat4> Matrices;
  relievo::SkinBox Box;
  double Reach = 0.;     // what the shader rounds
  std::size_t Unfit = 0; // texels of bones that the window refused; 0: none yet
  std::string WhyUnfit;
  vtkNew<vtkPolyData> Moved;  // on the CPU, if it is
  vtkMTimeType MovedTime = 0; // PoseTime, of the pose that it has
  vtkMTimeType MovedMesh = 0; // MeshTime, of the mesh that it has
  vtkTimeStamp PoseTime;
  std::string Said; // what is wrong, for the last time
  relievo::SkinShader Shader;
};

#endif
