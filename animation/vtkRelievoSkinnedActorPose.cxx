// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The mesh and the pose that are drawn.
#include "vtkRelievoSkinnedActorInternals.h"

#include "vtkRelievoSkinBones.h"
#include "vtkRelievoSkinMiddle.h"

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
  in.SetAtRest();
  in.PoseTime.Modified();
  in.Shader.Set(this->GetShaderProperty(), this->Mesh, 0, false);
}

//------------------------------------------------------------------------------
void vtkRelievoSkinnedActor::Internals::SetAtRest()
{
  this->Box = relievo::GetBox(this->Rest->GetOutput());
  this->Middle = this->Rest->GetMiddle();
}

//------------------------------------------------------------------------------
// Far from the origin the shader has points and bones about a middle, of the mesh and of the pose;
// what lies between these and the world is in VTK's matrices, in double.
void vtkRelievoSkinnedActor::Internals::SetMoved(const std::vector<glm::dmat4>& matrices, bool dual)
{
  const relievo::SkinBounds& bounds = this->Rest->GetSkinBounds();
  const glm::dvec3 rest = this->Rest->GetMiddle();
  std::vector<glm::dmat4> about = relievo::GetMatricesAbout(matrices, rest, glm::dvec3(0.));
  const auto getBox = [&]() {
    return dual ? bounds.GetOfMotions(about, this->UnmovedBy)
                : bounds.GetOfMatrices(about, this->UnmovedBy);
  };
  this->UnmovedBy = rest;
  this->Box = getBox();
  this->Middle = relievo::GetFarMiddle(this->Box);
  if (this->Middle != glm::dvec3(0.))
  {
    // Once more, as its rounding is much there.
    about = relievo::GetMatricesAbout(matrices, rest, this->Middle);
    this->UnmovedBy = rest - this->Middle;
    this->Box = getBox();
    this->Box.Move(this->Middle);
  }
  if (dual)
  {
    this->Bones.SetMotions(about);
  }
  else
  {
    this->Bones.SetMatrices(about);
  }
  // Floats would lose what the pose moves so far.
  this->Skin->SetOutputPointsPrecision(this->Middle != glm::dvec3(0.)
      ? vtkAlgorithm::DOUBLE_PRECISION
      : vtkAlgorithm::DEFAULT_PRECISION);
  relievo::SkinBox box = relievo::GetBox(this->Rest->GetOutput());
  box.Move(-rest);
  // Roundings in a row, here and in vtkRelievoSkin, which the shader is compared with.
  this->Reach = (dual ? 8. : 4.) * GetLargest(box, about);
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
  in.Middle = glm::dvec3(0.);
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
    this->Mesh->SetInputConnection(in.Rest->GetOutputPort(1));
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
    in.SetAtRest();
    in.Reach = 0.;
  }
  else
  {
    in.SetMoved(matrices, dual);
  }
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
