// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Maps are redrawn exactly when something relevant changed: after every change the picture equals
// that of a new renderer, and irrelevant changes draw no map. With the argument `exact`, the test
// covers the verdicts of rays, which are recomputed instead.
#include "Check.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Props.h"
#include "Session.h"
#include "ShadowPictures.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkAssembly.h>
#include <vtkCamera.h>
#include <vtkCompositeDataDisplayAttributes.h>
#include <vtkGlyph3DMapper.h>
#include <vtkImageData.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRelievoCompositeMapper.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowStage.h>
#include <vtkShaderProperty.h>
#include <vtkTexture.h>
#include <vtkTransform.h>
#include <vtkUniforms.h>

#include <functional>
#include <set>

namespace testShadowCache
{
namespace
{
using relievoTest::Picture;

bool Exact = false; // the method

// A sun, a lamp that shines everywhere and one that does not, one map each; and the surfaces that
// they light.
struct Scene : relievoTest::ShadowStage
{
  Scene()
    : ShadowStage(Exact ? 120 : 240, Exact ? 90 : 180)
  {
    this->AddGround();
    this->Thing = this->AddBox({ 0.2, 0.8, -0.3 }, { 0.5, 1.6, 0.5 });
    this->Sun = this->AddSun(-3., 4., -2.);
    this->AddLamp({ -2., 3., 1. }, { 0., 0., 0. }, 90.)->SetIntensity(0.3);
    this->AddLamp({ -2., 3., -1. }, { 0., 0., 0. }, 40.)->SetIntensity(0.3);
    this->Sun->SetIntensity(0.3);
    this->GetShadows()->SetMapSize(512);
    this->GetFrame()->ShadowsOn();
    if (Exact)
    {
      this->GetShadows()->SetMethodToExact();
    }
  }

  vtkPolyData* GetMesh()
  {
    return vtkPolyData::SafeDownCast(this->Thing->GetMapper()->GetInputDataObject(0, 0));
  }
  template <typename Mapper>
  Mapper* GetMapper()
  {
    return Mapper::SafeDownCast(this->Thing->GetMapper());
  }

  vtkSmartPointer<vtkActor> Thing;
  vtkSmartPointer<vtkActor> Other;
  vtkSmartPointer<vtkLight> Sun;
};

using Step = std::function<void(Scene&)>;

struct Case
{
  const char* Name;
  int Drawn;   // maps drawn in the frame after the change
  bool Seen;   // the picture changes
  Step Change; // between two frames
  Step Prepare = nullptr;
  enum
  {
    InBoth,
    InMapsOnly,
    InRaysOnly
  } Matters = InBoth;
  bool Buffers = false; // VTK makes its mapper's buffers anew, and so are verdicts about it
};

void MovePoints(vtkPolyData* mesh)
{
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    p[0] += 0.3;
    mesh->GetPoints()->SetPoint(i, p);
  }
  mesh->GetPoints()->Modified();
}

// A user's shader that moves vertices by a uniform's share of (0.3, 0, 0.4).
void MoveInShader(Scene& s, const std::string& share)
{
  s.Thing->GetShaderProperty()->AddVertexShaderReplacement("//VTK::PositionVC::Impl", true,
    "vec4 movedMC = vertexMC + " + share +
      " * vec4(0.3, 0.0, 0.4, 0.0);\n#define vertexMC movedMC\n//VTK::PositionVC::Impl\n",
    false);
}

void UseCard(Scene& s)
{
  s.Renderer->RemoveActor(s.Thing);
  s.Thing = relievoTest::AddActor(s.Renderer, relievoTest::MakeSquare());
  s.Thing->SetPosition(0., 1.2, 0.);
  s.Thing->RotateX(70.);
}

void UseCardWithHoles(Scene& s)
{
  UseCard(s);
  s.Thing->SetTexture(relievoTest::MakeChecker(true));
}

void UseAssembly(Scene& s)
{
  s.Renderer->RemoveActor(s.Thing);
  vtkNew<vtkAssembly> assembly;
  assembly->AddPart(s.Thing);
  s.Renderer->AddActor(assembly);
}

void UseBlocks(Scene& s)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, relievoTest::Moved(relievoTest::MakeBall(0.4), 0., 1., 0.));
  blocks->SetBlock(1, relievoTest::Moved(relievoTest::MakeBall(0.3), 1., 0.5, 0.));
  vtkNew<vtkRelievoCompositeMapper> mapper;
  mapper->SetInputDataObject(blocks);
  mapper->SetCompositeDataDisplayAttributes(vtkNew<vtkCompositeDataDisplayAttributes>());
  s.Thing->SetMapper(mapper);
}

// Two boxes, one without back faces, exchange their mappers.
void UseCulled(Scene& s)
{
  s.Other = s.AddBox({ -0.9, 0.7, 0.6 }, { 0.5, 1.4, 0.5 });
  s.Other->GetProperty()->BackfaceCullingOn();
  s.Other->GetProperty()->SetColor(0.3, 0.5, 0.8);
}

void UseGlyphs(Scene& s)
{
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(
    relievoTest::MakePolygons({ { 0., 1., 0. }, { 1., 1., 0. }, { -1., 1., 1. } }));
  mapper->SetSourceData(relievoTest::MakeBall(0.3));
  s.Thing->SetMapper(mapper);
}

void MoveBlock(Scene& s)
{
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(s.Thing->GetMapper()->GetInputDataObject(0, 0));
  MovePoints(vtkPolyData::SafeDownCast(blocks->GetBlock(1)));
  blocks->Modified(); // or VTK's own mapper keeps the old bounds
}

const Case Cases[] = {
  { "nothing", 0, false, [](Scene&) {} },
  { "the sun moves", 1, true, [](Scene& s) { s.Sun->SetPosition(-3., 4., -1.); } },
  { "a light's colour", 0, true, [](Scene& s) { s.Sun->SetColor(1., 0.5, 0.5); } },
  { "a light's shadow attenuation", 0, true, [](Scene& s) { s.Sun->SetShadowAttenuation(0.5); } },
  { "the strength", 0, true, [](Scene& s) { s.GetShadows()->SetStrength(0.5); } },
  { "the bias", 0, true, [](Scene& s) { s.GetShadows()->SetBias(100.); }, nullptr,
    Case::InMapsOnly },
  { "a colour", 0, true, [](Scene& s) { s.Thing->GetProperty()->SetColor(0.5, 0.2, 0.1); }, nullptr,
    Case::InBoth, true },
  { "an actor moves", 3, true, [](Scene& s) { s.Thing->SetPosition(0.3, 0., 0.4); } },
  { "a user's transform", 3, true,
    [](Scene& s) {
      vtkNew<vtkTransform> transform;
      transform->Translate(0.3, 0., 0.4);
      s.Thing->SetUserTransform(transform);
    } },
  { "points move", 3, true, [](Scene& s) { MovePoints(s.GetMesh()); } },
  { "another mesh", 3, true,
    [](Scene& s) {
      s.GetMapper<vtkPolyDataMapper>()->SetInputData(
        relievoTest::Moved(relievoTest::MakeBall(0.5), 0., 1., 0.));
    } },
  { "another mapper", 3, true, UseGlyphs },
  { "two mappers change places", 3, true,
    [](Scene& s) {
      const vtkSmartPointer<vtkMapper> mapper = s.Thing->GetMapper();
      s.Thing->SetMapper(s.Other->GetMapper());
      s.Other->SetMapper(mapper);
    },
    UseCulled },
  { "an actor is hidden", 3, true, [](Scene& s) { s.Thing->VisibilityOff(); } },
  { "an actor comes", 3, true,
    [](Scene& s) {
      s.AddBox({ 1., 0.5, 1. }, { 0.3, 1., 0.3 });
    } },
  { "an actor goes", 3, true, [](Scene& s) { s.Renderer->RemoveActor(s.Thing); } },
  { "an actor casts no longer", 3, true,
    [](Scene& s) { s.GetShadows()->SetPropCasts(s.Thing, vtkRelievoShadowStage::CASTS_NEVER); } },
  { "an actor turns translucent", 3, true,
    [](Scene& s) { s.Thing->GetProperty()->SetOpacity(0.5); } },
  { "a wireframe", 3, true,
    [](Scene& s) { s.Thing->GetProperty()->SetRepresentationToWireframe(); } },
  { "a clipping plane", 3, true,
    [](Scene& s) {
      vtkNew<vtkPlane> plane;
      plane->SetOrigin(0., 0.6, 0.);
      plane->SetNormal(0., -1., 0.);
      s.Thing->GetMapper()->AddClippingPlane(plane);
    } },
  { "a vertex shader", 3, true, [](Scene& s) { MoveInShader(s, "1.0"); } },
  { "a vertex shader's uniform", 3, true,
    [](Scene& s) {
      s.Thing->GetShaderProperty()->GetVertexCustomUniforms()->SetUniformf("relievoShare", 1.f);
    },
    [](Scene& s) {
      s.Thing->GetShaderProperty()->GetVertexCustomUniforms()->SetUniformf("relievoShare", 0.f);
      MoveInShader(s, "relievoShare");
    } },
  { "a texture with holes", 3, true,
    [](Scene& s) { s.Thing->SetTexture(relievoTest::MakeChecker(true)); }, UseCard },
  { "other holes in a texture", 3, true,
    [](Scene& s) {
      vtkImageData* image = s.Thing->GetTexture()->GetInput();
      vtkDataArray* texels = image->GetPointData()->GetScalars();
      for (vtkIdType i = 0; i < 16; ++i)
      {
        texels->SetComponent(i, 3, 255. - texels->GetComponent(i, 3));
      }
      texels->Modified();
      image->Modified();
    },
    UseCardWithHoles },
  { "a part of an assembly moves", 3, true, [](Scene& s) { s.Thing->SetPosition(0.3, 0., 0.4); },
    UseAssembly },
  { "a part of an assembly is hidden", 3, true, [](Scene& s) { s.Thing->VisibilityOff(); },
    UseAssembly },
  { "a block is hidden", 3, true,
    [](Scene& s) { s.GetMapper<vtkRelievoCompositeMapper>()->SetBlockVisibility(2, false); },
    UseBlocks },
  { "a block is translucent", 3, true,
    [](Scene& s) { s.GetMapper<vtkRelievoCompositeMapper>()->SetBlockOpacity(2, 0.4); },
    UseBlocks },
  { "a block's points move", 3, true, MoveBlock, UseBlocks },
  { "nothing, of blocks", 0, false, [](Scene&) {}, UseBlocks },
  { "larger glyphs", 3, true,
    [](Scene& s) { s.GetMapper<vtkGlyph3DMapper>()->SetScaleFactor(1.6); }, UseGlyphs },
  { "other glyphs", 3, true,
    [](Scene& s) {
      s.GetMapper<vtkGlyph3DMapper>()->SetSourceData(relievoTest::MakeBox(0.5, 0.5, 0.5));
    },
    UseGlyphs },
  { "nothing, of glyphs", 0, false, [](Scene&) {}, UseGlyphs },
  { "the maps' size", 3, true, [](Scene& s) { s.GetShadows()->SetMapSize(700); }, nullptr,
    Case::InMapsOnly },
  { "the filter's radius", 3, true, [](Scene& s) { s.GetShadows()->SetFilterRadius(4); }, nullptr,
    Case::InMapsOnly },
  { "the opacity of a pane that casts", 0, true,
    [](Scene& s) { s.Thing->GetProperty()->SetOpacity(0.7); },
    [](Scene& s) {
      s.Thing->GetProperty()->SetOpacity(0.4);
      s.GetShadows()->SetPropCasts(s.Thing, vtkRelievoShadowStage::CASTS_ALWAYS);
    },
    Case::InRaysOnly },
  { "what only receives moves", 0, true, [](Scene& s) { s.Thing->SetPosition(0.3, 0., 0.4); },
    [](Scene& s) {
      s.GetShadows()->SetPropCasts(s.Thing, vtkRelievoShadowStage::CASTS_NEVER);
      s.AddBox({ -0.6, 1.6, -0.8 }, { 0.6, 0.3, 0.6 });
    },
    Case::InRaysOnly },
  { "nothing, with samples", 0, false, [](Scene&) {},
    [](Scene& s) { s.Window->SetMultiSamples(4); } },
  { "the sun moves, with samples", 1, true, [](Scene& s) { s.Sun->SetPosition(-3., 4., -1.); },
    [](Scene& s) { s.Window->SetMultiSamples(4); } },
  { "a light casts no longer", 2, true,
    [](Scene& s) { s.GetShadows()->SetLightCasts(s.Sun, false); } },
  { "a light is switched off", 2, true, [](Scene& s) { s.Sun->SwitchOff(); } },
  { "a light comes", 4, true, [](Scene& s) { s.AddSun(2., 5., -3.)->SetIntensity(0.2); } },
  { "a light goes", 2, true, [](Scene& s) { s.Renderer->RemoveLight(s.Sun); } },
};

// Casters are drawn into maps with every method, or traced as tested above.
bool IsOfMaps(const Case& test)
{
  static const std::set<std::string> names = { "a user's transform", "another mapper",
    "a clipping plane", "a vertex shader", "a vertex shader's uniform", "a texture with holes",
    "other holes in a texture", "a part of an assembly is hidden", "larger glyphs",
    "nothing, of glyphs", "a light is switched off", "an actor goes", "another mesh",
    "a light's shadow attenuation" };
  return test.Matters == Case::InMapsOnly || names.count(test.Name) > 0;
}

// The draws of the last frame before its picture: maps, or the method's own.
int CountDrawn(Scene& scene)
{
  return Exact ? scene.GetShadows()->GetDrawCalls() : scene.GetShadows()->GetNumberOfMapsDrawn();
}

void Test(const Case& test)
{
  const std::string what = test.Name;
  Scene warm;
  const relievoTest::GLCheck gl(warm.Window);
  if (test.Prepare)
  {
    test.Prepare(warm);
  }
  const auto first = Picture(warm.Window);
  RELIEVO_CHECK(Exact || CountDrawn(warm) == 3);
  const auto before = Picture(warm.Window);
  relievoTest::SamePicture(first, before, what + ", a still frame before it");
  if (Exact) // one frame of the mappers' own first
  {
    Picture(warm.Window);
  }
  RELIEVO_CHECK_THAT(CountDrawn(warm) == 0,
    what + ": a still frame before it draws " + std::to_string(CountDrawn(warm)));
  test.Change(warm);
  const auto after = Picture(warm.Window);
  const int drawn = CountDrawn(warm);
  const bool anew = test.Drawn > 0 || test.Buffers || test.Matters == Case::InRaysOnly;
  // A light less or more may cost all maps; they share one texture.
  RELIEVO_CHECK_THAT(Exact ? (drawn > 0) == anew : drawn == test.Drawn,
    what + ": " + std::to_string(drawn) + " are drawn, " + std::to_string(test.Drawn) +
      " were expected");
  RELIEVO_CHECK_THAT((relievoTest::CountUnlike(before, after) > 20) == test.Seen,
    what + (test.Seen ? " changes nothing" : " changes the picture"));
  relievoTest::SamePicture(after, Picture(warm.Window), what + ", the frame after");
  if (Exact)
  {
    relievoTest::SamePicture(after, Picture(warm.Window), what + ", the second frame after");
  }
  RELIEVO_CHECK(CountDrawn(warm) == 0);

  Scene cold;
  if (test.Prepare)
  {
    test.Prepare(cold);
  }
  test.Change(cold);
  relievoTest::SamePicture(Picture(cold.Window), after, what + ", against a cold start");
}

// Maps are wider than they must be while the view moves, so that few are drawn.
void TestOrbit()
{
  Scene scene;
  scene.Window->Render();
  int drawn = 0;
  for (int i = 0; i < 60; ++i)
  {
    scene.Renderer->GetActiveCamera()->Azimuth(1.);
    scene.Window->Render();
    drawn += scene.GetShadows()->GetNumberOfMapsDrawn();
  }
  RELIEVO_CHECK_AT_MOST(drawn, 90, "maps drawn in 60 frames of an orbit, of 180 and more");
  relievoTest::CheckShadow(scene, 0, 2e-3, "the sun after an orbit", 0.005);

  drawn = 0;
  for (int i = 0; i < 20; ++i)
  {
    scene.Sun->SetPosition(-3., 4., -2. + 0.1 * (i + 1));
    scene.Window->Render();
    RELIEVO_CHECK_THAT(scene.GetShadows()->GetNumberOfMapsDrawn() == 1,
      "a sun that moves draws " + std::to_string(scene.GetShadows()->GetNumberOfMapsDrawn()) +
        " maps");
  }
}

// Verdicts that stay while others are found anew are right as well: a box goes over and under
// others.
void TestMovesStepByStep()
{
  relievoTest::ShadowStage stage;
  stage.AddGround();
  stage.AddBox({ -0.6, 0.4, -0.5 }, { 0.5, 0.8, 0.5 });
  stage.AddBox({ 0.7, 0.3, 0.5 }, { 0.4, 0.6, 0.4 });
  vtkActor* box = stage.AddBox({ 0., 0.2, 0. }, { 0.4, 0.4, 0.4 });
  stage.AddSun(-1., 3., -1.);
  stage.GetFrame()->ShadowsOn();
  stage.GetShadows()->SetMethodToExact();
  stage.Window->Render();
  stage.Window->Render();
  for (int i = 0; i < 6; ++i)
  {
    box->SetPosition(0.25 * i - 0.8, i < 3 ? 1. : 0., 0.2 * i - 0.5);
    stage.Window->Render();
    RELIEVO_CHECK(stage.GetShadows()->GetDrawCalls() > 0);
    relievoTest::CheckShadow(stage, 0, 2e-4, "a box at place " + std::to_string(i), 0.001);
  }
}

// The map of a box's shadow on a ground far wider than the view does not change while the camera
// goes around and sees the shadow.
void TestOrbitOverWideGround()
{
  relievoTest::ShadowStage stage;
  stage.AddGround()->SetScale(20., 1., 20.);
  stage.AddBox({ 0., 0.4, 0. }, { 0.8, 0.8, 0.5 });
  stage.AddSun(-1., 3., -1.);
  stage.GetFrame()->ShadowsOn();
  stage.Window->Render();
  RELIEVO_CHECK(stage.GetShadows()->GetNumberOfMapsDrawn() == 1);
  int drawn = 0;
  for (int i = 0; i < 30; ++i)
  {
    stage.Renderer->GetActiveCamera()->Azimuth(12.);
    stage.Window->Render();
    drawn += stage.GetShadows()->GetNumberOfMapsDrawn();
  }
  RELIEVO_CHECK_AT_MOST(drawn, 0, "maps drawn in an orbit over a wide ground");
  relievoTest::CheckShadow(stage, 0, 1e-3, "the sun over a wide ground", 0.001);
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testShadowCache)
{
  relievoTest::Session session;
  Exact = argc > 1 && std::string(argv[1]) == "exact";
  for (const Case& test : Cases)
  {
    if (Exact ? !IsOfMaps(test) : test.Matters != Case::InRaysOnly)
    {
      Test(test);
    }
  }
  if (Exact)
  {
    TestMovesStepByStep();
  }
  if (!Exact)
  {
    TestOrbit();
    TestOrbitOverWideGround();
  }
  return session.Result();
}
}
