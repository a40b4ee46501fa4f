// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The albedo is the colour without the light: of the actor, of its points, cells and textures, for
// every kind of shading.
#include "AnalyticScene.h"
#include "Check.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Props.h"
#include "Session.h"
#include "Stage.h"
#include "TestCase.h"

#include <vtkActor.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkLookupTable.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTexture.h>
#include <vtkUnsignedCharArray.h>

#include <functional>

namespace testLayersAlbedo
{
namespace
{
using relievoTest::Layers;
using relievoTest::MakeChecker;
using relievoTest::PixelTruth;
using relievoTest::Stage;
using relievoTest::TruthImage;
using relievoTest::View;
using relievoTest::Way;

struct Material
{
  const char* Name;
  std::function<void(vtkActor*)> Set;
  // Expected colour at a place of the square, parity of the checkerboard given.
  std::function<glm::dvec3(const glm::dvec3&, int)> Color;
};

vtkPolyData* GetMesh(vtkActor* actor)
{
  return static_cast<vtkPolyDataMapper*>(actor->GetMapper())->GetInput();
}

glm::dvec3 Checker(int parity)
{
  return parity == 0 ? glm::dvec3(255., 128., 0.) : glm::dvec3(0., 128., 255.);
}

void SetVertexColors(vtkActor* actor)
{
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  const unsigned char corners[4][3] = { { 0, 0, 40 }, { 200, 0, 40 }, { 0, 100, 40 },
    { 200, 100, 40 } };
  for (const auto& corner : corners)
  {
    colors->InsertNextTypedTuple(corner);
  }
  GetMesh(actor)->GetPointData()->SetScalars(colors);
}

glm::dvec3 VertexColor(const glm::dvec3& p)
{
  return { 100. * (p.x + 1.), 50. * (p.y + 1.), 40. };
}

void SetMappedScalars(vtkActor* actor, bool cells)
{
  vtkNew<vtkDoubleArray> values;
  for (int i = 0; i < (cells ? 1 : 4); ++i)
  {
    values->InsertNextValue(cells ? 0.5 : i % 2);
  }
  (cells ? static_cast<vtkDataSetAttributes*>(GetMesh(actor)->GetCellData())
         : GetMesh(actor)->GetPointData())
    ->SetScalars(values);
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(2);
  table->SetTableValue(0, 0.2, 0.4, 0.6);
  table->SetTableValue(1, 0.8, 1., 0.);
  actor->GetMapper()->SetLookupTable(table);
  actor->GetMapper()->SetScalarRange(0., 1.);
  actor->GetMapper()->SetInterpolateScalarsBeforeMapping(!cells);
}

const Material Materials[] = {
  { "colour", [](vtkActor* a) { a->GetProperty()->SetColor(0.2, 0.6, 1.); },
    [](const glm::dvec3&, int) { return glm::dvec3(51., 153., 255.); } },
  { "half diffuse, some ambient",
    [](vtkActor* a) {
      a->GetProperty()->SetColor(0.2, 0.6, 1.);
      a->GetProperty()->SetDiffuse(0.5);
      a->GetProperty()->SetAmbient(0.3);
      a->GetProperty()->SetAmbientColor(1., 0., 0.);
    },
    [](const glm::dvec3&, int) { return glm::dvec3(51., 153., 255.); } },
  { "ambient only",
    [](vtkActor* a) {
      a->GetProperty()->SetColor(0.2, 0.6, 1.);
      a->GetProperty()->SetDiffuse(0.);
      a->GetProperty()->SetAmbient(0.7);
    },
    [](const glm::dvec3&, int) { return glm::dvec3(51., 153., 255.); } },
  { "unlit",
    [](vtkActor* a) {
      a->GetProperty()->SetColor(0.2, 0.6, 1.);
      a->GetProperty()->LightingOff();
    },
    [](const glm::dvec3&, int) { return glm::dvec3(51., 153., 255.); } },
  { "PBR",
    [](vtkActor* a) {
      a->GetProperty()->SetColor(0.2, 0.6, 1.);
      a->GetProperty()->SetInterpolationToPBR();
      a->GetProperty()->SetMetallic(0.5);
    },
    [](const glm::dvec3&, int) { return glm::dvec3(51., 153., 255.); } },
  { "PBR with a texture",
    [](vtkActor* a) {
      a->GetProperty()->SetInterpolationToPBR();
      const auto texture = MakeChecker(false);
      texture->UseSRGBColorSpaceOn();
      a->GetProperty()->SetBaseColorTexture(texture);
    },
    // Linear, as VTK reads such textures: 0.5 is 0.2158.
    [](const glm::dvec3&, int parity) {
      glm::dvec3 color = Checker(parity);
      color.y = 255. * 0.2158;
      return color;
    } },
  { "texture and colour",
    [](vtkActor* a) {
      a->SetTexture(MakeChecker(false));
      a->GetProperty()->SetColor(1., 0.5, 0.4);
    },
    [](const glm::dvec3&, int parity) { return Checker(parity) * glm::dvec3(1., 0.5, 0.4); } },
  { "vertex colours", SetVertexColors, [](const glm::dvec3& p, int) { return VertexColor(p); } },
  { "vertex colours and texture",
    [](vtkActor* a) {
      SetVertexColors(a);
      a->SetTexture(MakeChecker(false));
    },
    [](const glm::dvec3& p, int parity) { return VertexColor(p) * Checker(parity) / 255.; } },
  { "cell scalars", [](vtkActor* a) { SetMappedScalars(a, true); },
    [](const glm::dvec3&, int) { return glm::dvec3(204., 255., 0.); } },
  { "point scalars", [](vtkActor* a) { SetMappedScalars(a, false); },
    [](const glm::dvec3& p, int) {
      return p.x < 0. ? glm::dvec3(51., 102., 153.) : glm::dvec3(204., 255., 0.);
    } },
  { "back side",
    [](vtkActor* a) {
      vtkNew<vtkProperty> back;
      back->SetColor(0.2, 0.6, 1.);
      back->SetDiffuse(0.6);
      a->SetBackfaceProperty(back);
      a->RotateY(180.);
    },
    [](const glm::dvec3&, int) { return glm::dvec3(51., 153., 255.); } },
};

void TestAlbedo(const Material& material)
{
  const Stage stage(120, 100);
  const auto square = relievoTest::AddActor(stage.Renderer, relievoTest::MakeSquare());
  square->SetPosition(0., 0.5, 0.);
  material.Set(square);
  const glm::dmat4 place = relievoTest::AnalyticScene::ToMatrix(square->GetMatrix()->GetData());
  relievoTest::AnalyticScene scene;
  scene.AddPlane(1., 1., place);
  const glm::dmat4 toSquare = glm::inverse(place);
  const TruthImage truth = scene.Trace(View(stage.Renderer));
  const relievoTest::GLCheck gl(stage.Window);
  for (const Way way : relievoTest::BothWays)
  {
    const Layers layers(stage.Renderer, { "depth", "albedo" }, way);
    double worst = 0.;
    long long compared = 0;
    for (int y = 0; y < truth.Height; ++y)
    {
      for (int x = 0; x < truth.Width; ++x)
      {
        const PixelTruth& pixel = truth.At(x, y);
        const glm::dvec3 local(toSquare * glm::dvec4(pixel.Position, 1.));
        const int parity = relievoTest::GetCheckerParity(local);
        if (pixel.Inner && pixel.Hit && parity >= 0)
        {
          ++compared;
          const glm::dvec3 off = layers.Vector("albedo", x, y) - material.Color(local, parity);
          worst = std::max({ worst, std::abs(off.x), std::abs(off.y), std::abs(off.z),
            255. - layers.Value("albedo", x, y, 3) });
        }
        else if (pixel.Inner && !pixel.Hit)
        {
          worst = std::max(worst, layers.Value("albedo", x, y, 3));
        }
      }
    }
    const std::string name =
      std::string("albedo, ") + material.Name + ", " + relievoTest::ToString(way);
    RELIEVO_CHECK_THAT(compared > 300, name + ": too little is seen");
    RELIEVO_CHECK_AT_MOST(worst, 1.01, name + ": largest difference, of 255");
  }
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testLayersAlbedo)
{
  relievoTest::Session session;
  for (const Material& material : Materials)
  {
    TestAlbedo(material);
  }
  return session.Result();
}
}
