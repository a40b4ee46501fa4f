// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The mesh and the pose that are drawn.
#include "vtkRelievoSkinnedActorInternals.h"

#include "vtkRelievoSkinBones.h"

#include "vtkAlgorithmOutput.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkShaderProperty.h"
#include "vtkUniforms.h"

#include <glm/common.hpp>

#include <algorithm>

namespace
{
// The largest number that moving the points of a box has on its way.
double GetLargest(const relievo::SkinBox& box, const std::vector<glm::dmat4>& matrices)
{
  const glm::dvec3 p = glm::max(glm::abs(box.Low), glm::abs(box.High));
  double largest = 0.;
  for (const glm::dmat4& m : matrices)
  {
    const glm::dvec3 on =
      glm::abs(m[0]) * p.x + glm::abs(m[1]) * p.y + glm::abs(m[2]) * p.z + glm::abs(m[3]);
    largest = std::max({ largest, on.x, on.y, on.z });
  }
  return largest;
}

relievo::SkinBox GetBox(vtkPolyData* mesh)
{
  relievo::SkinBox box;
  const double* b = mesh->GetBounds();
  if (mesh->GetNumberOfPoints() > 0)
  {
    box.Add(glm::dvec3(b[0], b[2], b[4]));
    box.Add(glm::dvec3(b[1], b[3], b[5]));
  }
  return box;
}
}

//------------------------------------------------------------------------------
// Said once, until all is well again.
void vtkRelievoSkinnedActor::Complain(const std::string& wrong)
{
  if (wrong != this->Inside->Said)
  {
    vtkErrorMacro("" << wrong);
  }
  this->Inside->Said = wrong;
}

//------------------------------------------------------------------------------
void vtkRelievoSkinnedActor::Refuse(const std::string& wrong)
{
  Internals& in = *this->Inside;
  this->Complain(wrong + ". The mesh is drawn at rest.");
  in.Matrices.clear();
  in.Reach = 0.;
  in.Box = GetBox(in.Rest->GetOutput());
  in.PoseTime.Modified();
  in.Shader.Set(this->GetShaderProperty(), this->Mesh, 0, false);
}

//------------------------------------------------------------------------------
// VTK's mappers want a mesh, be it empty: until it is known that there is one.
void vtkRelievoSkinnedActor::Disconnect()
{
  Internals& in = *this->Inside;
  if (this->Mesh->GetInput() != in.Nothing)
  {
    this->Mesh->SetInputData(in.Nothing);
  }
  in.MeshTime = 0;
  in.RestVersion = 0;
  in.Box = relievo::SkinBox();
}

//------------------------------------------------------------------------------
vtkPolyData* vtkRelievoSkinnedActor::UpdateMesh()
{
  Internals& in = *this->Inside;
  vtkDataObject* given = nullptr;
  if (in.Rest->GetNumberOfInputConnections(0) > 0)
  {
    in.Rest->GetInputAlgorithm()->Update(in.Rest->GetInputConnection(0, 0)->GetIndex());
    given = in.Rest->GetInputDataObject(0, 0);
  }
  if (vtkPolyData::SafeDownCast(given))
  {
    this->Mesh->SetInputConnection(in.Rest->GetOutputPort());
    in.Rest->Update();
    return in.Rest->GetOutput();
  }
  this->Disconnect();
  if (given)
  {
    this->Complain(std::string("the mesh is a ") + given->GetClassName() +
      ", expected vtkPolyData: make an actor for each block");
  }
  return nullptr;
}

//------------------------------------------------------------------------------
void vtkRelievoSkinnedActor::UpdatePose()
{
  Internals& in = *this->Inside;
  vtkPolyData* mesh = this->UpdateMesh();
  if (!mesh)
  {
    return;
  }
  vtkPolyData* skeleton = nullptr;
  if (vtkAlgorithmOutput* port =
        in.Skin->GetNumberOfInputConnections(1) > 0 ? in.Skin->GetInputConnection(1, 0) : nullptr)
  {
    port->GetProducer()->Update(port->GetIndex());
    skeleton =
      vtkPolyData::SafeDownCast(port->GetProducer()->GetOutputDataObject(port->GetIndex()));
  }
  const bool newMesh = in.MeshTime != mesh->GetMTime();
  const vtkMTimeType skeletonTime = skeleton ? skeleton->GetMTime() : 0;
  if (!newMesh && in.Skeleton == skeleton && in.SkeletonTime == skeletonTime &&
    in.BindPose == this->BindPose && in.Method == this->GetMethod() &&
    in.Shader.IsIn(this->GetShaderProperty()))
  {
    return;
  }
  const bool newMethod = in.Method != this->GetMethod();
  const bool newRest = in.RestVersion != in.Rest->GetVersion();
  in.MeshTime = mesh->GetMTime();
  in.RestVersion = in.Rest->GetVersion();
  in.Skeleton = skeleton;
  in.SkeletonTime = skeletonTime;
  in.BindPose = this->BindPose;
  in.Method = this->GetMethod();

  std::vector<glm::dmat4> matrices;
  const bool dual = in.Method == vtkRelievoSkin::DUAL_QUATERNION;
  std::string wrong = in.Rest->GetWrong();
  if (wrong.empty() && !this->BindPose && mesh->GetNumberOfPoints() > 0)
  {
    const bool keys = in.Method == vtkRelievoSkin::KEY_MATRIX;
    wrong = skeleton ? relievo::GetBoneMatrices(mesh, skeleton, keys, matrices)
                     : "there is no skeleton: expected polydata with the point array pose";
  }
  const std::size_t texels = matrices.size() * (dual ? 5 : 3);
  if (in.Unfit > 0 && texels >= in.Unfit)
  {
    wrong = in.WhyUnfit;
  }
  if (newRest && in.Rest->GetNumberOfCut() > 0)
  {
    vtkWarningMacro(<< in.Rest->GetNumberOfCut() << " points have more than "
                    << vtkRelievoSkinRest::MostInfluences
                    << " bones; the weaker ones are left out. vtkRelievoSkin takes any number.");
  }
  if (!wrong.empty())
  {
    this->Refuse(wrong);
    return;
  }
  in.Shader.Set(
    this->GetShaderProperty(), this->Mesh, this->BindPose ? 0 : in.Rest->GetInfluences(), dual);
  if (!newRest && !newMethod && matrices == in.Matrices)
  {
    return;
  }
  in.Matrices = matrices;
  if (!in.Shader.Moves())
  {
    in.Box = GetBox(mesh);
  }
  else if (!dual)
  {
    in.Bones.SetMatrices(matrices);
    in.Box = in.Rest->GetSkinBounds().GetOfMatrices(matrices);
  }
  else
  {
    in.Bones.SetMotions(matrices);
    in.Box = in.Rest->GetSkinBounds().GetOfMotions(matrices);
  }
  // Roundings in a row, here and in vtkRelievoSkin, which the shader is compared with.
  in.Reach = (dual ? 8. : 4.) * GetLargest(GetBox(mesh), matrices);
  in.PoseTime.Modified();
  // What draws this actor anew: shadow maps, kept frames.
  this->GetShaderProperty()->GetVertexCustomUniforms()->Modified();
}

//------------------------------------------------------------------------------
vtkPolyData* vtkRelievoSkinnedActor::GetMovedMesh()
{
  Internals& in = *this->Inside;
  this->UpdatePose();
  if (in.MeshTime == 0)
  {
    return nullptr;
  }
  if (!in.Shader.Moves())
  {
    return in.Rest->GetOutput();
  }
  if (in.MovedTime != in.PoseTime.GetMTime())
  {
    in.Skin->Update();
    in.Moved->ShallowCopy(in.Skin->GetOutput());
  }
  else if (in.MovedMesh != in.MeshTime)
  {
    // Only what does not move is another, such as colours.
    vtkNew<vtkPolyData> moved;
    moved->ShallowCopy(in.Moved);
    in.Moved->ShallowCopy(in.Rest->GetOutput());
    in.Moved->SetPoints(moved->GetPoints());
    in.Moved->GetPointData()->SetNormals(moved->GetPointData()->GetNormals());
    in.Moved->GetPointData()->SetTangents(moved->GetPointData()->GetTangents());
    in.Moved->SetFieldData(moved->GetFieldData());
  }
  if (in.MovedTime != in.PoseTime.GetMTime() || in.MovedMesh != in.MeshTime)
  {
    for (int four = 0; four < 2; ++four)
    {
      in.Moved->GetPointData()->RemoveArray(vtkRelievoSkinRest::GetJointsName(four));
      in.Moved->GetPointData()->RemoveArray(vtkRelievoSkinRest::GetWeightsName(four));
    }
  }
  in.MovedTime = in.PoseTime.GetMTime();
  in.MovedMesh = in.MeshTime;
  return in.Moved;
}
