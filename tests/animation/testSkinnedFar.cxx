// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Meshes with bones at georeferenced coordinates, where floats have steps of half a unit: there,
// vtkRelievoSkinnedActor draws the mesh that vtkRelievoSkin moves at the origin, as accurately as
// VTK draws still meshes there; also bounds, picking, clipping planes and shadows.
#include "Check.h"
#include "EmbreeScene.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Props.h"
#include "Session.h"
#include "ShadowErrors.h"
#include "ShadowScenes.h"
#include "SkinnedScenes.h"
#include "TestCase.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkDataObject.h>
#include <vtkHardwareSelector.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowStage.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

namespace testSkinnedFar
{
namespace
{
using namespace relievoTest;
const glm::dvec3 Far(5e5, 5e6, 0.);

// Which of the two is far away; the other is about the origin.
enum class Where
{
  Pose,
  Mesh,
  Both
};
const Where Places[] = { Where::Pose, Where::Mesh, Where::Both };

std::string ToString(Where where)
{
  return where == Where::Pose ? "a far pose" : where == Where::Mesh ? "a far mesh" : "both far";
}

vtkSmartPointer<vtkPolyData> MoveMesh(vtkPolyData* mesh, const glm::dvec3& by)
{
  auto moved = vtkSmartPointer<vtkPolyData>::New();
  moved->ShallowCopy(mesh);
  vtkNew<vtkPoints> points;
  points->SetDataType(VTK_DOUBLE);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const glm::dvec3 p = PointOf(mesh, i) + by;
    points->InsertNextPoint(p.x, p.y, p.z);
  }
  moved->SetPoints(points);
  return moved;
}

// The tube of MakeThreeBoneTube, a quarter as large, and its bones.
struct Rig
{
  explicit Rig(const glm::dvec3& at)
    : Mesh(MakeThreeBoneTube(41, 20))
  {
    const auto tube = MakeThreeBoneTube(41, 20);
    vtkNew<vtkPoints> points;
    points->SetDataType(VTK_DOUBLE);
    for (vtkIdType i = 0; i < tube->GetNumberOfPoints(); ++i)
    {
      // Points near the origin are rounded to floats, so that nothing but the place differs.
      const glm::dvec3 p = glm::dvec3(glm::vec3(0.25 * PointOf(tube, i))) + at;
      points->InsertNextPoint(p.x, p.y, p.z);
    }
    this->Mesh->SetPoints(points);
    std::vector<glm::dmat4> offsets;
    for (const double x : { 0., -0.325, -0.725 })
    {
      offsets.push_back(MoveBy({ x, 0., 0. }) * MoveBy(-at));
    }
    std::vector<int> joints;
    std::vector<float> weights;
    for (vtkIdType i = 0; i < tube->GetNumberOfPoints(); ++i)
    {
      const double x = PointOf(tube, i).x;
      const auto second = static_cast<float>(std::clamp(x - 0.8, 0., 1.));
      const auto third = static_cast<float>(std::clamp(x - 2.4, 0., 1.));
      joints.insert(joints.end(), { 2, 0, 1, -1 });
      weights.insert(
        weights.end(), { 3.f * third, 3.f * (1.f - second), 3.f * (second - third), 0.f });
    }
    SetBones(this->Mesh, offsets, 4, joints, weights);
  }

  vtkSmartPointer<vtkPolyData> Mesh;
};

vtkSmartPointer<vtkPolyData> MakePose(const glm::dvec3& at, double turn = 0.7)
{
  const glm::dmat4 place = MoveBy(at);
  const glm::dmat4 first = TurnAbout({ 0., 0., 1. }, 0.2 * turn);
  const glm::dmat4 second = first * MoveBy({ 0.325, 0., 0. }) * TurnAbout({ 0.3, 0.2, 1. }, turn);
  const glm::dmat4 third = second * MoveBy({ 0.4, 0., 0. }) * TurnAbout({ 1., 0., 0.4 }, turn);
  const glm::dmat4 other = TurnAbout({ 0., 1., 0. }, 0.1);
  return MakeSkeleton({ place * first, place * second, place * third },
    { place * other * first, place * second * other, place * third }, 0.4);
}

void Look(vtkRenderer* renderer, const glm::dvec3& at)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetFocalPoint(at.x + 0.45, at.y + 0.1, at.z);
  camera->SetPosition(at.x + 1.2, at.y - 1.8, at.z + 1.5);
  camera->SetViewUp(0., 0., 1.);
  camera->SetClippingRange(0.5, 8.);
}

struct Apart
{
  int Lost = 0; // other ids, away from edges
  double Places = 0.;
  double Normals = 0.;
  double Faces = 0.;
};

// The difference between `far`, drawn at its own position, and the drawing of pair.CPU.
Apart Compare(SkinnedPair& pair, vtkRenderer* far, const glm::dvec3& at, const std::string& what)
{
  const std::vector<std::string> names = { "position", "depth", "cell", "normal",
    "geometric_normal" };
  const Layers a(pair.CPU.Stage.Renderer, names);
  const Layers b(far, names);
  Apart apart;
  for (int y = 0; y < a.Height; ++y)
  {
    for (int x = 0; x < a.Width; ++x)
    {
      const int id = a.Id("cell", x, y);
      if (id != b.Id("cell", x, y))
      {
        apart.Lost += pair.IsNearEdge(x, y, 1. / 256.) ? 0 : 1;
      }
      else if (id >= 0)
      {
        const glm::dvec3 face = a.Vector("geometric_normal", x, y);
        const glm::dvec3 between = b.Vector("position", x, y) - at - a.Vector("position", x, y);
        apart.Places = Larger(apart.Places, std::abs(glm::dot(between, face)));
        apart.Normals =
          Larger(apart.Normals, glm::distance(a.Vector("normal", x, y), b.Vector("normal", x, y)));
        apart.Faces = Larger(apart.Faces, glm::distance(face, b.Vector("geometric_normal", x, y)));
      }
    }
  }
  std::cout << what << ": " << a.Covered() << " pixels, " << apart.Lost << " lost, places "
            << apart.Places << ", normals " << apart.Normals << ", faces " << apart.Faces << "\n";
  RELIEVO_CHECK_THAT(a.Covered() > 1000, what + ": nothing is seen");
  return apart;
}

void CheckApart(const Apart& apart, const std::string& what)
{
  RELIEVO_CHECK_AT_MOST(apart.Lost, 0, what + ": pixels with other ids away from edges");
  RELIEVO_CHECK_AT_MOST(apart.Places, 2e-6, what + ": surfaces apart");
  RELIEVO_CHECK_AT_MOST(apart.Normals, 1e-3, what + ": normals");
  RELIEVO_CHECK_AT_MOST(apart.Faces, 1e-2, what + ": normals of faces");
}

void TestLayers()
{
  const Rig near(glm::dvec3(0.));
  const Rig far(Far);
  SkinnedPair pair;
  for (const int method :
    { vtkRelievoSkin::LINEAR, vtkRelievoSkin::DUAL_QUATERNION, vtkRelievoSkin::KEY_MATRIX })
  {
    const auto pose = MakePose(glm::dvec3(0.));
    const auto farPose = MakePose(Far);
    pair.CPU.Set(near.Mesh, pose, method);
    Look(pair.CPU.Stage.Renderer, glm::dvec3(0.));
    for (const Where where : Places)
    {
      const glm::dvec3 at = where == Where::Mesh ? glm::dvec3(0.) : Far;
      pair.GPU.Set(
        where == Where::Pose ? near.Mesh : far.Mesh, where == Where::Mesh ? pose : farPose, method);
      Look(pair.GPU.Stage.Renderer, at);
      const std::string what = MethodName(method) + ", " + ToString(where);
      CheckApart(Compare(pair, pair.GPU.Stage.Renderer, at, what), what);
      // The mesh moved on the CPU and the bounds are there, too.
      vtkPolyData* moved = pair.GPU.Skinned->GetMovedMesh();
      vtkPolyData* truth = pair.CPU.Skin->GetOutput();
      double off = 0.;
      for (vtkIdType i = 0; i < truth->GetNumberOfPoints(); ++i)
      {
        off = Larger(off, glm::distance(PointOf(moved, i) - at, PointOf(truth, i)));
      }
      RELIEVO_CHECK_AT_MOST(off, 1e-6, what + ": the moved mesh");
      double tight[6];
      double loose[6];
      moved->GetBounds(tight);
      pair.GPU.Skinned->GetBounds(loose);
      for (int i = 0; i < 6; ++i)
      {
        const double room = (i % 2 ? 1. : -1.) * (loose[i] - tight[i]);
        RELIEVO_CHECK_AT_MOST(-room, 1e-6, what + ": sticks out of the bounds");
        RELIEVO_CHECK_AT_MOST(room, 0.5, what + ": bounds too large");
      }
    }
    // VTK's own way with the moved mesh as it stands there.
    Stage still(240, 180);
    AddActor(still.Renderer, MoveMesh(pair.CPU.Skin->GetOutput(), Far));
    Look(still.Renderer, Far);
    Compare(pair, still.Renderer, Far, MethodName(method) + ", a still mesh far away");
  }
}

// At rest, and without anything that moves it.
void TestRest()
{
  const Rig near(glm::dvec3(0.));
  const Rig far(Far);
  SkinnedPair pair;
  const auto rest =
    MakeSkeleton({ glm::dmat4(1.), MoveBy({ 0.325, 0., 0. }), MoveBy({ 0.725, 0., 0. }) });
  pair.CPU.Set(near.Mesh, rest, vtkRelievoSkin::LINEAR);
  pair.GPU.Set(far.Mesh, MakePose(glm::dvec3(0.)), vtkRelievoSkin::LINEAR);
  pair.GPU.Skinned->BindPoseOn();
  Look(pair.CPU.Stage.Renderer, glm::dvec3(0.));
  Look(pair.GPU.Stage.Renderer, Far);
  CheckApart(Compare(pair, pair.GPU.Stage.Renderer, Far, "the bind pose"), "the bind pose");
}

// Points without a bone stay; the actor has a matrix; planes clip the moved mesh.
void TestUse()
{
  const Rig near(glm::dvec3(0.));
  const Rig far(Far);
  for (const vtkSmartPointer<vtkPolyData>& mesh : { near.Mesh, far.Mesh })
  {
    vtkDataArray* weights = mesh->GetPointData()->GetArray("weights");
    for (vtkIdType i = 0; i < 60; ++i)
    {
      weights->SetTuple4(i, 0., 0., 0., 0.);
    }
  }
  SkinnedPair pair;
  pair.CPU.Set(near.Mesh, MakePose(glm::dvec3(0.)), vtkRelievoSkin::LINEAR);
  pair.GPU.Set(far.Mesh, MakePose(Far), vtkRelievoSkin::LINEAR);
  Look(pair.CPU.Stage.Renderer, glm::dvec3(0.));
  Look(pair.GPU.Stage.Renderer, Far);
  CheckApart(Compare(pair, pair.GPU.Stage.Renderer, Far, "points of no bone"), "points of no bone");

  const auto clip = [](SkinnedSide& side, const glm::dvec3& at) {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(at.x + 0.5, at.y, at.z);
    plane->SetNormal(-1., 0.1, 0.);
    side.GetMapper()->AddClippingPlane(plane);
  };
  const long long whole = Layers(pair.GPU.Stage.Renderer, { "depth" }).Covered();
  clip(pair.CPU, glm::dvec3(0.));
  clip(pair.GPU, Far);
  const Layers a(pair.CPU.Stage.Renderer, { "depth" });
  const Layers b(pair.GPU.Stage.Renderer, { "depth" });
  std::cout << "clipped: " << a.Covered() << " and " << b.Covered() << " of " << whole << "\n";
  RELIEVO_CHECK(a.Covered() < 0.9 * whole && a.Covered() > 500);
  RELIEVO_CHECK_AT_MOST(std::abs(a.Covered() - b.Covered()), 2, "pixels behind a clipping plane");
  pair.CPU.GetMapper()->RemoveAllClippingPlanes();
  pair.GPU.GetMapper()->RemoveAllClippingPlanes();

  // Turned about the place where it is.
  const glm::dmat4 turn = TurnAbout({ 0.2, 1., 0.3 }, 0.6);
  const auto place = [&turn](SkinnedSide& side, const glm::dvec3& at) {
    const glm::dmat4 about = MoveBy(at) * turn * MoveBy(-at);
    vtkNew<vtkMatrix4x4> matrix;
    for (int i = 0; i < 16; ++i)
    {
      matrix->SetElement(i / 4, i % 4, about[i % 4][i / 4]);
    }
    side.Actor->SetUserMatrix(matrix);
  };
  place(pair.CPU, glm::dvec3(0.));
  place(pair.GPU, Far);
  // Edges are looked for in the mesh, which has no matrix.
  const Layers turned(pair.CPU.Stage.Renderer, { "cell", "depth" });
  const Layers farTurned(pair.GPU.Stage.Renderer, { "cell", "depth" });
  RELIEVO_CHECK(turned.Covered() > 1000);
  RELIEVO_CHECK_AT_MOST(CountDifferent(turned, farTurned, "cell"), 3, "ids of a turned actor");

  vtkRenderWindow* window = pair.GPU.Stage.Window;
  window->Render();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(pair.GPU.Stage.Renderer);
  selector->SetArea(0, 0, 239, 179);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  RELIEVO_CHECK(selector->CaptureBuffers());
  int mismatches = 0;
  for (unsigned int y = 0; y < 180; ++y)
  {
    for (unsigned int x = 0; x < 240; ++x)
    {
      const unsigned int pixel[2] = { x, y };
      const auto found = selector->GetPixelInformation(pixel);
      const vtkIdType id = found.Valid ? found.AttributeID : -1;
      mismatches += id == turned.Id("cell", static_cast<int>(x), static_cast<int>(y)) ? 0 : 1;
    }
  }
  RELIEVO_CHECK_AT_MOST(mismatches, 3, "cells that the selector picks");
}

void TestShadows()
{
  const Rig near(glm::dvec3(0.));
  for (const int skin : { vtkRelievoSkin::LINEAR, vtkRelievoSkin::DUAL_QUATERNION })
  {
    const glm::dvec3 above(-0.4, 0.7, 0.2);
    const auto moved = Skin(near.Mesh, MakePose(above), skin);
    for (const ShadowMethod& method : ShadowMethods)
    {
      if (skin != vtkRelievoSkin::LINEAR && method.Value != vtkRelievoShadowStage::METHOD_EXACT)
      {
        continue;
      }
      // By the graphics card about the origin; still far away; both.
      double error[3];
      for (int i = 0; i < 3; ++i)
      {
        const bool gpu = i != 1;
        const glm::dvec3 at = i == 0 ? glm::dvec3(0.) : Far;
        const auto placed = MoveMesh(moved, at);
        ShadowStage stage(240, 180, 1., at);
        const GLCheck gl(stage.Window);
        stage.AddGround();
        stage.AddSun(-3., 4., -2.);
        EmbreeScene truth;
        truth.AddActors(stage.Renderer);
        truth.AddActor(placed);
        vtkNew<vtkRelievoSkinnedActor> actor;
        if (gpu)
        {
          actor->SetInputData(near.Mesh);
          actor->SetSkeletonData(MakePose(at + above));
          actor->SetMethod(skin);
          stage.Renderer->AddActor(actor);
        }
        else
        {
          AddActor(stage.Renderer, placed);
        }
        stage.GetShadows()->SetMethod(method.Value);
        const ShadowErrors errors = JudgeShadow(stage, 0, &truth);
        error[i] = errors.Wrong();
        std::cout << MethodName(skin) << ", " << method.Name << (gpu ? ", GPU" : ", still")
                  << (i == 0 ? " about the origin: " : " far away: ") << errors.ToString() << "\n";
        RELIEVO_CHECK(errors.Dark > 200);
      }
      // Its bones are uploaded in the midst of the frame.
      RELIEVO_CHECK_AT_MOST(error[0], error[1] + 1e-4,
        MethodName(skin) + ", " + method.Name + ": wrong in the actor's first frame");
      RELIEVO_CHECK_AT_MOST(error[2], std::max(error[0], error[1]) + 5e-5,
        MethodName(skin) + ", " + method.Name + ": wrong beside the same elsewhere");
    }
  }
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testSkinnedFar)
{
  relievoTest::Session session;
  TestLayers();
  TestRest();
  TestUse();
  TestShadows();
  return session.Result();
}
}
