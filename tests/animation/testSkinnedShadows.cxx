// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Shadows of meshes moved by the vertex shader, by every method, compared with rays at the
// triangles moved by vtkRelievoSkin. Maps are redrawn only when the pose changes, and traced meshes
// equal drawn ones.
#include "Check.h"
#include "EmbreeScene.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Props.h"
#include "Session.h"
#include "ShadowPictures.h"
#include "SkinnedScenes.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkProperty.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowStage.h>
#include <vtkRenderer.h>
#include <vtkShaderProperty.h>
#include <vtkSphereSource.h>
#include <vtkUniforms.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

namespace testSkinnedShadows
{
namespace
{
using namespace relievoTest;

// The pose of the mesh over the ground of a ShadowStage.
vtkSmartPointer<vtkPolyData> MakePose(double turn)
{
  glm::dmat4 place = MoveBy({ -0.8, 0.9, 0.2 }) * TurnAbout({ 0., 1., 0. }, 0.5);
  place = place * glm::dmat4(0.5, 0., 0., 0., 0., 0.5, 0., 0., 0., 0., 0.5, 0., 0., 0., 0., 1.);
  const glm::dmat4 second = place * MoveBy({ 1.3, 0., 0. }) * TurnAbout({ 0., 0.3, 1. }, turn);
  const glm::dmat4 third = second * MoveBy({ 1.6, 0., 0. }) * TurnAbout({ 1., 0.5, 0.4 }, turn);
  return MakeSkeleton({ place, second, third });
}

void TestAgainstRays()
{
  const auto tube = MakeThreeBoneTube(121, 90);
  for (const int skin : { vtkRelievoSkin::LINEAR, vtkRelievoSkin::DUAL_QUATERNION })
  {
    const auto pose = MakePose(0.7);
    for (const ShadowMethod& method : ShadowMethods)
    {
      // Maps of all kinds draw with any of the mapper's shaders.
      if (skin == vtkRelievoSkin::LINEAR && method.Value != vtkRelievoShadowStage::METHOD_EXACT)
      {
        continue;
      }
      double error[2];
      for (const bool gpu : { false, true })
      {
        ShadowStage stage;
        const GLCheck gl(stage.Window);
        stage.AddGround();
        stage.AddSun(-3., 4., -2.);
        EmbreeScene truth;
        truth.AddActors(stage.Renderer);
        const auto moved = Skin(tube, pose, skin);
        truth.AddActor(moved);
        vtkNew<vtkRelievoSkinnedActor> actor;
        if (gpu)
        {
          actor->SetInputData(tube);
          actor->SetSkeletonData(pose);
          actor->SetMethod(skin);
          stage.Renderer->AddActor(actor);
        }
        else
        {
          AddActor(stage.Renderer, moved);
        }
        stage.GetShadows()->SetMethod(method.Value);
        const ShadowErrors errors = JudgeShadow(stage, 0, &truth);
        error[gpu] = errors.Wrong();
        std::cout << MethodName(skin) << ", " << method.Name << (gpu ? ", GPU: " : ", CPU: ")
                  << errors.ToString() << "\n";
        RELIEVO_CHECK(errors.Dark > 300);
      }
      // Shadows are as right as those of a still mesh, but for pixels at edges.
      RELIEVO_CHECK_AT_MOST(error[1], error[0] + 5e-5,
        MethodName(skin) + ", " + method.Name + ": wrong beside a still mesh");
    }
  }
}

// A ball that a bone turns and moves far away, of points about the origin: its sides that face the
// light are lit, though the shader's floats have few digits there.
void TestFarAway()
{
  vtkNew<vtkSphereSource> source;
  source->SetThetaResolution(64);
  source->SetPhiResolution(64);
  source->Update();
  vtkPolyData* ball = source->GetOutput();
  const auto points = static_cast<std::size_t>(ball->GetNumberOfPoints());
  SetBones(
    ball, { glm::dmat4(1.) }, 1, std::vector<int>(points, 0), std::vector<float>(points, 1.f));
  for (const int skin : { vtkRelievoSkin::LINEAR, vtkRelievoSkin::DUAL_QUATERNION })
  {
    for (const double away : { 1e3, 1e4 })
    {
      const glm::dvec3 center = away * glm::dvec3(1., 0.37, 0.11);
      const auto pose = MakeSkeleton({ MoveBy(center) * TurnAbout({ 1., 2., 0.5 }, 0.7) });
      ShadowStage stage;
      vtkNew<vtkRelievoSkinnedActor> actor;
      actor->SetInputData(ball);
      actor->SetSkeletonData(pose);
      actor->SetMethod(skin);
      stage.Renderer->AddActor(actor);
      vtkCamera* camera = stage.Renderer->GetActiveCamera();
      camera->SetFocalPoint(center.x, center.y, center.z);
      camera->SetPosition(center.x + 0.4, center.y + 0.6, center.z + 2.);
      camera->SetClippingRange(0.5, 10.);
      const auto light = stage.AddSun(0., 0., 0.);
      light->SetFocalPoint(0., 0., 0.);
      light->SetPosition(3., 5., 2.);
      stage.GetShadows()->SetMethodToExact();
      const Layers layers(stage.Renderer, { "shadow_0", "normal", "cell" });
      vtkDataArray* shadow = layers.Image->GetPointData()->GetArray("shadow_0");
      const glm::dvec3 toLight = glm::normalize(glm::dvec3(3., 5., 2.));
      long long lit = 0;
      long long dark = 0;
      for (int y = 0; y < layers.Height; ++y)
      {
        for (int x = 0; x < layers.Width; ++x)
        {
          if (layers.Id("cell", x, y) >= 0 &&
            glm::dot(layers.Vector("normal", x, y), toLight) > 0.3)
          {
            ++lit;
            dark += shadow->GetComponent(y * layers.Width + x, 0) < 1. ? 1 : 0;
          }
        }
      }
      const std::string what = MethodName(skin) + ", " + std::to_string(away) + " away";
      RELIEVO_CHECK_THAT(lit > 2000, what + ": pixels that face the light");
      RELIEVO_CHECK_AT_MOST(dark, 0, what + ": of these, dark");
    }
  }
}

// An actor without a known moved mesh casts by maps.
class Unknown : public vtkRelievoSkinnedActor
{
public:
  static Unknown* New();
  vtkTypeMacro(Unknown, vtkRelievoSkinnedActor);
  vtkPolyData* GetMovedMesh() override { return nullptr; }
};
vtkStandardNewMacro(Unknown);

void TestUnknown()
{
  const auto tube = MakeThreeBoneTube(41, 20);
  const auto pose = MakePose(0.4);
  ShadowStage stage;
  const GLCheck gl(stage.Window);
  stage.AddGround();
  stage.AddSun(-3., 4., -2.);
  EmbreeScene truth;
  truth.AddActors(stage.Renderer);
  const auto moved = Skin(tube, pose, vtkRelievoSkin::LINEAR);
  truth.AddActor(moved);
  vtkNew<Unknown> actor;
  actor->SetInputData(tube);
  actor->SetSkeletonData(pose);
  stage.Renderer->AddActor(actor);
  stage.GetShadows()->SetMethodToExact();
  const ShadowErrors errors = JudgeShadow(stage, 0, &truth);
  RELIEVO_CHECK(errors.Dark > 300);
  RELIEVO_CHECK_AT_MOST(errors.Wrong(), 0.01, "an actor that does not know its mesh: wrong");
}

// More bones a point than the shader takes: the same are traced as are drawn.
void TestManyBones()
{
  const Chain chain = MakeChain(20, 41, 20, 10);
  vtkNew<vtkRelievoSkinnedActor> actor;
  ExpectMessage expect("more than 8 bones");
  actor->SetInputData(chain.Mesh);
  actor->SetSkeletonData(chain.Skeleton);
  vtkPolyData* moved = actor->GetMovedMesh();
  // By hand: each point has the weights 1, 1/2 ... 1/10 of its bones, of which the last two go.
  double off = 0.;
  vtkDataArray* joints = chain.Mesh->GetPointData()->GetArray("joints");
  std::vector<glm::dmat4> matrices;
  for (vtkIdType b = 0; b < 20; ++b)
  {
    const double* m = chain.Skeleton->GetPointData()->GetArray("pose")->GetTuple(b);
    glm::dmat4 pose;
    for (int i = 0; i < 16; ++i)
    {
      pose[i % 4][i / 4] = m[i];
    }
    matrices.push_back(pose * MoveBy({ -4. / 19. * static_cast<double>(b), 0., 0. }));
  }
  for (vtkIdType i = 0; i < chain.Mesh->GetNumberOfPoints(); ++i)
  {
    glm::dvec4 sum(0.);
    double whole = 0.;
    for (int k = 0; k < 8; ++k)
    {
      const auto bone = static_cast<std::size_t>(joints->GetComponent(i, k));
      sum += matrices[bone] * glm::dvec4(PointOf(chain.Mesh, i), 1.) / (1. + k);
      whole += 1. / (1. + k);
    }
    off = Larger(off, glm::distance(glm::dvec3(sum) / whole, PointOf(moved, i)));
  }
  RELIEVO_CHECK_AT_MOST(off, 1e-5, "points of ten bones beside those of eight");
}

// Setting an equal pose moves nothing on the CPU, and cached traces stay.
void TestKept()
{
  const auto tube = MakeThreeBoneTube(41, 20);
  const auto skeleton = MakePose(0.4);
  vtkNew<vtkRelievoSkinnedActor> actor;
  actor->SetInputData(tube);
  actor->SetSkeletonData(skeleton);
  const vtkMTimeType first = actor->GetMovedMesh()->GetPoints()->GetMTime();
  skeleton->Modified();
  RELIEVO_CHECK(actor->GetMovedMesh()->GetPoints()->GetMTime() == first);
  skeleton->ShallowCopy(MakePose(0.4));
  RELIEVO_CHECK(actor->GetMovedMesh()->GetPoints()->GetMTime() == first);
  // Colours that a simulation changes are no pose.
  const vtkMTimeType posed = actor->GetShaderProperty()->GetVertexCustomUniforms()->GetMTime();
  for (int step = 1; step < 3; ++step)
  {
    vtkNew<vtkFloatArray> heat;
    heat->SetName("heat");
    heat->SetNumberOfTuples(tube->GetNumberOfPoints());
    heat->Fill(step);
    tube->GetPointData()->SetScalars(heat);
    tube->Modified();
    vtkPolyData* moved = actor->GetMovedMesh();
    RELIEVO_CHECK(moved->GetPoints()->GetMTime() == first);
    vtkDataArray* shown = moved->GetPointData()->GetArray("heat");
    RELIEVO_CHECK(shown && shown->GetComponent(0, 0) == step);
    const auto alone = Skin(tube, skeleton, vtkRelievoSkin::LINEAR);
    RELIEVO_CHECK(
      moved->GetPointData()->GetNumberOfArrays() == alone->GetPointData()->GetNumberOfArrays() &&
      moved->GetFieldData()->GetNumberOfArrays() == alone->GetFieldData()->GetNumberOfArrays());
    RELIEVO_CHECK(PointOf(moved, 7) == PointOf(alone, 7));
  }
  RELIEVO_CHECK(actor->GetShaderProperty()->GetVertexCustomUniforms()->GetMTime() == posed);
  skeleton->ShallowCopy(MakePose(0.5));
  RELIEVO_CHECK(actor->GetMovedMesh()->GetPoints()->GetMTime() != first);
  const vtkMTimeType second = actor->GetMovedMesh()->GetPoints()->GetMTime();
  tube->GetPoints()->Modified();
  tube->Modified();
  RELIEVO_CHECK(actor->GetMovedMesh()->GetPoints()->GetMTime() != second);
}

// How many maps a frame takes after each change.
void TestRedraws()
{
  const auto tube = MakeThreeBoneTube(41, 20);
  ShadowStage stage;
  const GLCheck gl(stage.Window);
  stage.AddGround();
  stage.AddSun(-3., 4., -2.);
  vtkNew<vtkRelievoSkinnedActor> actor;
  const auto skeleton = MakePose(0.4);
  actor->SetInputData(tube);
  actor->SetSkeletonData(skeleton);
  stage.Renderer->AddActor(actor);
  stage.GetFrame()->ShadowsOn();
  const auto draws = [&stage]() {
    const auto picture = Picture(stage.Window);
    return stage.GetShadows()->GetNumberOfMapsDrawn();
  };
  const auto check = [&](int expected, const std::string& what) {
    const int drawn = draws();
    RELIEVO_CHECK_THAT(drawn == expected,
      what + ": " + std::to_string(drawn) + " maps are drawn, expected " +
        std::to_string(expected));
    RELIEVO_CHECK_THAT(draws() == 0, what + ": another is drawn in a still frame");
  };
  draws();
  RELIEVO_CHECK(draws() == 0);
  skeleton->Modified();
  check(0, "the same pose again");
  skeleton->ShallowCopy(MakePose(0.4));
  check(0, "a new skeleton of the same pose");
  actor->GetProperty()->SetColor(0.9, 0.3, 0.2);
  check(0, "a color");
  const auto before = Picture(stage.Window);
  skeleton->ShallowCopy(MakePose(0.6));
  check(1, "another pose");
  RELIEVO_CHECK(CountUnlike(before, Picture(stage.Window), 20) > 100);
  actor->SetMethod(vtkRelievoSkin::DUAL_QUATERNION);
  check(1, "another method");
  actor->BindPoseOn();
  check(1, "the bind pose");
  skeleton->ShallowCopy(MakePose(0.1));
  check(0, "a pose that is not shown");
  actor->BindPoseOff();
  check(1, "the pose again");
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testSkinnedShadows)
{
  relievoTest::Session session;
  TestAgainstRays();
  TestFarAway();
  TestUnknown();
  TestManyBones();
  TestKept();
  TestRedraws();
  return session.Result();
}
}
