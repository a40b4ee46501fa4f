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

#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTimeStamp.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

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
  glm::dvec3 Middle{ 0. };    // about which the shader has its moved points
  glm::dvec3 UnmovedBy{ 0. }; // of points without a bone: from about one middle to about the other
  bool Draws = false;         // VTK asks where these points are, not the mesh's own
  vtkNew<vtkMatrix4x4> Placed;
  vtkNew<vtkMatrix4x4> PlacedTransposed;
  double Reach = 0.;     // what the shader rounds
  std::size_t Unfit = 0; // texels of bones that the window refused; 0: none yet
  std::string WhyUnfit;
  vtkNew<vtkPolyData> Moved;  // on the CPU, if it is
  vtkMTimeType MovedTime = 0; // PoseTime, of the pose that it has
  vtkMTimeType MovedMesh = 0; // MeshTime, of the mesh that it has
  vtkTimeStamp PoseTime;
  std::string Said; // what is wrong, for the last time
  relievo::SkinShader Shader;

  void SetAtRest();
  void SetMoved(const std::vector<glm::dmat4>& matrices, bool dual);
};

#endif
