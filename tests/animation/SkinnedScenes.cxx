// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SkinnedScenes.h"

#include "Check.h"
#include "Layers.h"
#include "ShadowPictures.h"
#include "Window.h"

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkRenderer.h>
#include <vtkShaderProperty.h>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace relievoTest
{
//------------------------------------------------------------------------------
std::string MethodName(int method)
{
  return method == vtkRelievoSkin::LINEAR  ? "linear"
    : method == vtkRelievoSkin::KEY_MATRIX ? "key-matrix"
                                           : "dual-quaternion";
}

//------------------------------------------------------------------------------
SkinnedSide::SkinnedSide(bool gpu, int width, int height)
  : Stage(width, height)
  , Watch(this->Stage.Window)
{
  if (gpu)
  {
    this->Skinned = vtkSmartPointer<vtkRelievoSkinnedActor>::New();
    this->Actor = this->Skinned;
  }
  else
  {
    this->Mapper->SetInputConnection(this->Skin->GetOutputPort());
    this->Actor = vtkSmartPointer<vtkActor>::New();
    this->Actor->SetMapper(this->Mapper);
    // Read like the other one, by an array interpolated on the GPU.
    this->Actor->GetShaderProperty()->AddVertexShaderReplacement(
      "//VTK::CustomBegin::Impl", true, "//VTK::CustomBegin::Impl\n", false);
  }
  this->Stage.Renderer->AddActor(this->Actor);
}

//------------------------------------------------------------------------------
void SkinnedSide::Set(vtkPolyData* mesh, vtkPolyData* skeleton, int method)
{
  const auto set = [&](auto* to) { to->SetMethod(method); };
  if (this->Skinned)
  {
    this->Skinned->SetInputData(mesh);
    this->Skinned->SetSkeletonData(skeleton);
    set(this->Skinned.Get());
  }
  else
  {
    this->Skin->SetInputData(0, mesh);
    this->Skin->SetInputData(1, skeleton);
    set(this->Skin.Get());
  }
}

//------------------------------------------------------------------------------
vtkPolyDataMapper* SkinnedSide::GetMapper()
{
  return this->Skinned ? this->Skinned->GetPolyDataMapper() : this->Mapper.Get();
}

//------------------------------------------------------------------------------
SkinnedPair::SkinnedPair(int width, int height)
  : CPU(false, width, height)
  , GPU(true, width, height)
{
}

//------------------------------------------------------------------------------
void SkinnedPair::Set(vtkPolyData* mesh, vtkPolyData* skeleton, int method)
{
  this->CPU.Set(mesh, skeleton, method);
  this->GPU.Set(mesh, skeleton, method);
  vtkCamera* camera = this->CPU.Stage.Renderer->GetActiveCamera();
  camera->SetFocalPoint(0., 0., 0.);
  camera->SetPosition(1., -2., 1.5);
  camera->SetViewUp(0., 0., 1.);
  this->CPU.Stage.Renderer->ResetCamera();
  this->GPU.Stage.Renderer->GetActiveCamera()->DeepCopy(camera);
}

//------------------------------------------------------------------------------
bool SkinnedPair::IsNearEdge(int x, int y, double distance)
{
  vtkRenderer* renderer = this->CPU.Stage.Renderer;
  const int* size = renderer->GetSize();
  vtkMatrix4x4* m = renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(
    static_cast<double>(size[0]) / size[1], -1., 1.);
  vtkPolyData* mesh = this->CPU.Skin->GetOutput();
  const auto project = [&](vtkIdType i) {
    const glm::dvec3 p = PointOf(mesh, i);
    double at[4] = { p.x, p.y, p.z, 1. };
    m->MultiplyPoint(at, at);
    return glm::dvec2((at[0] / at[3] + 1.) * size[0] / 2., (at[1] / at[3] + 1.) * size[1] / 2.);
  };
  const glm::dvec2 pixel(x + 0.5, y + 0.5);
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetPolys()->GetNumberOfCells(); ++cell)
  {
    mesh->GetPolys()->GetCellAtId(cell, ids);
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      const glm::dvec2 a = project(ids->GetId(i));
      const glm::dvec2 b = project(ids->GetId((i + 1) % ids->GetNumberOfIds()));
      const glm::dvec2 along = b - a;
      const double square = std::max(glm::dot(along, along), 1e-30);
      const double t = std::clamp(glm::dot(pixel - a, along) / square, 0., 1.);
      if (glm::length(pixel - a - along * t) <= distance)
      {
        return true;
      }
    }
  }
  return false;
}

//------------------------------------------------------------------------------
void SkinnedPair::CompareLayers(const std::string& what)
{
  const std::vector<std::string> names = { "position", "depth", "cell", "normal",
    "geometric_normal" };
  const Layers a(this->CPU.Stage.Renderer, names);
  const Layers b(this->GPU.Stage.Renderer, names);
  double box[6];
  this->CPU.Skin->GetOutput()->GetBounds(box);
  const double scale = std::hypot(box[1] - box[0], box[3] - box[2], box[5] - box[4]);
  vtkCamera* camera = this->CPU.Stage.Renderer->GetActiveCamera();
  const glm::dvec3 eye = glm::make_vec3(camera->GetPosition());
  const glm::dvec3 ahead = glm::make_vec3(camera->GetDirectionOfProjection());
  RELIEVO_CHECK(!camera->GetParallelProjection());
  int flipped = 0;
  int lost = 0;
  double deeper = 0.;
  double apart = 0.;
  double turned = 0.;
  for (int y = 0; y < a.Height; ++y)
  {
    for (int x = 0; x < a.Width; ++x)
    {
      if (a.Id("cell", x, y) != b.Id("cell", x, y))
      {
        ++flipped;
        lost += this->IsNearEdge(x, y, 1. / 256.) ? 0 : 1;
        continue;
      }
      if (a.Id("cell", x, y) >= 0)
      {
        // Across the surface: along one that slants, a pixel's place goes far with little.
        const glm::dvec3 between = a.Vector("position", x, y) - b.Vector("position", x, y);
        const glm::dvec3 normal = a.Vector("geometric_normal", x, y);
        const double across = std::abs(glm::dot(between, normal));
        const glm::dvec3 ray = a.Vector("position", x, y) - eye;
        const double depth = std::abs(a.Value("depth", x, y) - b.Value("depth", x, y));
        deeper =
          Larger(deeper, depth * std::abs(glm::dot(normal, ray)) / glm::dot(ahead, ray) / scale);
        apart = Larger(apart, across / scale);
        turned = Larger(turned, glm::distance(a.Vector("normal", x, y), b.Vector("normal", x, y)));
      }
    }
  }
  std::cout << what << ": " << a.Covered() << " pixels, " << flipped << " flipped, " << apart
            << " of the size apart, normals " << turned << "\n";
  RELIEVO_CHECK_THAT(a.Covered() > 1000, what + ": nothing is seen");
  RELIEVO_CHECK_AT_MOST(lost, 0, what + ": pixels with other ids away from edges");
  RELIEVO_CHECK_AT_MOST(apart, 2e-6, what + ": share of the size that surfaces are apart");
  RELIEVO_CHECK_AT_MOST(deeper, 2e-6, what + ": the same by depth");
  RELIEVO_CHECK_AT_MOST(turned, 1e-3, what + ": normals");
}

//------------------------------------------------------------------------------
void SkinnedPair::ComparePictures(const std::string& what, double share, int slack)
{
  const auto a = Picture(this->CPU.Stage.Window);
  const auto b = Picture(this->GPU.Stage.Window);
  const double unlike = static_cast<double>(CountUnlike(a, b, slack));
  RELIEVO_CHECK_AT_MOST(unlike / static_cast<double>(a->GetNumberOfPoints()), share,
    what + ": share of pixels that differ");
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeThreeBoneTube(int rings, int sides)
{
  const vtkSmartPointer<vtkPolyData> mesh = MakeTube(rings, sides, false);
  std::vector<int> joints;
  std::vector<float> weights;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const double x = PointOf(mesh, i).x;
    const auto second = static_cast<float>(std::clamp(x - 0.8, 0., 1.));
    const auto third = static_cast<float>(std::clamp(x - 2.4, 0., 1.));
    // Not of sum 1, and not in order.
    joints.insert(joints.end(), { 2, 0, 1, -1 });
    weights.insert(
      weights.end(), { 3.f * third, 3.f * (1.f - second), 3.f * (second - third), 0.f });
  }
  SetBones(mesh, { glm::dmat4(1.), MoveBy({ -1.3, 0., 0. }), MoveBy({ -2.9, 0., 0. }) }, 4, joints,
    weights);
  return mesh;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeBentPose(double turn, double stretch, double mirror)
{
  const glm::dmat4 first = TurnAbout({ 0., 0., 1. }, 0.2 * turn);
  glm::dmat4 size(1.);
  size[1][1] = stretch;
  size[2][2] = mirror;
  const glm::dmat4 second =
    first * MoveBy({ 1.3, 0., 0. }) * TurnAbout({ 0.3, 0.2, 1. }, turn) * size;
  const glm::dmat4 third = second * MoveBy({ 1.6, 0., 0. }) * TurnAbout({ 1., 0., 0.4 }, turn);
  return MakeSkeleton({ first, second, third },
    { MoveBy({ 0., 0., 0.2 }) * first, second * TurnAbout({ 0., 0., 1. }, 0.3), third }, 0.4);
}

//------------------------------------------------------------------------------
Chain MakeChain(int bones, int rings, int sides, int influences)
{
  Chain chain;
  chain.Mesh = MakeTube(rings, sides, false);
  std::vector<glm::dmat4> offsets;
  std::vector<glm::dmat4> pose;
  const double step = 4. / (bones - 1);
  for (int i = 0; i < bones; ++i)
  {
    const glm::dmat4 turn = TurnAbout({ 0.2, 0.5, 1. }, 2.5 / bones);
    offsets.push_back(MoveBy({ -step * i, 0., 0. }));
    pose.push_back(i == 0 ? turn : pose.back() * MoveBy({ step, 0., 0. }) * turn);
  }
  std::vector<int> joints;
  std::vector<float> weights;
  for (vtkIdType i = 0; i < chain.Mesh->GetNumberOfPoints(); ++i)
  {
    const int bone = static_cast<int>(PointOf(chain.Mesh, i).x / step);
    for (int k = 0; k < influences; ++k)
    {
      joints.push_back(std::min(bone + k, bones - 1));
      weights.push_back(1.f / static_cast<float>(1 + k));
    }
  }
  SetBones(chain.Mesh, offsets, influences, joints, weights);
  chain.Skeleton = MakeSkeleton(pose);
  return chain;
}
}
