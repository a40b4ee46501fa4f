// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSkinnedActor.h"

#include "vtkAlgorithmOutput.h"
#include "vtkCommand.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkRelievoBoneTexture.h"
#include "vtkRelievoReportOnce.h"
#include "vtkRelievoSkin.h"
#include "vtkRelievoSkinBones.h"
#include "vtkRelievoSkinBounds.h"
#include "vtkRelievoSkinOrigin.h"
#include "vtkRelievoSkinRestPose.h"
#include "vtkRelievoSkinShader.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkShaderProperty.h"
#include "vtkTimeStamp.h"
#include "vtkUniforms.h"

#include <glm/common.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

struct vtkRelievoSkinnedActor::Internals
{
  vtkNew<vtkRelievoSkinRestPose> Rest;
  vtkNew<vtkPolyData> Nothing;
  vtkNew<vtkRelievoSkin> Skin; // holds the inputs, and moves the mesh on the CPU if needed
  relievo::BoneTexture Bones;

  // Times of the inputs of the pose.
  vtkMTimeType MeshTime = 0;
  vtkMTimeType RestVersion = 0; // version of the moved data; MeshTime covers all data
  vtkMTimeType SkeletonTime = 0;
  vtkPolyData* Skeleton = nullptr;
  bool BindPose = false;
  int Method = -1;

  std::vector<glm::dmat4> Matrices;
  relievo::SkinBox Box;
  glm::dvec3 Middle{ 0. };    // the shader's moved points are relative to it
  glm::dvec3 UnmovedBy{ 0. }; // for points without a bone: between the two middles
  bool Draws = false;         // while VTK draws the moved points
  vtkNew<vtkMatrix4x4> Placed;
  vtkNew<vtkMatrix4x4> PlacedTransposed;
  double Reach = 0.;     // bound of the shader's rounding
  std::size_t Unfit = 0; // number of texels that the window refused; 0: none so far
  std::string WhyUnfit;
  vtkNew<vtkPolyData> Moved;  // moved on the CPU, if requested
  vtkMTimeType MovedTime = 0; // PoseTime of its pose
  vtkMTimeType MovedMesh = 0; // MeshTime of its mesh
  vtkTimeStamp PoseTime;
  vtkRelievoReportOnce Reported;
  relievo::SkinShader Shader;

  void SetAtRest();
  void SetMoved(const std::vector<glm::dmat4>& matrices, bool dual);
};

vtkStandardNewMacro(vtkRelievoSkinnedActor);

namespace
{
void CopyBox(const relievo::SkinBox& box, double bounds[6])
{
  vtkMath::UninitializeBounds(bounds);
  for (int axis = 0; axis < 3 && !box.IsEmpty(); ++axis)
  {
    bounds[2 * axis] = box.Low[axis];
    bounds[2 * axis + 1] = box.High[axis];
  }
}

// The largest number that occurs while the points of a box are moved.
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
vtkRelievoSkinnedActor::vtkRelievoSkinnedActor()
  : Internal(new Internals)
{
  this->Disconnect();
  // Limited to the number of bones that the shader supports.
  this->Internal->Skin->SetInputConnection(0, this->Internal->Rest->GetOutputPort());
  // Bones need original points, not shifted and scaled ones.
  if (auto* mapper = vtkOpenGLPolyDataMapper::SafeDownCast(this->Mesh))
  {
    mapper->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE);
  }
  this->Mesh->AddObserver(
    vtkCommand::UpdateShaderEvent, this, &vtkRelievoSkinnedActor::SetUniforms);
  this->SetMapper(this->Mesh);
}

//------------------------------------------------------------------------------
vtkRelievoSkinnedActor::~vtkRelievoSkinnedActor() = default;

//------------------------------------------------------------------------------
void vtkRelievoSkinnedActor::SetInputConnection(vtkAlgorithmOutput* port)
{
  this->Disconnect();
  this->Internal->Rest->SetInputConnection(port);
}

//------------------------------------------------------------------------------
void vtkRelievoSkinnedActor::SetInputData(vtkPolyData* mesh)
{
  this->Disconnect();
  this->Internal->Rest->SetInputData(mesh);
}

//------------------------------------------------------------------------------
void vtkRelievoSkinnedActor::SetSkeletonConnection(vtkAlgorithmOutput* port)
{
  this->Internal->Skin->SetInputConnection(1, port);
}

//------------------------------------------------------------------------------
void vtkRelievoSkinnedActor::SetSkeletonData(vtkPolyData* skeleton)
{
  this->Internal->Skin->SetInputData(1, skeleton);
}

//------------------------------------------------------------------------------
void vtkRelievoSkinnedActor::SetMethod(int method)
{
  this->Internal->Skin->SetMethod(method);
}

//------------------------------------------------------------------------------
int vtkRelievoSkinnedActor::GetMethod()
{
  return this->Internal->Skin->GetMethod();
}

//------------------------------------------------------------------------------
vtkPolyDataMapper* vtkRelievoSkinnedActor::GetPolyDataMapper()
{
  return this->Mesh;
}

//------------------------------------------------------------------------------
double* vtkRelievoSkinnedActor::GetBounds()
{
  this->UpdatePose();
  const relievo::SkinBox& box = this->Internal->Box;
  if (box.IsEmpty())
  {
    CopyBox(box, this->Bounds);
    return this->Bounds;
  }
  vtkMatrix4x4* matrix = this->Superclass::GetMatrix();
  glm::dmat4 toWorld;
  for (int i = 0; i < 16; ++i)
  {
    toWorld[i % 4][i / 4] = matrix->GetElement(i / 4, i % 4);
  }
  relievo::SkinBox placed;
  // Far from the origin, VTK transforms in double; the box has a margin for the shader's floats.
  const bool far = this->Internal->Middle != glm::dvec3(0.);
  placed.Add(box, toWorld, 0., far ? 1e-14 : 1e-6);
  CopyBox(placed, this->Bounds);
  return this->Bounds;
}

//------------------------------------------------------------------------------
void vtkRelievoSkinnedActor::GetMovedBounds(double bounds[6])
{
  this->UpdatePose();
  CopyBox(this->Internal->Box, bounds);
}

//------------------------------------------------------------------------------
double vtkRelievoSkinnedActor::GetRoundedReach()
{
  this->UpdatePose();
  return this->Internal->Reach;
}

//------------------------------------------------------------------------------
int vtkRelievoSkinnedActor::GetNumberOfMovingReplacements() const
{
  return this->Internal->Shader.GetNumberOfReplacements();
}

//------------------------------------------------------------------------------
vtkMTimeType vtkRelievoSkinnedActor::GetRedrawMTime()
{
  this->UpdatePose();
  return std::max<vtkMTimeType>(
    this->Superclass::GetRedrawMTime(), this->Internal->PoseTime.GetMTime());
}

//------------------------------------------------------------------------------
void vtkRelievoSkinnedActor::Render(vtkRenderer* renderer, vtkMapper* mapper)
{
  this->UpdatePose();
  Internals& in = *this->Internal;
  if (in.MeshTime == 0)
  {
    return; // no mesh
  }
  if (in.Shader.Moves())
  {
    const std::string error =
      in.Bones.Upload(static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow()));
    if (error.empty())
    {
      in.Reported.Forget();
    }
    else
    {
      in.Unfit = in.Bones.GetNumberOfTexels();
      in.WhyUnfit = error;
      this->Refuse(error);
    }
  }
  if (in.Middle != glm::dvec3(0.))
  {
    const double middle[4] = { in.Middle.x, in.Middle.y, in.Middle.z, 1. };
    double place[4];
    in.Placed->DeepCopy(this->Superclass::GetMatrix());
    in.Placed->MultiplyPoint(middle, place);
    for (int i = 0; i < 4; ++i)
    {
      in.Placed->SetElement(i, 3, place[i]);
    }
    in.Draws = true;
  }
  if (in.Shader.Moves())
  {
    in.Bones.Activate();
  }
  this->Superclass::Render(renderer, mapper);
  in.Draws = false;
  if (in.Shader.Moves())
  {
    in.Bones.Deactivate();
  }
}

//------------------------------------------------------------------------------
vtkMatrix4x4* vtkRelievoSkinnedActor::GetMatrix()
{
  return this->Internal->Draws ? this->Internal->Placed : this->Superclass::GetMatrix();
}

//------------------------------------------------------------------------------
void vtkRelievoSkinnedActor::GetMatrix(vtkMatrix4x4* result)
{
  if (!result)
  {
    vtkErrorMacro("GetMatrix was given no matrix; give it a vtkMatrix4x4 to fill.");
    return;
  }
  result->DeepCopy(this->GetMatrix());
}

//------------------------------------------------------------------------------
int vtkRelievoSkinnedActor::GetIsIdentity()
{
  return this->Internal->Draws ? 0 : this->Superclass::GetIsIdentity();
}

//------------------------------------------------------------------------------
void vtkRelievoSkinnedActor::GetKeyMatrices(vtkMatrix4x4*& toWorld, vtkMatrix3x3*& normals)
{
  // VTK caches its result from GetMatrix.
  Internals& in = *this->Internal;
  const bool draws = std::exchange(in.Draws, false);
  this->Superclass::GetKeyMatrices(toWorld, normals);
  in.Draws = draws;
  if (!draws)
  {
    return;
  }
  // The matrix is transposed, as in OpenGL: the translation is the last row.
  in.PlacedTransposed->DeepCopy(toWorld);
  for (int i = 0; i < 4; ++i)
  {
    const double place = in.Middle.x * toWorld->GetElement(0, i) +
      in.Middle.y * toWorld->GetElement(1, i) + in.Middle.z * toWorld->GetElement(2, i) +
      toWorld->GetElement(3, i);
    in.PlacedTransposed->SetElement(3, i, place);
  }
  toWorld = in.PlacedTransposed;
}

//------------------------------------------------------------------------------
void vtkRelievoSkinnedActor::SetUniforms(vtkObject*, unsigned long, void* program)
{
  auto* shaders = static_cast<vtkShaderProgram*>(program);
  this->Internal->Bones.SetUniform(shaders);
  if (shaders->IsUniformUsed("relievoUnmovedBy"))
  {
    const glm::vec3 by(this->Internal->UnmovedBy);
    shaders->SetUniform3f("relievoUnmovedBy", &by.x);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoSkinnedActor::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internal->Bones.Release(window);
  this->Internal->Unfit = 0; // another window may support more
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkRelievoSkinnedActor::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->GetMethod() << "\n";
  os << indent << "BindPose: " << this->BindPose << "\n";
}

//------------------------------------------------------------------------------
// Reports an error once, until everything is valid again.
void vtkRelievoSkinnedActor::Complain(const std::string& error)
{
  if (this->Internal->Reported.IsChange(error))
  {
    vtkErrorMacro("" << error);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoSkinnedActor::Refuse(const std::string& error)
{
  Internals& in = *this->Internal;
  this->Complain(error + ". The mesh is drawn at rest.");
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
// Far from the origin, the shader's points and bones are relative to a middle, of the mesh and of
// the pose; VTK's matrices, in double, contain the remaining translation.
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
  this->Middle = relievo::GetFarOrigin(this->Box);
  if (this->Middle != glm::dvec3(0.))
  {
    // Computes the box again, relative to its middle, where rounding is small.
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
  // Floats would lose digits of such large movements.
  this->Skin->SetOutputPointsPrecision(this->Middle != glm::dvec3(0.)
      ? vtkAlgorithm::DOUBLE_PRECISION
      : vtkAlgorithm::DEFAULT_PRECISION);
  relievo::SkinBox box = relievo::GetBox(this->Rest->GetOutput());
  box.Move(-rest);
  // Accumulated rounding, here and in vtkRelievoSkin, which the shader is compared with.
  this->Reach = (dual ? 8. : 4.) * GetLargest(box, about);
}

//------------------------------------------------------------------------------
// VTK's mappers need a mesh: an empty one until the input is known.
void vtkRelievoSkinnedActor::Disconnect()
{
  Internals& in = *this->Internal;
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
  Internals& in = *this->Internal;
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
  Internals& in = *this->Internal;
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
  std::string error = in.Rest->GetError();
  if (error.empty() && !this->BindPose && mesh->GetNumberOfPoints() > 0)
  {
    const bool keys = in.Method == vtkRelievoSkin::KEY_MATRIX;
    error = skeleton ? relievo::GetBoneMatrices(mesh, skeleton, keys, matrices)
                     : "there is no skeleton: expected polydata with the point array pose";
  }
  const std::size_t texels = matrices.size() * (dual ? 5 : 3);
  if (in.Unfit > 0 && texels >= in.Unfit)
  {
    error = in.WhyUnfit;
  }
  if (newRest && in.Rest->GetNumberOfCut() > 0)
  {
    vtkWarningMacro(<< in.Rest->GetNumberOfCut() << " points have more than "
                    << vtkRelievoSkinRestPose::MostInfluences
                    << " bones; the weaker ones are left out. vtkRelievoSkin takes any number.");
  }
  if (!error.empty())
  {
    this->Refuse(error);
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
  // Invalidates cached drawings of this actor: shadow maps, cached frames.
  this->GetShaderProperty()->GetVertexCustomUniforms()->Modified();
}

//------------------------------------------------------------------------------
vtkPolyData* vtkRelievoSkinnedActor::GetMovedMesh()
{
  Internals& in = *this->Internal;
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
    // Only unmoved data have changed, such as colours.
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
      in.Moved->GetPointData()->RemoveArray(vtkRelievoSkinRestPose::GetJointsName(four));
      in.Moved->GetPointData()->RemoveArray(vtkRelievoSkinRestPose::GetWeightsName(four));
    }
  }
  in.MovedTime = in.PoseTime.GetMTime();
  in.MovedMesh = in.MeshTime;
  return in.Moved;
}
