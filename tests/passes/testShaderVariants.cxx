// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Every kind of shader that VTK's mappers build takes the layers in: all mappers, representations
// and materials, beside each other, for every number of attachments, kind of light and way of
// drawing. A shader that does not compile is a VTK error, and so a failure; an actor that is not
// seen, too.
#include "Check.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Props.h"
#include "Session.h"
#include "Stage.h"
#include "TestCase.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkGlyph3DMapper.h>
#include <vtkLight.h>
#include <vtkMapper.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPolyDataNormals.h>
#include <vtkPolyDataTangents.h>
#include <vtkProperty.h>
#include <vtkRelievoCompositeMapper.h>
#include <vtkRelievoLayersStage.h>
#include <vtkRelievoVTKVersions.h>
#include <vtkTexture.h>
#include <vtkTriangleFilter.h>
#include <vtkUnsignedCharArray.h>
#if __has_include(<vtkOpenGLSphereMapper.h>)
#include <vtkOpenGLSphereMapper.h>
#endif
#if __has_include(<vtkOpenGLStickMapper.h>)
#include <vtkOpenGLStickMapper.h>
#endif

#include <functional>
#include <iostream>

namespace testShaderVariants
{
namespace
{
using Pass = vtkRelievoLayersStage;
using relievoTest::Layers;
using relievoTest::Stage;
using relievoTest::Way;

using Look = std::function<void(vtkProperty*)>;

vtkSmartPointer<vtkActor> FromMesh(vtkPolyData* mesh, const Look& look = nullptr)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  if (look)
  {
    look(actor->GetProperty());
  }
  return actor;
}

vtkSmartPointer<vtkPolyData> Ball()
{
  return relievoTest::MakeBall(0.4);
}

vtkSmartPointer<vtkPolyData> BareBall()
{
  auto ball = Ball();
  ball->GetPointData()->SetNormals(nullptr);
  return ball;
}

vtkSmartPointer<vtkPolyData> SmallSquare()
{
  auto square = relievoTest::MakeSquare();
  for (vtkIdType i = 0; i < 4; ++i)
  {
    double p[3];
    square->GetPoint(i, p);
    square->GetPoints()->SetPoint(i, 0.4 * p[0], 0.4 * p[1], p[2]);
  }
  return square;
}

vtkSmartPointer<vtkPolyData> Lines()
{
  auto mesh = relievoTest::MakePolygons(
    { { -0.4, -0.4, 0. }, { 0.4, 0.3, 0. }, { -0.3, 0.4, 0. }, { 0., 0., 0. } });
  mesh->SetLines(vtkNew<vtkCellArray>());
  mesh->SetVerts(vtkNew<vtkCellArray>());
  mesh->GetLines()->InsertNextCell({ 0, 1, 2 });
  mesh->GetVerts()->InsertNextCell({ 3 });
  return mesh;
}

vtkSmartPointer<vtkPolyData> WithCellNormals()
{
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(BareBall());
  normals->ComputePointNormalsOff();
  normals->ComputeCellNormalsOn();
  normals->Update();
  return normals->GetOutput();
}

vtkSmartPointer<vtkPolyData> WithTangents()
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(SmallSquare());
  vtkNew<vtkPolyDataTangents> tangents;
  tangents->SetInputConnection(triangles->GetOutputPort());
  tangents->Update();
  return tangents->GetOutput();
}

vtkSmartPointer<vtkPolyData> WithColors(bool cells)
{
  auto ball = Ball();
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < (cells ? ball->GetNumberOfCells() : ball->GetNumberOfPoints()); ++i)
  {
    colors->InsertNextTuple3(200, i % 256, 50);
  }
  (cells ? static_cast<vtkDataSetAttributes*>(ball->GetCellData()) : ball->GetPointData())
    ->SetScalars(colors);
  return ball;
}

vtkSmartPointer<vtkActor> Textured(bool holes)
{
  auto actor = FromMesh(SmallSquare());
  actor->SetTexture(relievoTest::MakeChecker(holes));
  return actor;
}

#if __has_include(<vtkOpenGLStickMapper.h>)
vtkSmartPointer<vtkActor> Sticks()
{
  auto mesh = Lines();
  vtkNew<vtkFloatArray> sizes;
  vtkNew<vtkFloatArray> axes;
  vtkNew<vtkUnsignedCharArray> colors;
  sizes->SetName("size");
  axes->SetName("axis");
  for (vtkFloatArray* array : { sizes.Get(), axes.Get() })
  {
    array->SetNumberOfComponents(3);
    mesh->GetPointData()->AddArray(array);
  }
  colors->SetNumberOfComponents(3);
  for (int i = 0; i < 4; ++i)
  {
    sizes->InsertNextTuple3(0.2, 0.1, 0.);
    axes->InsertNextTuple3(0., 1., 0.);
    colors->InsertNextTuple3(255, 0, 0);
  }
  mesh->GetPointData()->SetScalars(colors);
  vtkNew<vtkOpenGLStickMapper> mapper;
  mapper->SetInputData(mesh);
  mapper->SetScaleArray("size");
  mapper->SetOrientationArray("axis");
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}
#endif

#if __has_include(<vtkOpenGLSphereMapper.h>)
vtkSmartPointer<vtkActor> Spheres()
{
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(Lines());
  mapper->SetRadius(0.1f);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}
#endif

vtkSmartPointer<vtkActor> Glyphs(vtkPolyData* source, const Look& look = nullptr)
{
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(Lines());
  mapper->SetSourceData(source);
  mapper->SetScaleFactor(0.3);
  mapper->SetScaleModeToNoDataScaling();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  if (look)
  {
    look(actor->GetProperty());
  }
  return actor;
}

vtkSmartPointer<vtkActor> Blocks(const Look& look = nullptr)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, BareBall());
  blocks->SetBlock(1, relievoTest::Moved(WithColors(true), 0.1, 0.1, 0.2));
  vtkNew<vtkRelievoCompositeMapper> mapper;
  mapper->SetInputDataObject(blocks);
  mapper->SetBlockColor(1, 0.2, 0.4, 0.8);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  if (look)
  {
    look(actor->GetProperty());
  }
  return actor;
}

std::vector<vtkSmartPointer<vtkActor>> MakeActors()
{
  const Look flat = [](vtkProperty* p) { p->SetInterpolationToFlat(); };
  const Look unlit = [](vtkProperty* p) { p->LightingOff(); };
  const Look pbr = [](vtkProperty* p) { p->SetInterpolationToPBR(); };
  const Look coat = [](vtkProperty* p) {
    p->SetInterpolationToPBR();
    p->SetCoatStrength(0.5);
    p->SetMetallic(0.3);
  };
  const Look edges = [](vtkProperty* p) { p->EdgeVisibilityOn(); };
  const Look tubeEdges = [](vtkProperty* p) {
    p->EdgeVisibilityOn();
    p->RenderLinesAsTubesOn();
    p->SetLineWidth(3.f);
  };
  const Look vertices = [](vtkProperty* p) {
    p->VertexVisibilityOn();
    p->SetPointSize(3.f);
  };
  const Look wires = [](vtkProperty* p) { p->SetRepresentationToWireframe(); };
  const Look thickWires = [](vtkProperty* p) {
    p->SetRepresentationToWireframe();
    p->SetLineWidth(3.f);
  };
  const Look points = [](vtkProperty* p) { p->SetRepresentationToPoints(); };
  const Look spheres = [](vtkProperty* p) {
    p->RenderPointsAsSpheresOn();
    p->SetPointSize(7.f);
  };
  const Look tubes = [](vtkProperty* p) {
    p->RenderLinesAsTubesOn();
    p->SetLineWidth(5.f);
  };
  std::vector<vtkSmartPointer<vtkActor>> actors = {
    FromMesh(Ball()),
    FromMesh(BareBall()),
    FromMesh(Ball(), flat),
    FromMesh(Ball(), unlit),
    FromMesh(BareBall(), unlit),
    FromMesh(Ball(), pbr),
    FromMesh(BareBall(), pbr),
    FromMesh(WithTangents(), coat),
    FromMesh(WithCellNormals()),
    FromMesh(WithColors(false)),
    FromMesh(WithColors(true)),
    FromMesh(Ball(), edges),
    FromMesh(WithCellNormals(), tubeEdges),
    FromMesh(Ball(), vertices),
    FromMesh(Ball(), wires),
    FromMesh(BareBall(), wires),
    FromMesh(Ball(), thickWires),
    FromMesh(Ball(), points),
    FromMesh(Lines()),
    FromMesh(Lines(), spheres),
    FromMesh(Lines(), tubes),
    FromMesh(Lines(), thickWires),
    Textured(false),
    Textured(true),
#if __has_include(<vtkOpenGLSphereMapper.h>)
    Spheres(),
#endif
#if __has_include(<vtkOpenGLStickMapper.h>)
    Sticks(),
#endif
    Glyphs(Ball()),
    Glyphs(BareBall(), edges),
    Glyphs(Ball(), wires),
    Glyphs(Ball(), unlit),
    Glyphs(Lines(), spheres),
    Blocks(),
    Blocks(edges),
    Blocks(unlit),
    Blocks(pbr),
    Blocks(thickWires)
  };
  // Cut, moved off coincident others, with another back, with a texture for all of PBR.
  for (int i = 0; i < 4; ++i)
  {
    actors.push_back(FromMesh(i == 3 ? WithTangents() : Ball()));
  }
  const std::size_t last = actors.size() - 4;
  vtkNew<vtkPlane> plane;
  plane->SetNormal(1., 0., 0.);
  plane->SetOrigin(-100., 0., 0.);
  actors[last]->GetMapper()->AddClippingPlane(plane);
  actors[last]->GetProperty()->EdgeVisibilityOn();
  actors[last + 1]->GetMapper()->SetRelativeCoincidentTopologyPolygonOffsetParameters(1., 2.);
  actors[last + 2]->SetBackfaceProperty(vtkNew<vtkProperty>());
  const auto texture = relievoTest::MakeChecker(false);
  texture->UseSRGBColorSpaceOn();
  actors[last + 3]->GetProperty()->SetInterpolationToPBR();
  actors[last + 3]->GetProperty()->SetBaseColorTexture(texture);
  actors[last + 3]->GetProperty()->SetNormalTexture(relievoTest::MakeChecker(false));
  return actors;
}

struct Layout
{
  std::vector<std::string> Names;
  int NormalFormat;
};

// One, two and three attachments, and each layer on its own.
const std::vector<Layout> Layouts = {
  { { "actor" }, 0 },
  { { "actor", "depth", "normal", "geometric_normal", "albedo" }, Pass::NORMAL_FLOAT32 },
  { { "actor", "depth", "normal", "geometric_normal", "albedo" }, Pass::NORMAL_OCT16_PRECISE },
  { { "actor", "geometric_normal" }, Pass::NORMAL_FLOAT16 },
  { { "depth" }, 0 },
  { { "albedo" }, 0 },
};

void SetLight(vtkRenderer* renderer, int kind)
{
  renderer->RemoveAllLights();
  renderer->SetAutomaticLightCreation(kind == 0);
  if (kind > 0 && kind < 4)
  {
    vtkNew<vtkLight> light;
    light->SetLightTypeToSceneLight();
    light->SetPosition(1., 2., 9.);
    light->SetPositional(kind > 1);
    light->SetConeAngle(kind == 3 ? 30. : 90.);
    renderer->AddLight(light);
  }
}

void Test(const Stage& stage, const std::string& what, const Layout& layout, Way way, int actors)
{
  const Layers layers(stage.Renderer, layout.Names, way,
    [&](Pass* pass) { pass->SetNormalFormat(layout.NormalFormat); });
  for (int i = 0; i < actors && layout.Names[0] == "actor"; ++i)
  {
    RELIEVO_CHECK_THAT(layers.CountId("actor", i) > 1,
      what + ", " + layout.Names.back() + ", " + relievoTest::ToString(way) + ": actor " +
        std::to_string(i) + " is not seen");
  }
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testShaderVariants)
{
  relievoTest::Session session;
  {
    const Stage stage(200, 125);
    const relievoTest::GLCheck gl(stage.Window);
    const std::vector<vtkSmartPointer<vtkActor>> actors = MakeActors();
    const int count = static_cast<int>(actors.size());
    for (int i = 0; i < count; ++i)
    {
      actors[i]->SetPosition(i % 8, i / 8, 0.);
      stage.Renderer->AddActor(actors[i]);
    }
    vtkCamera* camera = stage.Renderer->GetActiveCamera();
    camera->SetPosition(3.5, 2., 20.);
    camera->SetFocalPoint(3.5, 2., 0.);
    camera->SetViewAngle(15.);
    const int before = vtkMapper::GetResolveCoincidentTopology();
    vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();
    camera->SetClippingRange(15., 25.);
    for (std::size_t i = 0; i < Layouts.size(); ++i)
    {
      Test(stage, "all kinds", Layouts[i], Way::Own, count);
      if (i < 3)
      {
        Test(stage, "all kinds", Layouts[i], Way::Shared, count);
      }
    }
    camera->SetClippingRange(1e-3, 1e4);
    Test(stage, "far plane at 1e7", Layouts[1], Way::Own, count);
    camera->SetClippingRange(15., 25.);
    // No light at all, a sun, a lamp, a spot.
    for (const int kind : { 4, 1, 2, 3, 0 })
    {
#ifdef RELIEVO_VTK_TUBES_NEED_LIGHT
      for (vtkActor* actor : actors)
      {
        vtkProperty* property = actor->GetProperty();
        if (property->GetEdgeVisibility() && property->GetLineWidth() > 1.f)
        {
          property->SetRenderLinesAsTubes(kind != 4);
        }
      }
#endif
      SetLight(stage.Renderer, kind);
      Test(stage, "light " + std::to_string(kind), Layouts[1], kind % 2 ? Way::Own : Way::Shared,
        count);
    }
    vtkMapper::SetResolveCoincidentTopology(before);
    std::cout << count << " kinds of actors\n";
  }
  return session.Result();
}
}
