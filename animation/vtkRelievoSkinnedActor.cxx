// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSkinnedActor.h"

#include "vtkRelievoSkinnedActorInternals.h"

#include "vtkAlgorithmOutput.h"
#include "vtkCommand.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <utility>

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
}

//------------------------------------------------------------------------------
vtkRelievoSkinnedActor::vtkRelievoSkinnedActor()
  : Inside(new Internals)
{
  this->Disconnect();
  // Of as many bones as the shader takes.
  this->Inside->Skin->SetInputConnection(0, this->Inside->Rest->GetOutputPort());
  // Bones move points as they are, not shifted and scaled ones.
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
  this->Inside->Rest->SetInputConnection(port);
}

//------------------------------------------------------------------------------
void vtkRelievoSkinnedActor::SetInputData(vtkPolyData* mesh)
{
  this->Disconnect();
  this->Inside->Rest->SetInputData(mesh);
}

//------------------------------------------------------------------------------
void vtkRelievoSkinnedActor::SetSkeletonConnection(vtkAlgorithmOutput* port)
{
  this->Inside->Skin->SetInputConnection(1, port);
}

//------------------------------------------------------------------------------
void vtkRelievoSkinnedActor::SetSkeletonData(vtkPolyData* skeleton)
{
  this->Inside->Skin->SetInputData(1, skeleton);
}

//------------------------------------------------------------------------------
void vtkRelievoSkinnedActor::SetMethod(int method)
{
  this->Inside->Skin->SetMethod(method);
}

//------------------------------------------------------------------------------
int vtkRelievoSkinnedActor::GetMethod()
{
  return this->Inside->Skin->GetMethod();
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
  const relievo::SkinBox& box = this->Inside->Box;
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
  // Far from the origin VTK places it in double; the box has room for the shader's floats.
  const bool far = this->Inside->Middle != glm::dvec3(0.);
  placed.Add(box, toWorld, 0., far ? 1e-14 : 1e-6);
  CopyBox(placed, this->Bounds);
  return this->Bounds;
}

//------------------------------------------------------------------------------
void vtkRelievoSkinnedActor::GetMovedBounds(double bounds[6])
{
  this->UpdatePose();
  CopyBox(this->Inside->Box, bounds);
}

//------------------------------------------------------------------------------
double vtkRelievoSkinnedActor::GetRoundedReach()
{
  this->UpdatePose();
  return this->Inside->Reach;
}

//------------------------------------------------------------------------------
int vtkRelievoSkinnedActor::GetNumberOfMovingReplacements() const
{
  return this->Inside->Shader.GetNumberOfReplacements();
}

//------------------------------------------------------------------------------
vtkMTimeType vtkRelievoSkinnedActor::GetRedrawMTime()
{
  this->UpdatePose();
  return std::max<vtkMTimeType>(
    this->Superclass::GetRedrawMTime(), this->Inside->PoseTime.GetMTime());
}

//------------------------------------------------------------------------------
void vtkRelievoSkinnedActor::Render(vtkRenderer* renderer, vtkMapper* mapper)
{
  this->UpdatePose();
  Internals& in = *this->Inside;
  if (in.MeshTime == 0)
  {
    return; // no mesh
  }
  if (in.Shader.Moves())
  {
    const std::string wrong =
      in.Bones.Upload(static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow()));
    if (wrong.empty())
    {
      in.Said.clear();
    }
    else
    {
      in.Unfit = in.Bones.GetNumberOfTexels();
      in.WhyUnfit = wrong;
      this->Refuse(wrong);
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
  return this->Inside->Draws ? this->Inside->Placed : this->Superclass::GetMatrix();
}

//------------------------------------------------------------------------------
void vtkRelievoSkinnedActor::GetMatrix(vtkMatrix4x4* result)
{
  result->DeepCopy(this->GetMatrix());
}

//------------------------------------------------------------------------------
int vtkRelievoSkinnedActor::GetIsIdentity()
{
  return this->Inside->Draws ? 0 : this->Superclass::GetIsIdentity();
}

//------------------------------------------------------------------------------
void vtkRelievoSkinnedActor::GetKeyMatrices(vtkMatrix4x4*& toWorld, vtkMatrix3x3*& normals)
{
  // VTK keeps what it computes, from GetMatrix.
  Internals& in = *this->Inside;
  const bool draws = std::exchange(in.Draws, false);
  this->Superclass::GetKeyMatrices(toWorld, normals);
  in.Draws = draws;
  if (!draws)
  {
    return;
  }
  // As OpenGL has matrices: the move is the last row.
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
  this->Inside->Bones.SetUniform(shaders);
  if (shaders->IsUniformUsed("relievoUnmovedBy"))
  {
    const glm::vec3 by(this->Inside->UnmovedBy);
    shaders->SetUniform3f("relievoUnmovedBy", &by.x);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoSkinnedActor::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Inside->Bones.Release(window);
  this->Inside->Unfit = 0; // another window may take more
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkRelievoSkinnedActor::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->GetMethod() << "\n";
  os << indent << "BindPose: " << this->BindPose << "\n";
}
