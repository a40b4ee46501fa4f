// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Every kind of prop under shadows: instances, blocks, impostors, assemblies cast and receive as
// the meshes that they stand for. With testShadowTranslucent these cases are the rows of
// docs/shadow-matrix.md about props.
#include "Check.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Props.h"
#include "Session.h"
#include "ShadowPictures.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkAppendPolyData.h>
#include <vtkAssembly.h>
#include <vtkCellArray.h>
#include <vtkGlyph3DMapper.h>
#include <vtkImageActor.h>
#include <vtkImageData.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRelievoCompositeMapper.h>
#include <vtkRelievoPass.h>
#include <vtkSphereSource.h>
#include <vtkStripper.h>
#if __has_include(<vtkOpenGLSphereMapper.h>)
#include <vtkOpenGLSphereMapper.h>
#endif

#include <cmath>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

namespace testShadowProps
{
namespace
{
using relievoTest::AddActor;
using relievoTest::EmbreeScene;
using relievoTest::MakePolygons;
using relievoTest::Moved;
using relievoTest::Picture;
using relievoTest::ShadowStage;

const std::vector<glm::dvec3> Places = { { -1.2, 0.9, 0. }, { 0., 1.2, 0.3 }, { 1.1, 0.8, -0.2 } };

vtkSmartPointer<vtkPolyData> Copies(vtkPolyData* mesh)
{
  vtkNew<vtkAppendPolyData> all;
  for (const glm::dvec3& place : Places)
  {
    all->AddInputData(Moved(mesh, place.x, place.y, place.z));
  }
  all->Update();
  return all->GetOutput();
}

vtkSmartPointer<vtkPolyData> MakeFineBall(double radius)
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(radius);
  source->SetThetaResolution(160);
  source->SetPhiResolution(80);
  source->Update();
  return source->GetOutput();
}

vtkSmartPointer<vtkPolyData> MakePoints(bool asLine)
{
  const auto points = MakePolygons(Places);
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 1, 2 });
  asLine ? points->SetLines(cells) : points->SetVerts(cells);
  return points;
}

// Adds the props, and their equivalents to the truth. Pixels of impostors' own curved surface may
// have other verdicts at the border of light.
struct Kind
{
  const char* Name;
  double Limit;
  std::function<vtkSmartPointer<vtkPolyData>(ShadowStage&)> Add;
};

const Kind Kinds[] = {
  { "a mesh", 1e-3,
    [](ShadowStage& s) {
      const auto mesh = Copies(relievoTest::MakeBox(0.6, 0.5, 0.4));
      AddActor(s.Renderer, mesh);
      return mesh;
    } },
  { "triangle strips", 1e-3,
    [](ShadowStage& s) {
      const auto mesh = Copies(MakeFineBall(0.4));
      vtkNew<vtkStripper> strips;
      strips->SetInputData(mesh);
      strips->Update();
      AddActor(s.Renderer, strips->GetOutput());
      return mesh;
    } },
  { "glyphs", 1e-3,
    [](ShadowStage& s) {
      vtkNew<vtkGlyph3DMapper> mapper;
      mapper->SetInputData(MakePolygons(Places));
      mapper->SetSourceData(relievoTest::MakeBox(0.3, 0.25, 0.2));
      mapper->SetScaleFactor(2.);
      AddActor(s.Renderer, MakePolygons(Places))->SetMapper(mapper);
      return Copies(relievoTest::MakeBox(0.6, 0.5, 0.4));
    } },
  { "blocks", 1e-3,
    [](ShadowStage& s) {
      vtkNew<vtkMultiBlockDataSet> inner;
      vtkNew<vtkMultiBlockDataSet> blocks;
      const auto box = relievoTest::MakeBox(0.6, 0.5, 0.4);
      for (unsigned int i = 0; i < 3; ++i)
      {
        (i < 2 ? inner : blocks)->SetBlock(i, Moved(box, Places[i].x, Places[i].y, Places[i].z));
      }
      blocks->SetBlock(0, inner);
      vtkNew<vtkRelievoCompositeMapper> mapper;
      mapper->SetInputDataObject(blocks);
      AddActor(s.Renderer, box)->SetMapper(mapper);
      return Copies(box);
    } },
  { "an assembly", 1e-3,
    [](ShadowStage& s) {
      const auto box = relievoTest::MakeBox(0.6, 0.5, 0.4);
      vtkNew<vtkAssembly> assembly;
      for (const glm::dvec3& place : Places)
      {
        vtkNew<vtkPolyDataMapper> mapper;
        mapper->SetInputData(box);
        vtkNew<vtkActor> actor;
        actor->SetMapper(mapper);
        actor->SetPosition(place.x, place.y - 0.3, place.z);
        assembly->AddPart(actor);
      }
      assembly->SetPosition(0., 0.3, 0.);
      s.Renderer->AddActor(assembly);
      return Copies(box);
    } },
  // Geometry that it draws without a mesh's mapper casts nothing, like such a prop alone.
  { "an assembly with an image", 1e-3,
    [](ShadowStage& s) {
      const auto mesh = Copies(relievoTest::MakeBox(0.6, 0.5, 0.4));
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputData(mesh);
      vtkNew<vtkActor> actor;
      actor->SetMapper(mapper);
      vtkNew<vtkImageData> image;
      image->SetDimensions(8, 8, 1);
      image->SetSpacing(0.2, 0.2, 0.2);
      image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
      image->GetPointData()->GetScalars()->Fill(200.);
      vtkNew<vtkImageActor> slice;
      slice->SetInputData(image);
      slice->SetPosition(-0.7, 0.1, -1.);
      vtkNew<vtkAssembly> assembly;
      assembly->AddPart(slice);
      assembly->AddPart(actor);
      s.Renderer->AddActor(assembly);
      return mesh;
    } },
#if __has_include(<vtkOpenGLSphereMapper.h>)
  { "sphere impostors", 4e-3,
    [](ShadowStage& s) {
      vtkNew<vtkOpenGLSphereMapper> mapper;
      mapper->SetInputData(MakePoints(false));
      mapper->SetRadius(0.4);
      AddActor(s.Renderer, MakePoints(false))->SetMapper(mapper);
      return Copies(MakeFineBall(0.4));
    } },
#endif
};

// Judges the layer against the truth with ground and `mesh`.
void TestKind(const Kind& kind)
{
  for (const bool lamp : { false, true })
  {
    ShadowStage stage;
    const relievoTest::GLCheck gl(stage.Window);
    stage.AddGround();
    EmbreeScene truth;
    truth.AddActors(stage.Renderer);
    truth.AddActor(kind.Add(stage));
    if (lamp)
    {
      stage.AddLamp({ -1., 4., -1.5 }, { 0.3, 0., 0.3 }, 90.);
    }
    else
    {
      stage.AddSun(-3., 4., -2.);
    }
    relievoTest::CheckShadow(
      stage, 0, kind.Limit, std::string(kind.Name) + (lamp ? ", lamp" : ", sun"), 0.03, &truth);
  }
}

// Geometry with a size in pixels has none in the world that a ray could hit: it stays, is lit or
// dark, and has a shadow of the same number of the map's texels.
void TestPixelSized()
{
  struct
  {
    const char* Name;
    bool Lines;
    bool Round;
  } const cases[] = { { "points", false, false }, { "points as spheres", false, true },
    { "lines", true, false }, { "lines as tubes", true, true } };
  for (const auto& test : cases)
  {
    ShadowStage stage;
    const relievoTest::GLCheck gl(stage.Window);
    stage.AddGround();
    const auto actor = AddActor(stage.Renderer, MakePoints(test.Lines));
    actor->GetProperty()->SetPointSize(12.f);
    actor->GetProperty()->SetLineWidth(8.f);
    actor->GetProperty()->SetRenderPointsAsSpheres(test.Round);
    actor->GetProperty()->SetRenderLinesAsTubes(test.Round);
    actor->GetProperty()->SetColor(0.9, 0.3, 0.2);
    const auto light = relievoTest::AddTwoSuns(stage);
    const relievoTest::Layers before(stage.Renderer, { "actor" });
    const relievoTest::ShadowPictures pictures(stage, light);
    const relievoTest::Layers after(stage.Renderer, { "actor" });
    RELIEVO_CHECK_AT_MOST(relievoTest::CountDifferent(before, after, "actor"), 0,
      std::string(test.Name) + ": pixels with another actor");
    relievoTest::ShadowTruth none;
    none.Width = 240;
    none.Height = 180;
    none.Verdicts.resize(240 * 180);
    const auto errors =
      relievoTest::JudgePicture(pictures.On, pictures.Off, pictures.Dark, none, 0, 1);
    RELIEVO_CHECK_AT_MOST(errors.Outside, 5, std::string(test.Name) + ": pixels that are neither");
    long long dark = 0;
    long long own = 0;
    for (int y = 0; y < 180; ++y)
    {
      for (int x = 0; x < 240; ++x)
      {
        const bool unlike = std::abs(pictures.On->GetScalarComponentAsDouble(x, y, 0, 0) -
                              pictures.Off->GetScalarComponentAsDouble(x, y, 0, 0)) > 20.;
        dark += unlike && before.Id("actor", x, y) == 0 ? 1 : 0;
        own += unlike && before.Id("actor", x, y) == 1 ? 1 : 0;
      }
    }
    std::cout << test.Name << ": " << dark << " pixels of the ground in shadow, " << own
              << " of their own\n";
    RELIEVO_CHECK_THAT(dark > 3 && dark < 3000, std::string(test.Name) + ": no shadow of theirs");
  }
}

// Two actors with one mapper share its shaders, also if one draws faces, which have a plane that
// receives, and the other their edges or corners, which have none: as with a mapper each.
void TestSharedMapper()
{
  for (const int representation : { VTK_WIREFRAME, VTK_POINTS })
  {
    for (const bool facesFirst : { false, true })
    {
      vtkSmartPointer<vtkImageData> pictures[2][2];
      for (const bool shared : { false, true })
      {
        ShadowStage stage;
        stage.AddGround();
        relievoTest::AddTwoSuns(stage);
        const auto ball = MakeFineBall(0.7);
        vtkSmartPointer<vtkActor> actors[2];
        for (int i = 0; i < 2; ++i)
        {
          actors[i] = AddActor(stage.Renderer, ball);
          actors[i]->SetPosition(1.6 * i - 0.8, 0.8, 0.);
        }
        actors[facesFirst ? 1 : 0]->GetProperty()->SetRepresentation(representation);
        actors[facesFirst ? 1 : 0]->GetProperty()->SetLineWidth(3.f);
        actors[facesFirst ? 1 : 0]->GetProperty()->SetPointSize(3.f);
        if (shared)
        {
          actors[1]->SetMapper(actors[0]->GetMapper());
        }
        pictures[shared][0] = Picture(stage.Window);
        stage.GetFrame()->ShadowsOn();
        pictures[shared][1] = Picture(stage.Window);
      }
      const std::string what = std::string("a mapper shared by faces and ") +
        (representation == VTK_POINTS ? "points" : "wires") +
        (facesFirst ? ", faces first" : ", faces last");
      relievoTest::SamePicture(pictures[0][0], pictures[1][0], what + ", without shadows");
      RELIEVO_CHECK_THAT(relievoTest::CountUnlike(pictures[0][0], pictures[0][1], 20) > 1000,
        what + ": there are no shadows");
#ifdef RELIEVO_VTK_PROP_VECTOR
      const double most = 1.; // VTK 9.7: one pixel of the wires, at the edge of a shadow
#else
      const double most = 0.;
#endif
      RELIEVO_CHECK_AT_MOST(relievoTest::CountUnlike(pictures[0][1], pictures[1][1]), most,
        what + ": pixels unlike those with a mapper each");
    }
  }
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testShadowProps)
{
  relievoTest::Session session;
  for (const Kind& kind : Kinds)
  {
    TestKind(kind);
  }
  TestPixelSized();
  TestSharedMapper();
  return session.Result();
}
}
