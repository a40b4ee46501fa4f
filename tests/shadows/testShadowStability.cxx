// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Shadows where shadow maps fail: grazing suns, contacts, fins, sheets and open meshes, lamps in
// awkward places, worlds of any size and place. The truth is traced with rays. With the argument
// `exact` the same with this method, which may not err at edges either.
#include "Check.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Props.h"
#include "Scenes.h"
#include "Session.h"
#include "ShadowPictures.h"
#include "ShadowScenes.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkGlyph3DMapper.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkLightCollection.h>
#include <vtkPointData.h>
#include <vtkProperty.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowStage.h>

#include <cmath>
#include <functional>
#include <iostream>
#include <string>

namespace testShadowStability
{
namespace
{
using relievoTest::MakePolygons;
using relievoTest::ShadowStage;
using Fill = std::function<void(ShadowStage&)>;

bool Exact = false; // the method

// Besides the edges of the shadow's own texels nothing may be wrong: no acne, no leak, no shadow
// that has come off its caster. Inner pixels have eight neighbours of their own verdict.
void CheckInner(const std::string& what, ShadowStage& stage, int number, double limit,
  const relievoTest::EmbreeScene* scene = nullptr, double exactLimit = 0.)
{
  const auto image = relievoTest::CaptureShadow(stage, number);
  const auto truth = relievoTest::TraceStage(stage, number, scene);
  const std::string name = "shadow_" + std::to_string(number);
  auto* array = vtkFloatArray::SafeDownCast(image->GetPointData()->GetArray(name.c_str()));
  if (!array)
  {
    return; // counted before
  }
  const auto all = relievoTest::CompareShadow(truth, array->GetPointer(0));
  const auto inner = relievoTest::CompareShadow(relievoTest::GetInner(truth), array->GetPointer(0));
  std::cout << what << ": " << all.ToString() << "; inner " << inner.ToString() << "\n";
  RELIEVO_CHECK_THAT(inner.Compared > 1000 && inner.Dark > 50, what + ": too little is judged");
  RELIEVO_CHECK_AT_MOST(
    all.Wrong(), Exact ? exactLimit : limit, what + ": share of wrong verdicts");
  RELIEVO_CHECK_AT_MOST(inner.FalseShadow, 0, what + ": inner pixels in false shadow");
  RELIEVO_CHECK_AT_MOST(inner.FalseLight, 0, what + ": inner pixels in false light");
}

void Test(const std::string& what, const Fill& fill, double limit = 1e-3, double scale = 1.,
  const glm::dvec3& origin = glm::dvec3(0.), double exactLimit = 0.)
{
  ShadowStage stage(240, 180, scale, origin);
  const relievoTest::GLCheck gl(stage.Window);
  fill(stage);
  if (Exact)
  {
    stage.GetShadows()->SetMethodToExact();
  }
  for (int i = 0; i < stage.Renderer->GetLights()->GetNumberOfItems(); ++i)
  {
    CheckInner(what + ", light " + std::to_string(i), stage, i, limit, nullptr, exactLimit);
  }
}

// A sheet with these corners, once or wound the other way.
void AddSheet(ShadowStage& stage, std::vector<glm::dvec3> corners, bool inverted)
{
  for (glm::dvec3& corner : corners)
  {
    corner = stage.Place(corner);
  }
  const auto mesh = MakePolygons(corners);
  if (inverted)
  {
    mesh->GetPolys()->InsertNextCell({ 3, 2, 1, 0 });
  }
  else
  {
    mesh->GetPolys()->InsertNextCell({ 0, 1, 2, 3 });
  }
  relievoTest::AddActor(stage.Renderer, mesh);
}

void TestContacts()
{
  Test("sun 3 degrees above the ground", [](ShadowStage& s) {
    s.AddGround();
    s.AddBox({ -1.5, 0.05, -0.5 }, { 0.2, 0.1, 1. });
    s.AddSun(-3., 3.2 * std::tan(glm::radians(3.)), -1.);
  });
  Test("two slabs in contact", [](ShadowStage& s) {
    s.AddGround();
    s.AddBox({ 0., 0.15, 0. }, { 2., 0.3, 1.5 });
    s.AddBox({ -0.3, 0.4, 0. }, { 1.2, 0.2, 1.5 });
    s.AddSun(-3., 2., -1.5);
    s.AddLamp({ -2., 2., -1. }, { 0., 0., 0. }, 50.);
  });
  Test("a fin on the ground", [](ShadowStage& s) {
    s.AddGround();
    s.AddBox({ 0., 0.5, 0. }, { 1.6, 1., 0.002 });
    s.AddSun(-1., 3., -3.);
    s.AddLamp({ -1., 2., -2. }, { 0., 0., 0. }, 50.);
    s.AddLamp({ -1., 2., -2. }, { 0., 0., 0. }, 90.);
  });
  for (const bool inverted : { false, true })
  {
    Test(std::string("sheets") + (inverted ? ", wound the other way" : ""),
      [inverted](ShadowStage& s) {
        s.AddGround();
        AddSheet(s, { { -1.5, 0.8, 0.8 }, { 0., 0.8, 0.8 }, { 0., 1., -0.6 }, { -1.5, 1., -0.6 } },
          inverted);
        AddSheet(
          s, { { 0.5, 0., 0. }, { 1.5, 0., 0.3 }, { 1.5, 1., 0.3 }, { 0.5, 1., 0. } }, inverted);
        s.AddSun(-2., 4., -1.5);
        s.AddLamp({ -1., 2.5, -1. }, { 0., 0., 0. }, 55.);
      });
  }
  Test("a box without a lid, from inside and outside", [](ShadowStage& s) {
    s.AddGround();
    AddSheet(s, { { -1., 0., 1. }, { 1., 0., 1. }, { 1., 0.5, 1. }, { -1., 0.5, 1. } }, false);
    AddSheet(s, { { -1., 0., -1. }, { 1., 0., -1. }, { 1., 0.5, -1. }, { -1., 0.5, -1. } }, false);
    AddSheet(s, { { -1., 0., -1. }, { -1., 0., 1. }, { -1., 0.5, 1. }, { -1., 0.5, -1. } }, true);
    AddSheet(s, { { 1., 0., -1. }, { 1., 0., 1. }, { 1., 0.5, 1. }, { 1., 0.5, -1. } }, false);
    s.AddSun(-3., 2., -2.);
    s.AddLamp({ 0.2, 0.3, 0.1 }, { 0., 0., 0. }, 90.);
  });
}

void TestPlacesOfLights()
{
  const auto lamps = [](glm::dvec3 place, std::vector<double> cones) {
    return [place, cones](ShadowStage& s) {
      s.AddThings();
      for (const double cone : cones)
      {
        s.AddLamp(place, { 0., 0.3, 0. }, cone);
      }
    };
  };
  Test("in a closed box", [](ShadowStage& s) {
    s.AddThings();
    s.AddLamp({ -1.3, 0.52, 0.8 }, { 0., 0., 0. }, 90.);
  });
  Test("on a box's side", lamps({ 0.8, 0.6, 0.1 }, { 90. }), 2e-3);
  Test("a little off a box's side", lamps({ 0.801, 0.6, 0.1 }, { 90. }), 2e-3);
  Test("low over the ground", lamps({ -2.4, 0.3, -0.4 }, { 50., 90. }), 2e-3);
  Test("behind the camera", lamps({ 9., 4., 5. }, { 50., 90. }));
  Test("beside the camera", lamps({ 2., 3.4, 5.5 }, { 50., 90. }));
  Test("things behind the lamp", [](ShadowStage& s) {
    s.AddThings();
    s.AddBox({ -2., 5.5, -2. }, { 3., 1., 3. });
    s.AddLamp({ -1., 4., -1. }, { 0., 0., 0. }, 50.);
    s.AddLamp({ -1., 4., -1. }, { 0., 0., 0. }, 85.);
    s.AddLamp({ -1., 4., -1. }, { 0., 0., 0. }, 90.);
  });
  Test("straight above, along the view-up", [](ShadowStage& s) {
    s.AddThings();
    s.AddSun(0., 5., 0.);
    s.AddLamp({ 0.4, 5., 0.2 }, { 0.4, 0., 0.2 }, 60.);
  });
  Test("straight above, seen along the light", [](ShadowStage& s) {
    s.AddThings();
    s.Renderer->GetActiveCamera()->SetPosition(0.5, 8., 0.5);
    s.Renderer->GetActiveCamera()->SetFocalPoint(0.5, 0., 0.5);
    s.Renderer->GetActiveCamera()->SetViewUp(0., 0., -1.);
    s.AddLamp({ 0.4, 5., 0.2 }, { 0.4, 0., 0.2 }, 60.);
    s.AddLamp({ 0.4, 5., 0.2 }, { 0.4, 0., 0.2 }, 90.);
  });
  ShadowStage stage;
  stage.AddThings();
  const double* eye = stage.Renderer->GetActiveCamera()->GetPosition();
  stage.AddLamp({ eye[0], eye[1], eye[2] }, { 0., 0., 0. }, 90.);
  double range[2];
  relievoTest::CaptureShadow(stage, 0)->GetPointData()->GetArray("shadow_0")->GetRange(range);
  RELIEVO_CHECK_THAT(range[0] == 1., "a lamp at the eye has shadows");
}

void TestWorlds()
{
  const auto plain = [](ShadowStage& s) {
    s.AddThings();
    s.AddSun(-3., 4., -2.);
    s.AddLamp({ -1., 4., -1.5 }, { 0.3, 0., 0.3 }, 40.);
    s.AddLamp({ -1., 3., -1.5 }, { 0.3, 0., 0.3 }, 90.);
  };
  Test("a million wide", plain, 1e-3, 1e6);
  Test("a millionth wide", plain, 1e-3, 1e-6);
  Test("far from the origin", plain, 1e-3, 1., { 5e5, 5e6, 0. });
  Test("far over near 1e6", [&plain](ShadowStage& s) {
    plain(s);
    s.Renderer->GetActiveCamera()->SetClippingRange(0.01, 1e4);
  });
  Test("a huge actor that is not seen", [&plain](ShadowStage& s) {
    plain(s);
    s.AddBox({ 0., 0., 0. }, { 1e6, 1e6, 1e6 })->VisibilityOff();
  });
  Test("a huge slab below", [&plain](ShadowStage& s) {
    plain(s);
    s.AddBox({ 0., -1e3, 0. }, { 1e4, 1., 1e4 });
  });
  Test(
    "a caster far towards the sun",
    [](ShadowStage& s) {
      s.AddThings();
      s.AddBox({ 3e4, 4e4, 2e4 }, { 1., 0.1, 1. });
      s.AddSun(3., 4., 2.);
    },
    1e-3, 1., glm::dvec3(0.), 1.5e-3); // floats have no digits left there
  Test("parallel camera", [&plain](ShadowStage& s) {
    plain(s);
    s.Renderer->GetActiveCamera()->ParallelProjectionOn();
    s.Renderer->GetActiveCamera()->SetParallelScale(1.7);
  });
  Test(
    "telephoto",
    [](ShadowStage& s) {
      s.AddThings();
      s.AddSun(-3., 4., -2.);
      s.AddLamp({ -1., 4., -1.5 }, { 0.3, 0., 0.3 }, 40.);
      s.AddLamp({ -1., 3., -1.5 }, { 0.3, 0., 0.3 }, 90.);
      s.Renderer->GetActiveCamera()->SetPosition(2.5e3, 2.5e3 + 0.5, 6e3);
      s.Renderer->GetActiveCamera()->SetViewAngle(0.03);
      s.Renderer->GetActiveCamera()->SetClippingRange(5e3, 9e3);
    },
    1e-3, 1., glm::dvec3(0.), 2e-4); // nor in eye space, so far from the eye
}

// Floors with a wall, in one mesh, far from the origin and wider than the camera's view.
void TestSurveys()
{
  struct
  {
    glm::dvec3 Origin;
    double Half; // of the floor's width
  } const cases[] = { { { 5e5, 5.3e6, 200. }, 300. }, { { 1e6, 0., 0. }, 100. },
    { { 1e5, 0., 0. }, 10. } };
  for (const auto& one : cases)
  {
    Test(
      "a floor of half width " + std::to_string(one.Half),
      [&one](ShadowStage& s) {
        const double b = one.Half;
        std::vector<glm::dvec3> corners = { { -b, 0., 0.5 * b }, { b, 0., 0.5 * b },
          { b, 0., -0.5 * b }, { -b, 0., -0.5 * b }, { -1.5, 0., -0.4 }, { 1.5, 0., 0. },
          { 1.5, 1., 0. }, { -1.5, 1., -0.4 } };
        for (glm::dvec3& corner : corners)
        {
          corner = s.Place(corner);
        }
        const auto mesh = MakePolygons(corners);
        mesh->GetPolys()->InsertNextCell({ 0, 1, 2, 3 });
        mesh->GetPolys()->InsertNextCell({ 4, 5, 6, 7 });
        relievoTest::AddActor(s.Renderer, mesh);
        s.AddSun(-2., 2., -3.);
      },
      1e-3, 1., one.Origin, 1e-4); // where corners of the wall meet the floor
  }
}

// A scene gives the same picture at any place, except for rounding at edges.
void TestPlaces()
{
  vtkSmartPointer<vtkImageData> pictures[2];
  for (int i = 0; i < 2; ++i)
  {
    ShadowStage stage(800, 600, 1., i ? glm::dvec3(5e5, 5e6, 0.) : glm::dvec3(0.));
    stage.AddThings();
    stage.AddSun(-3., 4., -2.);
    stage.AddLamp({ -1., 4., -1.5 }, { 0.3, 0., 0.3 }, 40.);
    stage.AddLamp({ -1., 3., -1.5 }, { 0.3, 0., 0.3 }, 90.);
    stage.GetFrame()->ShadowsOn();
    pictures[i] = relievoTest::Picture(stage.Window);
  }
  RELIEVO_CHECK_AT_MOST(relievoTest::CountUnlike(pictures[0], pictures[1], 4), 24,
    "pixels of 480000 that differ far from the origin");
}

// A tall thin pole in a low sun: its shadow is as dark at its end as at its foot.
void TestUmbra()
{
  ShadowStage stage;
  stage.AddGround();
  stage.AddBox({ -2.2, 1., -1.2 }, { 0.25, 2., 0.25 });
  stage.AddSun(-3., 1., -1.8);
  stage.GetShadows()->SetFilterRadius(2);
  const auto image = relievoTest::CaptureShadow(stage, 0);
  const auto truth = relievoTest::GetInner(relievoTest::TraceStage(stage, 0), 2);
  long long count = 0;
  double brightest = 0.;
  for (std::size_t i = 0; i < truth.Verdicts.size(); ++i)
  {
    if (truth.Verdicts[i] == relievoTest::ShadowTruth::Dark)
    {
      ++count;
      brightest = std::max(brightest,
        image->GetPointData()->GetArray("shadow_0")->GetComponent(static_cast<vtkIdType>(i), 0));
    }
  }
  RELIEVO_CHECK_THAT(count > 300, "umbra: " + std::to_string(count) + " pixels");
  RELIEVO_CHECK_AT_MOST(brightest, 0., "umbra: the brightest pixel");
}

// Many small things at once, drawn as instances.
void TestGlyphs()
{
  ShadowStage stage;
  stage.AddGround();
  std::vector<glm::dvec3> places;
  for (int i = 0; i < 100000; ++i)
  {
    // A hundred layers of a lattice that the sun does not shine along.
    const int x = i % 40;
    const int z = i / 40 % 25;
    const int y = i / 1000;
    places.emplace_back(-1.5 + 0.06 * x, 0.2 + 0.011 * y, -0.8 + 0.06 * z + 0.01 * (y % 7));
  }
  const auto points = MakePolygons(places);
  const auto source = relievoTest::MakeBox(0.03, 0.006, 0.03);
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(points);
  mapper->SetSourceData(source);
  mapper->ScalingOff();
  mapper->OrientOff();
  const auto actor = relievoTest::AddActor(stage.Renderer, source);
  actor->SetMapper(mapper);
  stage.AddSun(-3., 4., -2.2);
  relievoTest::EmbreeScene truth;
  truth.AddActors(stage.Renderer);
  vtkNew<vtkPoints> corners;
  corners->SetDataTypeToDouble();
  vtkNew<vtkCellArray> polys;
  for (const glm::dvec3& place : places)
  {
    const vtkIdType first = corners->GetNumberOfPoints();
    for (vtkIdType i = 0; i < source->GetNumberOfPoints(); ++i)
    {
      const double* p = source->GetPoint(i);
      corners->InsertNextPoint(p[0] + place.x, p[1] + place.y, p[2] + place.z);
    }
    for (vtkIdType cell = 0; cell < source->GetNumberOfCells(); ++cell)
    {
      vtkNew<vtkIdList> ids;
      source->GetCellPoints(cell, ids);
      polys->InsertNextCell({ first + ids->GetId(0), first + ids->GetId(1), first + ids->GetId(2),
        first + ids->GetId(3) });
    }
  }
  vtkNew<vtkPolyData> all;
  all->SetPoints(corners);
  all->SetPolys(polys);
  truth.AddActor(all);
  relievoTest::CheckShadow(stage, 0, 0.02, "100000 glyphs", 0.05, &truth);
}

// Twice the texels, at most 2^-0.8 of the errors: there is no floor of leaks.
void TestConvergence()
{
  const auto scene = relievoTest::MakeReferenceScene("bunny");
  if (!scene.IsValid())
  {
    return;
  }
  const auto window = relievoTest::MakeWindow(1200, 1200, scene.Renderer);
  const auto truth = scene.MakeTruth();
  window->Render();
  const auto shadow =
    relievoTest::TraceShadow(*truth, truth->Trace(relievoTest::View(scene.Renderer)), scene.Light);
  vtkRelievoPass* frame = vtkRelievoPass::Attach(scene.Renderer);
  double errors[4];
  for (int i = 0; i < 4; ++i)
  {
    frame->GetShadowStage()->SetMapSize(512 << i);
    const relievoTest::Layers layers(scene.Renderer, { "shadow_0" });
    errors[i] = relievoTest::CompareShadow(shadow,
      vtkFloatArray::SafeDownCast(layers.Image->GetPointData()->GetArray("shadow_0"))
        ->GetPointer(0))
                  .Wrong();
    std::cout << "bunny, map of " << (512 << i) << ": " << 100. * errors[i] << " % wrong\n";
  }
  // The least squares' slope over the four octaves' logarithms.
  const double slope = (-1.5 * std::log2(errors[0]) - 0.5 * std::log2(errors[1]) +
                         0.5 * std::log2(errors[2]) + 1.5 * std::log2(errors[3])) /
    5.;
  RELIEVO_CHECK_AT_MOST(slope, -0.8, "bunny: exponent of the error over the map's size");
  vtkRelievoPass::Detach(scene.Renderer);
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testShadowStability)
{
  relievoTest::Session session;
  Exact = argc > 1 && std::string(argv[1]) == "exact";
  TestContacts();
  TestPlacesOfLights();
  TestWorlds();
  TestSurveys();
  if (Exact)
  {
    return session.Result();
  }
  TestPlaces();
  TestUmbra();
  TestGlyphs();
  TestConvergence();
  return session.Result();
}
}
