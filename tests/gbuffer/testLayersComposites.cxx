// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Who is seen where, for props that are made of parts: blocks of composite data, parts of
// assemblies, levels of detail, shared mappers, surfaces of other data sets.
#include "Check.h"
#include "EmbreeScene.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Props.h"
#include "Session.h"
#include "Stage.h"
#include "TestCase.h"

#include <vtkActorCollection.h>
#include <vtkAssembly.h>
#include <vtkCellData.h>
#include <vtkCompositeDataDisplayAttributes.h>
#include <vtkDataSetMapper.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkImageActor.h>
#include <vtkImageData.h>
#include <vtkLODProp3D.h>
#include <vtkMatrix4x4.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRelievoCompositeMapper.h>
#include <vtkRelievoPass.h>
#include <vtkUnstructuredGrid.h>

namespace testLayersComposites
{
namespace
{
// Draws through an actor of its own, as VTK's and ParaView's actors with levels of detail do.
class DeviceActor : public vtkActor
{
public:
  static DeviceActor* New();
  vtkTypeMacro(DeviceActor, vtkActor);

  void Render(vtkRenderer* renderer, vtkMapper* mapper) override
  {
    this->Device->SetProperty(this->GetProperty());
    this->Device->SetUserMatrix(this->GetMatrix());
    this->Device->SetPropertyKeys(this->GetPropertyKeys());
    this->Device->SetMapper(mapper);
    this->Device->Render(renderer, mapper);
  }

  void ReleaseGraphicsResources(vtkWindow* window) override
  {
    this->Device->ReleaseGraphicsResources(window);
    this->Superclass::ReleaseGraphicsResources(window);
  }

private:
  vtkNew<vtkActor> Device;
};
vtkStandardNewMacro(DeviceActor);

using relievoTest::AddActor;
using relievoTest::EmbreeScene;
using relievoTest::Layers;
using relievoTest::MakeBall;
using relievoTest::MakeBox;
using relievoTest::Moved;
using relievoTest::PixelTruth;
using relievoTest::Stage;
using relievoTest::TruthImage;
using relievoTest::View;
using relievoTest::Way;

const std::vector<std::string> Names = { "depth", "actor", "block", "cell", "albedo" };

// The expected values where the truth's actor of this number is visible.
struct Part
{
  int Actor;
  int Block;
  int Color[3];
};

void CheckParts(const std::string& what, vtkRenderer* renderer, const EmbreeScene& scene,
  const std::vector<Part>& parts)
{
  const TruthImage truth = scene.Trace(View(renderer));
  for (const Way way : relievoTest::BothWays)
  {
    const Layers layers(renderer, Names, way);
    std::vector<long long> seen(parts.size(), 0);
    long long mismatches[5] = { 0, 0, 0, 0, 0 };
    double depth = 0.;
    for (int y = 0; y < truth.Height; ++y)
    {
      for (int x = 0; x < truth.Width; ++x)
      {
        const PixelTruth& pixel = truth.At(x, y);
        if (!pixel.Inner || (pixel.Hit && pixel.EdgeDistance < 0.01))
        {
          continue;
        }
        const Part part = pixel.Hit ? parts[pixel.Actor] : Part{ -1, -1, { 0, 0, 0 } };
        seen[pixel.Hit ? pixel.Actor : 0] += pixel.Hit ? 1 : 0;
        mismatches[0] += layers.Id("actor", x, y) != part.Actor ? 1 : 0;
        mismatches[1] += layers.Id("block", x, y) != part.Block ? 1 : 0;
        mismatches[2] += layers.Id("cell", x, y) != (pixel.Hit ? pixel.Cell : -1) ? 1 : 0;
        bool same = true;
        for (int c = 0; c < 3; ++c)
        {
          same = same && std::abs(layers.Value("albedo", x, y, c) - part.Color[c]) <= 1.;
        }
        mismatches[3] += same ? 0 : 1;
        if (pixel.Hit)
        {
          depth =
            std::max(depth, std::abs(layers.Value("depth", x, y) - pixel.Depth) / pixel.Depth);
        }
      }
    }
    const std::string name = what + ", " + relievoTest::ToString(way);
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      RELIEVO_CHECK_THAT(seen[i] > 50, name + ": part " + std::to_string(i) + " is hardly seen");
    }
    RELIEVO_CHECK_AT_MOST(depth, 1e-6, name + ": depth");
    RELIEVO_CHECK_AT_MOST(mismatches[0], 0, name + ": pixels with another actor");
    RELIEVO_CHECK_AT_MOST(mismatches[1], 0, name + ": pixels with another block");
    RELIEVO_CHECK_AT_MOST(mismatches[2], 0, name + ": pixels with another cell");
    RELIEVO_CHECK_AT_MOST(mismatches[3], 0, name + ": pixels with another albedo");
  }
}

// Blocks nested, empty, with and without normals, of their own colour, and hidden.
void TestBlocks()
{
  const Stage stage(240, 180);
  const relievoTest::GLCheck gl(stage.Window);
  AddActor(stage.Renderer, Moved(MakeBall(0.3), 1.5, 0.4, 0.))->GetProperty()->SetColor(1., 1., 0.);
  const auto left = Moved(MakeBox(0.7, 0.7, 0.7), -1.6, 0.5, 0.);
  const auto ball = Moved(MakeBall(0.5), -0.4, 0.5, 0.);
  const auto right = Moved(MakeBox(0.6, 0.8, 0.6), 0.7, 0.5, 0.);
  right->GetPointData()->SetNormals(nullptr);
  const auto hidden = Moved(MakeBox(0.5, 0.5, 0.5), 0.6, 0.3, 1.2);
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(0, ball);
  inner->SetBlock(1, nullptr);
  inner->SetBlock(2, right);
  vtkNew<vtkMultiBlockDataSet> root;
  root->SetBlock(0, left);
  root->SetBlock(1, inner);
  root->SetBlock(2, hidden);
  // Flat indices: root 0, left 1, inner 2, ball 3, nothing 4, right 5, hidden 6.
  vtkNew<vtkRelievoCompositeMapper> mapper;
  mapper->SetInputDataObject(root);
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  mapper->SetCompositeDataDisplayAttributes(attributes);
  mapper->SetBlockColor(3, 0.2, 0.4, 0.6);
  mapper->SetBlockVisibility(6, false);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(1., 0.5, 0.25);
  stage.Renderer->AddActor(actor);

  EmbreeScene scene;
  scene.AddActor(Moved(MakeBall(0.3), 1.5, 0.4, 0.));
  scene.AddActor(left);
  scene.AddActor(ball);
  scene.AddActor(right);
  std::vector<Part> parts = { { 0, 0, { 255, 255, 0 } }, { 1, 1, { 255, 128, 64 } },
    { 1, 3, { 51, 102, 153 } }, { 1, 5, { 255, 128, 64 } } };
  CheckParts("blocks", stage.Renderer, scene, parts);

  // Another colour, another one hidden: nothing of the frame before stays.
  mapper->SetBlockVisibility(6, true);
  mapper->SetBlockVisibility(1, false);
  mapper->SetBlockColor(5, 1., 0., 1.);
  EmbreeScene changed;
  changed.AddActor(Moved(MakeBall(0.3), 1.5, 0.4, 0.));
  changed.AddActor(hidden);
  changed.AddActor(ball);
  changed.AddActor(right);
  parts[1] = { 1, 6, { 255, 128, 64 } };
  parts[3] = { 1, 5, { 255, 0, 255 } };
  CheckParts("blocks changed", stage.Renderer, changed, parts);
}

// The parts of an assembly within an assembly stand where both matrices put them.
void TestAssembly()
{
  const Stage stage(240, 180);
  const auto box = MakeBox(0.8, 0.8, 0.8);
  const auto ball = MakeBall(0.5);
  AddActor(stage.Renderer, ball)->SetPosition(2.2, 0.5, 0.);
  vtkNew<vtkAssembly> outer;
  vtkNew<vtkAssembly> inner;
  vtkSmartPointer<vtkActor> actors[2];
  for (int i = 0; i < 2; ++i)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(i == 0 ? box : ball);
    actors[i] = vtkSmartPointer<vtkActor>::New();
    actors[i]->SetMapper(mapper);
    actors[i]->SetPosition(i == 0 ? -0.7 : 0.7, 0., 0.);
    actors[i]->GetProperty()->SetColor(0., i, 1.);
    (i == 0 ? outer : inner)->AddPart(actors[i]);
  }
  inner->SetScale(1., 1.3, 0.7);
  inner->SetOrientation(0., 20., 30.);
  outer->AddPart(inner);
  outer->SetPosition(-0.6, 0.6, 0.2);
  outer->SetOrientation(15., 30., 0.);
  stage.Renderer->AddActor(outer);

  EmbreeScene scene;
  vtkNew<vtkMatrix4x4> place;
  place->SetElement(0, 3, 2.2);
  place->SetElement(1, 3, 0.5);
  scene.AddActor(ball, place);
  vtkMatrix4x4::Multiply4x4(outer->GetMatrix(), actors[0]->GetMatrix(), place);
  scene.AddActor(box, place);
  vtkMatrix4x4::Multiply4x4(outer->GetMatrix(), inner->GetMatrix(), place);
  vtkMatrix4x4::Multiply4x4(place, actors[1]->GetMatrix(), place);
  scene.AddActor(ball, place);

  vtkActorCollection* all = stage.Renderer->GetActors();
  std::vector<Part> parts = { { 0, 0, { 255, 255, 255 } } };
  for (int i = 0; i < 2; ++i)
  {
    // IsItemPresent counts from 1.
    parts.push_back({ all->IsItemPresent(actors[i]) - 1, 0, { 0, 255 * i, 255 } });
    RELIEVO_CHECK(parts.back().Actor >= 0);
  }
  CheckParts("assembly", stage.Renderer, scene, parts);
}

// One mesh under two actors, one mapper under two actors, and an actor that is not seen between.
void TestShared()
{
  const Stage stage(240, 180);
  const auto box = MakeBox(0.8, 0.8, 0.8);
  const auto first = AddActor(stage.Renderer, box);
  const auto unseen = AddActor(stage.Renderer, MakeBall(1.));
  const auto second = AddActor(stage.Renderer, box);
  const auto third = AddActor(stage.Renderer, box);
  third->SetMapper(second->GetMapper());
  unseen->VisibilityOff();
  first->SetPosition(-1.3, 0.5, 0.);
  second->SetPosition(0.1, 0.5, 0.);
  third->SetPosition(1.5, 0.5, 0.);
  third->SetScale(-1., 1., 1.2);
  third->GetProperty()->SetColor(0., 1., 0.);
  EmbreeScene scene;
  scene.AddActors(stage.Renderer);
  CheckParts("shared mesh and mapper", stage.Renderer, scene,
    { { 0, 0, { 255, 255, 255 } }, { 2, 0, { 255, 255, 255 } }, { 3, 0, { 0, 255, 0 } } });
}

void TestLevelOfDetail(bool device)
{
  const Stage stage(240, 180);
  AddActor(stage.Renderer, MakeBox(0.8, 0.8, 0.8))->SetPosition(-1.3, 0.5, 0.);
  const auto ball = MakeBall(0.6);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(ball);
  vtkNew<DeviceActor> actor;
  actor->SetMapper(mapper);
  actor->SetPosition(0.6, 0.5, 0.);
  actor->GetProperty()->SetColor(0., 0., 1.);
  vtkNew<vtkLODProp3D> levels;
  levels->AddLOD(mapper, actor->GetProperty(), 0.);
  levels->SetPosition(0.6, 0.5, 0.);
  stage.Renderer->AddViewProp(device ? static_cast<vtkProp*>(actor) : levels);
  EmbreeScene scene;
  vtkNew<vtkMatrix4x4> place;
  place->SetElement(0, 3, -1.3);
  place->SetElement(1, 3, 0.5);
  scene.AddActor(MakeBox(0.8, 0.8, 0.8), place);
  place->SetElement(0, 3, 0.6);
  scene.AddActor(ball, place);
  CheckParts(device ? "device actor" : "level of detail", stage.Renderer, scene,
    { { 0, 0, { 255, 255, 255 } }, { 1, 0, { 0, 0, 255 } } });
}

// A part that cannot write layers is left out of them; the meshes of its assembly are in.
void TestForeignPart()
{
  const Stage stage(240, 180);
  const auto box = AddActor(stage.Renderer, MakeBox(0.8, 0.8, 0.8));
  box->SetPosition(-1.3, 0.5, 0.);
  vtkNew<vtkImageData> image;
  image->SetDimensions(8, 8, 1);
  image->SetSpacing(0.2, 0.2, 1.);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  vtkNew<vtkImageActor> slice;
  slice->SetInputData(image);
  vtkNew<vtkAssembly> assembly;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(MakeBall(0.3));
  vtkNew<vtkActor> ball;
  ball->SetMapper(mapper);
  assembly->AddPart(ball);
  assembly->AddPart(slice);
  stage.Renderer->AddActor(assembly);
  const Layers alone(stage.Renderer, Names);
  vtkRelievoPass* frame = vtkRelievoPass::Attach(stage.Renderer);
  for (const std::string& name : Names)
  {
    frame->RequestLayer(name);
  }
  stage.Window->Render();
  vtkNew<vtkImageData> read;
  for (const std::string& name : Names)
  {
    RELIEVO_CHECK(frame->ReadLayer(name, read));
  }
  RELIEVO_CHECK_THAT(frame->GetFrameReport().find("vtkImageActor") != std::string::npos,
    "the report does not name the foreign part: " + frame->GetFrameReport());
  const Layers beside(read);
  RELIEVO_CHECK(beside.CountId("actor", 0) > 500);
  RELIEVO_CHECK(beside.CountId("actor", 1) > 200);
  RELIEVO_CHECK(beside.CountId("actor", 0) + beside.CountId("actor", 1) == beside.Covered());
  for (const std::string& name : Names)
  {
    RELIEVO_CHECK_AT_MOST(
      relievoTest::CountDifferent(alone, beside, name), 0, "foreign part: pixels of " + name);
  }
}

// The surface of an unstructured grid: cells are the surface's, cell arrays are the grid's.
void TestDataSetMapper()
{
  const Stage stage(240, 180);
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 12; ++i)
  {
    points->InsertNextPoint(0.9 * (i % 3) - 0.9, 0.8 * (i / 3 % 2), 0.8 * (i / 6));
  }
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(points);
  for (vtkIdType i = 0; i < 2; ++i)
  {
    const vtkIdType corners[8] = { i, i + 1, i + 4, i + 3, i + 6, i + 7, i + 10, i + 9 };
    grid->InsertNextCell(VTK_HEXAHEDRON, 8, corners);
  }
  vtkNew<vtkDoubleArray> ids;
  ids->SetName("grid cell");
  ids->InsertNextValue(0.);
  ids->InsertNextValue(1.);
  grid->GetCellData()->AddArray(ids);
  vtkNew<vtkDataSetMapper> mapper;
  mapper->SetInputData(grid);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  stage.Renderer->AddActor(actor);
  // The surface is VTK's, whose filter for it depends on the version.
  stage.Window->Render();
  EmbreeScene scene;
  scene.AddActor(mapper->GetPolyDataMapper()->GetInput());
  CheckParts("data set mapper", stage.Renderer, scene, { { 0, 0, { 255, 255, 255 } } });

  const Layers layers(stage.Renderer, { "position", "actor", "grid cell" });
  long long mismatches = 0;
  for (int y = 0; y < layers.Height; ++y)
  {
    for (int x = 0; x < layers.Width; ++x)
    {
      const double across = layers.Value("position", x, y, 0);
      if (layers.Id("actor", x, y) == 0 && std::abs(across) > 0.01)
      {
        mismatches += layers.Value("grid cell", x, y) != (across > 0. ? 1. : 0.) ? 1 : 0;
      }
    }
  }
  RELIEVO_CHECK_AT_MOST(mismatches, 0, "data set mapper: pixels with another cell of the grid");
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testLayersComposites)
{
  relievoTest::Session session;
  TestBlocks();
  TestAssembly();
  TestShared();
  TestLevelOfDetail(true);
  TestLevelOfDetail(false);
  TestForeignPart();
  TestDataSetMapper();
  return session.Result();
}
}
