// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Light through coloured panes: the product of the transmitted shares of red, green and blue, for
// every way of computing verdicts; without colours, nothing changes.
#include "Check.h"
#include "EmbreeScene.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Props.h"
#include "Session.h"
#include "ShadowPictures.h"
#include "ShadowScenes.h"
#include "SrgbCurve.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCompositeDataDisplayAttributes.h>
#include <vtkFloatArray.h>
#include <vtkGlyph3DMapper.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRelievoCompositeMapper.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowStage.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace testShadowColored
{
namespace
{
using relievoTest::LinearFromSrgb;
using relievoTest::Picture;
using relievoTest::ShadowStage;

vtkPolyData* GetMesh(vtkActor* actor)
{
  return vtkPolyDataMapper::SafeDownCast(actor->GetMapper())->GetInput();
}

struct Pane
{
  glm::dvec2 Low; // x and z
  glm::dvec2 High;
  double Height; // out of the picture
  double Opacity;
  glm::dvec3 Color;
};

const std::vector<Pane> Panes = { { { -1.5, -1. }, { 0.1, 1. }, 4., 0.3, { 1., 0.2, 0.1 } },
  { { -0.7, -1. }, { 0.9, 1. }, 5., 0.5, { 0.1, 0.6, 1. } },
  { { 1.2, -1. }, { 1.9, 1. }, 4.5, 0.4, { 1., 1., 1. } } };

// A white ground right below a white sun: its colour is the transmitted light.
struct PaneStage
{
  ShadowStage Stage;
  vtkSmartPointer<vtkActor> Ground;
  std::vector<vtkSmartPointer<vtkActor>> Actors;

  explicit PaneStage(const std::vector<Pane>& panes = Panes, bool always = false)
  {
    this->Ground = this->Stage.AddGround();
    this->Ground->GetProperty()->SetColor(1., 1., 1.);
    for (const Pane& pane : panes)
    {
      const auto mesh = relievoTest::MakePolygons(
        { { pane.Low.x, pane.Height, pane.Low.y }, { pane.High.x, pane.Height, pane.Low.y },
          { pane.High.x, pane.Height, pane.High.y }, { pane.Low.x, pane.Height, pane.High.y } });
      mesh->GetPolys()->InsertNextCell({ 0, 1, 2, 3 });
      this->Actors.push_back(relievoTest::AddActor(this->Stage.Renderer, mesh));
      vtkProperty* property = this->Actors.back()->GetProperty();
      property->SetOpacity(pane.Opacity);
      property->SetColor(pane.Color.r, pane.Color.g, pane.Color.b);
      if (always)
      {
        this->Stage.GetShadows()->SetPropCasts(
          this->Actors.back(), vtkRelievoShadowStage::CASTS_ALWAYS);
      }
    }
    this->Stage.AddSun(0., 5., 0.);
    this->Stage.GetShadows()->SetMethodToExact();
    this->Stage.GetShadows()->ColoredShadowsOn();
    this->Stage.GetFrame()->ShadowsOn();
  }

  // `colored`: of each colour; else the share without them.
  void Check(vtkImageData* picture, bool colored, const std::string& what) const
  {
    relievoTest::EmbreeScene ground;
    ground.AddActor(GetMesh(this->Ground));
    const auto view = ground.Trace(relievoTest::View(this->Stage.Renderer));
    long long seen[8] = {};
    long long mismatches = 0;
    double largest = 0.;
    for (std::size_t i = 0; i < view.Pixels.size(); ++i)
    {
      const glm::dvec3& p = view.Pixels[i].Position;
      if (!view.Pixels[i].Hit)
      {
        continue;
      }
      glm::dvec3 passes(1.);
      int which = 0;
      bool tie = false;
      for (std::size_t k = 0; k < Panes.size(); ++k)
      {
        const Pane& pane = Panes[k];
        const glm::dvec2 at(p.x, p.z);
        const glm::dvec2 share = (at - pane.Low) / (pane.High - pane.Low);
        const glm::dvec2 off = glm::min(glm::abs(at - pane.Low), glm::abs(at - pane.High));
        tie = tie || std::min(off.x, off.y) < 1e-5;
        if (std::min({ share.x, share.y, 1. - share.x, 1. - share.y }) > 0.)
        {
          passes *= (1. - pane.Opacity) * (colored ? pane.Color : glm::dvec3(1.));
          which |= 1 << k;
        }
      }
      ++seen[which];
      for (int channel = 0; channel < 3 && !tie; ++channel)
      {
        const double shown =
          picture->GetPointData()->GetScalars()->GetComponent(static_cast<vtkIdType>(i), channel);
        const double off = std::abs(shown / 255. - passes[channel]);
        largest = std::max(largest, off);
        mismatches += off > 1.1 / 255. ? 1 : 0; // a verdict's steps, and the picture's
      }
    }
    RELIEVO_CHECK_THAT(
      seen[0] > 300 && seen[1] > 300 && seen[2] > 300 && seen[3] > 300 && seen[4] > 100,
      what + ": too little is seen");
    RELIEVO_CHECK_AT_MOST(mismatches, 0,
      what + ": channels that pass another share, up to " + std::to_string(255. * largest));
  }
};

void TestProduct()
{
  PaneStage panes;
  const relievoTest::GLCheck gl(panes.Stage.Window);
  panes.Check(Picture(panes.Stage.Window), true, "each fragment's own rays");
  panes.Stage.Window->Render();
  panes.Check(Picture(panes.Stage.Window), true, "found for each pixel");
  // Culled surfaces are not found for each pixel.
  panes.Ground->GetProperty()->BackfaceCullingOn();
  panes.Stage.Window->Render();
  panes.Check(Picture(panes.Stage.Window), true, "not found for each pixel");
  panes.Ground->GetProperty()->BackfaceCullingOff();
  panes.Stage.GetShadows()->SetStrength(0.);
  const auto none = Picture(panes.Stage.Window);
  panes.Stage.GetShadows()->SetStrength(1.);
  panes.Stage.GetShadows()->SetPropReceives(panes.Ground, false);
  RELIEVO_CHECK(relievoTest::CountUnlike(Picture(panes.Stage.Window), none) == 0);
}

// The order of panes does not matter: neither their heights nor that of the actors.
void TestOrder()
{
  std::vector<Pane> turned(Panes.rbegin(), Panes.rend());
  PaneStage panes(turned);
  panes.Check(Picture(panes.Stage.Window), true, "turned round");
  std::swap(turned[1].Height, turned[2].Height);
  PaneStage swapped(turned);
  RELIEVO_CHECK(relievoTest::SamePicture(
    Picture(panes.Stage.Window), Picture(swapped.Stage.Window), "heights swapped"));
}

// Off, the picture has no colours of panes; and the layer never has.
void TestOff()
{
  PaneStage panes(Panes, true);
  const auto layer = relievoTest::CaptureShadow(panes.Stage, 0);
  panes.Stage.GetFrame()->ShadowsOn();
  panes.Stage.GetShadows()->ColoredShadowsOff();
  const auto off = Picture(panes.Stage.Window);
  panes.Check(off, false, "off");
  const auto plain = relievoTest::CaptureShadow(panes.Stage, 0);
  const auto* a = vtkFloatArray::SafeDownCast(layer->GetPointData()->GetArray("shadow_0"));
  const auto* b = vtkFloatArray::SafeDownCast(plain->GetPointData()->GetArray("shadow_0"));
  long long unlike = 0;
  for (vtkIdType i = 0; i < a->GetNumberOfValues(); ++i)
  {
    unlike += a->GetValue(i) != b->GetValue(i) ? 1 : 0;
  }
  RELIEVO_CHECK_AT_MOST(unlike, 0, "the layer with colours: pixels unlike it without");
  // White panes, and colours that an array gives: nothing to colour by.
  PaneStage white(Panes, true);
  for (std::size_t i = 0; i < white.Actors.size(); ++i)
  {
    vtkNew<vtkFloatArray> values;
    values->InsertNextValue(0.5f);
    i % 2 == 0 ? white.Actors[i]->GetProperty()->SetColor(1., 1., 1.)
               : static_cast<void>(GetMesh(white.Actors[i])->GetCellData()->SetScalars(values));
  }
  white.Check(Picture(white.Stage.Window), false, "without a colour of their own");
  RELIEVO_CHECK(
    white.Stage.GetShadows()->GetBytesHeld() < panes.Stage.GetShadows()->GetBytesHeld() + 1);
}

// OpenGL memory: 12 bytes a pixel for the colours.
void TestMemory()
{
  PaneStage panes(Panes, true);
  panes.Stage.Window->Render();
  const auto with = relievoTest::CountGLObjects(panes.Stage.Window).Bytes;
  panes.Stage.GetShadows()->ColoredShadowsOff();
  panes.Stage.Window->Render();
  const auto without = relievoTest::CountGLObjects(panes.Stage.Window).Bytes;
  const int* size = panes.Stage.Window->GetSize();
  RELIEVO_CHECK(with - without == 12LL * size[0] * size[1]);
}

// Maps store no colours: translucent props cast as without them.
void TestMaps()
{
  for (const int method : { vtkRelievoShadowStage::METHOD_MAP,
         vtkRelievoShadowStage::METHOD_FORWARD, vtkRelievoShadowStage::METHOD_WARPED })
  {
    PaneStage panes;
    panes.Stage.AddBox({ 1., 0.5, 0.4 }, { 0.4, 0.4, 0.4 });
    panes.Stage.GetShadows()->SetMethod(method);
    const auto on = Picture(panes.Stage.Window);
    panes.Stage.GetShadows()->ColoredShadowsOff();
    RELIEVO_CHECK(relievoTest::SamePicture(
      Picture(panes.Stage.Window), on, "method " + std::to_string(method)));
  }
  // Nor do the planner's choices change the picture.
  PaneStage panes;
  panes.Stage.GetShadows()->SetMethodToMap();
  panes.Stage.GetShadows()->SetTolerance(0.5);
  panes.Check(Picture(panes.Stage.Window), true, "with a tolerance");
}

// Surfaces that would be lit later are lit at once.
void TestDeferred()
{
  PaneStage panes;
  panes.Stage.GetFrame()->DeferredOn();
  panes.Check(Picture(panes.Stage.Window), true, "deferred");
  RELIEVO_CHECK_THAT(
    panes.Stage.GetFrame()->GetFrameReport().find("colour the light") != std::string::npos,
    panes.Stage.GetFrame()->GetFrameReport());
}

// Invisible props do not colour the light.
void TestFaded()
{
  std::vector<Pane> more = Panes;
  more.push_back({ { -1., -1. }, { 1.5, 1. }, 4.2, 0., { 1., 0., 0. } });
  PaneStage panes(more);
  panes.Check(Picture(panes.Stage.Window), true, "one that is faded out");
}

// A block's colour wins over its scalars; glyphs have VTK's one colour of all kinds of light.
void TestKinds()
{
  PaneStage panes;
  vtkNew<vtkMultiBlockDataSet> blocks;
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  vtkNew<vtkRelievoCompositeMapper> mapper;
  mapper->SetCompositeDataDisplayAttributes(attributes);
  for (unsigned int i = 0; i < 2; ++i)
  {
    vtkPolyData* mesh = GetMesh(panes.Actors[i]);
    vtkNew<vtkFloatArray> values;
    values->InsertNextValue(0.5f);
    mesh->GetCellData()->SetScalars(values);
    blocks->SetBlock(i, mesh);
    attributes->SetBlockColor(mesh, &Panes[i].Color.x);
    attributes->SetBlockOpacity(mesh, Panes[i].Opacity);
    panes.Actors[i]->VisibilityOff();
  }
  mapper->SetInputDataObject(blocks);
  vtkNew<vtkActor> composite;
  composite->SetMapper(mapper);
  panes.Stage.Renderer->AddActor(composite);
  panes.Check(Picture(panes.Stage.Window), true, "blocks");

  PaneStage glyphs;
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0., 0., 0.);
  data->SetPoints(points);
  vtkNew<vtkGlyph3DMapper> placed;
  placed->SetInputData(data);
  placed->SetSourceData(GetMesh(glyphs.Actors[0]));
  vtkProperty* property = glyphs.Actors[0]->GetProperty();
  property->SetAmbient(0.25);
  property->SetDiffuse(0.75);
  property->SetAmbientColor(1., 0.5, 0.4);
  property->SetDiffuseColor(1., 0.1, 0.);
  glyphs.Actors[0]->SetMapper(placed);
  glyphs.Check(Picture(glyphs.Stage.Window), true, "glyphs");
}

// Opacities of an array count where they are one for all; otherwise the pane casts nothing.
void TestArrays()
{
  constexpr double Alpha = 204. / 255.;
  PaneStage panes;
  for (std::size_t i = 0; i < Panes.size(); ++i)
  {
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetNumberOfComponents(4);
    colors->InsertNextTuple4(255., 255., 255., 255. * Alpha);
    GetMesh(panes.Actors[i])->GetCellData()->SetScalars(colors);
    panes.Actors[i]->GetProperty()->SetOpacity(Panes[i].Opacity / Alpha);
  }
  panes.Check(Picture(panes.Stage.Window), false, "opacities of arrays");
  vtkPolyData* mesh = GetMesh(panes.Actors[0]);
  mesh->GetCellData()->SetScalars(nullptr);
  vtkNew<vtkUnsignedCharArray> varied;
  varied->SetNumberOfComponents(4);
  for (int corner = 0; corner < 4; ++corner)
  {
    varied->InsertNextTuple4(255., 255., 255., 60. * corner);
  }
  mesh->GetPointData()->SetScalars(varied);
  const auto shown = Picture(panes.Stage.Window);
  panes.Stage.GetShadows()->SetPropCasts(panes.Actors[0], vtkRelievoShadowStage::CASTS_NEVER);
  RELIEVO_CHECK(
    relievoTest::SamePicture(Picture(panes.Stage.Window), shown, "opacities that vary"));
}

// Soft: the mean of coloured samples, each with the sun elsewhere, fades where a pane's edge does.
void TestSoft()
{
  constexpr double Angle = 8.;
  PaneStage panes({ { { -1.5, -30. }, { 0.1, 30. }, 4., 0.3, { 1., 0.2, 0.1 } } });
  panes.Stage.GetShadows()->SetSunAngle(Angle);
  panes.Stage.GetShadows()->SetSoftSamples(64);
  panes.Stage.GetShadows()->SoftAtOnceOn();
  const auto picture = Picture(panes.Stage.Window);
  relievoTest::EmbreeScene ground;
  ground.AddActor(GetMesh(panes.Ground));
  const auto view = ground.Trace(relievoTest::View(panes.Stage.Renderer));
  const double reach = 4. * std::tan(Angle / 360. * vtkMath::Pi());
  // The area of a disc on one side of a line at a distance.
  const auto beyond = [reach](double x) {
    const double h = glm::clamp(x / reach, -1., 1.);
    return 0.5 + (h * std::sqrt(1. - h * h) + std::asin(h)) / vtkMath::Pi();
  };
  double largest = 0.;
  long long between = 0;
  for (std::size_t i = 0; i < view.Pixels.size(); ++i)
  {
    if (!view.Pixels[i].Hit)
    {
      continue;
    }
    const double x = view.Pixels[i].Position.x;
    const double share = beyond(x + 1.5) - beyond(x - 0.1);
    between += share > 0.2 && share < 0.8 ? 1 : 0;
    for (int channel = 0; channel < 3; ++channel)
    {
      const double passes =
        1. - share * (1. - LinearFromSrgb(0.7 * glm::dvec3(1., 0.2, 0.1)[channel]));
      const double shown =
        picture->GetPointData()->GetScalars()->GetComponent(static_cast<vtkIdType>(i), channel);
      largest = std::max(largest, std::abs(LinearFromSrgb(shown / 255.) - passes));
    }
  }
  RELIEVO_CHECK(between > 300);
  RELIEVO_CHECK_AT_MOST(largest, 0.08, "soft: share of a channel");
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testShadowColored)
{
  relievoTest::Session session;
  TestProduct();
  TestOrder();
  TestOff();
  TestMemory();
  TestMaps();
  TestDeferred();
  TestFaded();
  TestKinds();
  TestArrays();
  TestSoft();
  return session.Result();
}
}
