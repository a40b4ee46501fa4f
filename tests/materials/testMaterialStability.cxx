// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Materials where they fail: bad meshes, bad maps, grazing views, cameras inside the relief,
// blocks, several actors and windows, toggles.
#include "Check.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Props.h"
#include "ReliefTruth.h"
#include "Session.h"
#include "Stage.h"
#include "TestCase.h"

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkLight.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRelievoCompositeMapper.h>
#include <vtkRelievoMaterial.h>
#include <vtkRelievoPass.h>
#include <vtkShortArray.h>
#include <vtkTextureObject.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <limits>

namespace testMaterialStability
{
namespace
{
using namespace relievoTest;

constexpr int Width = 240;
constexpr int Height = 160;

struct Scene
{
  relievoTest::Stage Stage{ Width, Height };
  vtkSmartPointer<vtkPolyData> Mesh = ReliefPlane(4);
  vtkSmartPointer<vtkActor> Actor = AddActor(this->Stage.Renderer, this->Mesh);
  vtkNew<vtkRelievoMaterial> Material;
  GLCheck Watch{ this->Stage.Window };

  Scene()
  {
    this->Look(50.);
    this->Material->SetHeightMap(HeightImage(Waves, 64));
    this->Material->SetHeightScale(0.2);
    this->Material->DepthCorrectionOn();
    this->Material->Attach(this->Actor);
  }
  ~Scene() { this->Material->Detach(this->Actor); }

  void Look(double degrees)
  {
    const double angle = degrees * 3.14159265358979 / 180.;
    vtkCamera* camera = this->Stage.Renderer->GetActiveCamera();
    camera->SetPosition(0., -4. * std::sin(angle), 4. * std::cos(angle));
    camera->SetFocalPoint(0., 0., 0.);
    camera->SetViewUp(0., 1., 0.);
    camera->SetClippingRange(0.01, 10.);
    // From afar, a grazing view is a line.
    camera->SetParallelProjection(degrees > 85.);
    camera->SetParallelScale(1.5 * std::cos(angle));
  }

  std::vector<unsigned char> Picture()
  {
    this->Stage.Window->Render();
    vtkNew<vtkUnsignedCharArray> pixels;
    this->Stage.Window->GetPixelData(0, 0, Width - 1, Height - 1, 0, pixels);
    return { pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues() };
  }

  std::vector<unsigned char> PictureWithout()
  {
    this->Material->EnabledOff();
    auto picture = this->Picture();
    this->Material->EnabledOn();
    return picture;
  }

  // All normals of unit length, all depths finite and before the far plane.
  void CheckSound(const std::string& what)
  {
    Layers layers(this->Stage.Renderer, { "depth", "normal" });
    int seen = 0;
    int unsound = 0;
    for (int y = 0; y < layers.Height; ++y)
    {
      for (int x = 0; x < layers.Width; ++x)
      {
        const double depth = layers.Value("depth", x, y);
        if (std::isinf(depth))
        {
          continue;
        }
        ++seen;
        const double length = glm::length(layers.Vector("normal", x, y));
        unsound += std::isfinite(depth) && depth > 0. && std::abs(length - 1.) < 1e-3 ? 0 : 1;
      }
    }
    RELIEVO_CHECK_THAT(seen > 20, what + ": something is seen");
    RELIEVO_CHECK_THAT(unsound == 0, what + ": " + std::to_string(unsound) + " unsound pixels");
  }
};

void TestMeshes()
{
  {
    Scene scene;
    const auto plain = scene.PictureWithout();
    scene.Mesh->GetPointData()->SetTCoords(nullptr);
    ExpectMessage expect("no texture coordinates");
    RELIEVO_CHECK_THAT(scene.Picture() == plain, "without texture coordinates: as without");
    RELIEVO_CHECK_THAT(scene.Picture() == plain, "and in the next picture");
    RELIEVO_CHECK_THAT(expect.Count() == 1, "said once");
  }
  {
    Scene scene;
    const auto plain = scene.PictureWithout();
    for (const bool line : { false, true })
    {
      vtkNew<vtkFloatArray> tcoords;
      tcoords->SetNumberOfComponents(2);
      for (vtkIdType i = 0; i < scene.Mesh->GetNumberOfPoints(); ++i)
      {
        const double along = line ? scene.Mesh->GetPoint(i)[0] : 0.;
        tcoords->InsertNextTuple2(0.3 + along, 0.7 + along);
      }
      scene.Mesh->GetPointData()->SetTCoords(tcoords);
      RELIEVO_CHECK_THAT(
        scene.Picture() == plain, line ? "coordinates on a line: flat" : "one coordinate: flat");
      scene.CheckSound(line ? "coordinates on a line" : "one coordinate");
    }
  }
  {
    // Half of the mesh has a texture of no area, the other half a sound one.
    Scene scene;
    vtkNew<vtkFloatArray> tcoords;
    tcoords->SetNumberOfComponents(2);
    for (vtkIdType i = 0; i < scene.Mesh->GetNumberOfPoints(); ++i)
    {
      const double* p = scene.Mesh->GetPoint(i);
      tcoords->InsertNextTuple2(std::max(0., p[0]), std::max(0., p[0]) * p[1]);
    }
    scene.Mesh->GetPointData()->SetTCoords(tcoords);
    scene.CheckSound("half without area");
  }
}

vtkSmartPointer<vtkImageData> Image(int width, int height, vtkDataArray* values)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  values->SetNumberOfTuples(static_cast<vtkIdType>(width) * height);
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < values->GetNumberOfComponents(); ++c)
    {
      values->SetComponent(i, c, (i * 7 + c * 3) % 100);
    }
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

void TestMaps()
{
  Scene scene;
  const auto plain = scene.PictureWithout();
  vtkNew<vtkUnsignedCharArray> one;
  scene.Material->SetHeightMap(Image(1, 1, one));
  scene.CheckSound("1 x 1");
  vtkNew<vtkShortArray> odd;
  scene.Material->SetHeightMap(Image(37, 5, odd));
  scene.CheckSound("37 x 5 of signed short");
  vtkNew<vtkFloatArray> bad;
  auto holes = Image(33, 20, bad);
  bad->SetValue(7, NAN);
  bad->SetValue(100, std::numeric_limits<float>::infinity());
  {
    ExpectMessage expect("not finite");
    scene.Material->SetHeightMap(holes);
    scene.CheckSound("holes");
    RELIEVO_CHECK(expect.Count() == 1);
  }
  vtkNew<vtkFloatArray> level;
  auto flat = Image(8, 8, level);
  level->Fill(3.);
  scene.Material->SetHeightMap(flat);
  scene.CheckSound("level ground");

  const int limit = vtkTextureObject::GetMaximumTextureSize(
    vtkOpenGLRenderWindow::SafeDownCast(scene.Stage.Window));
  {
    ExpectMessage expect("reduced to");
    vtkNew<vtkUnsignedCharArray> wide;
    scene.Material->SetHeightMap(Image(limit + 1, 2, wide));
    scene.CheckSound("wider than OpenGL's limit");
  }
  {
    ExpectMessage expect("No height map: it has no scalars");
    vtkNew<vtkImageData> empty;
    scene.Material->SetHeightMap(empty);
    RELIEVO_CHECK_THAT(scene.Picture() == plain, "no scalars: as without");
    RELIEVO_CHECK_THAT(scene.Picture() == plain, "no scalars: and in the next picture");
    RELIEVO_CHECK_THAT(expect.Count() == 1, "said once");
  }
  {
    ExpectMessage expect("one slice in z");
    vtkNew<vtkUnsignedCharArray> block;
    auto thick = Image(4, 4, block);
    thick->SetDimensions(4, 2, 2);
    scene.Material->SetHeightMap(thick);
    RELIEVO_CHECK_THAT(scene.Picture() == plain, "a block: as without");
  }
  {
    ExpectMessage expect("No normal map");
    scene.Material->SetHeightMap(nullptr);
    vtkNew<vtkUnsignedCharArray> grey;
    scene.Material->SetNormalMap(Image(16, 16, grey));
    RELIEVO_CHECK_THAT(scene.Picture() == plain, "a normal map of one component: as without");
  }
}

// Maps that cannot be used are left out, and said, each by itself, until they can.
void TestRepairs()
{
  Scene scene;
  scene.Material->SetNormalMap([] {
    vtkNew<vtkUnsignedCharArray> values;
    values->SetNumberOfComponents(3);
    return Image(16, 16, values);
  }());
  const auto both = scene.Picture();
  const auto plain = scene.PictureWithout();
  vtkSmartPointer<vtkImageData> heights = scene.Material->GetHeightMap();
  scene.Material->SetHeightMap(nullptr);
  const auto normalsOnly = scene.Picture();
  RELIEVO_CHECK(both != plain && normalsOnly != plain && normalsOnly != both);
  scene.Material->SetHeightMap(heights);
  vtkImageData* maps[2] = { heights, scene.Material->GetNormalMap() };
  vtkSmartPointer<vtkDataArray> values[2];
  for (int i = 0; i < 2; ++i)
  {
    values[i] = maps[i]->GetPointData()->GetScalars();
  }
  auto fill = [&](int i, bool on) {
    maps[i]->GetPointData()->SetScalars(on ? values[i].Get() : nullptr);
    maps[i]->Modified();
  };
  for (int round = 0; round < 2; ++round)
  {
    const std::string what = "repairs, round " + std::to_string(round);
    ExpectMessage noHeights("No height map");
    ExpectMessage noNormals("No normal map");
    fill(0, false);
    RELIEVO_CHECK_THAT(scene.Picture() == normalsOnly, what + ": heights are gone");
    fill(1, false);
    for (int i = 0; i < 3; ++i)
    {
      RELIEVO_CHECK_THAT(scene.Picture() == plain, what + ": both are gone");
    }
    fill(1, true);
    RELIEVO_CHECK_THAT(scene.Picture() == normalsOnly, what + ": normals are back");
    fill(0, true);
    RELIEVO_CHECK_THAT(scene.Picture() == both, what + ": both are back");
    RELIEVO_CHECK_THAT(noHeights.Count() == 1 && noNormals.Count() == 1, what + ": said once");
  }
}

void TestViews()
{
  Scene scene;
  for (int method = vtkRelievoMaterial::METHOD_OFF; method <= vtkRelievoMaterial::METHOD_RELIEF;
       ++method)
  {
    scene.Material->SetReliefMethod(method);
    for (const double angle : { 0., 80., 89., 89.9 })
    {
      scene.Look(angle);
      scene.CheckSound("method " + std::to_string(method) + " at " + std::to_string(angle));
    }
  }
  // Close above the mesh, and below it: within the relief.
  scene.Look(0.);
  vtkCamera* camera = scene.Stage.Renderer->GetActiveCamera();
  for (const double z : { 0.01, -0.05 })
  {
    camera->SetPosition(0., -0.5, z);
    camera->SetFocalPoint(0., 1., z - 0.3);
    camera->SetViewUp(0., 0., 1.);
    camera->SetClippingRange(0.001, 10.);
    scene.CheckSound("camera at " + std::to_string(z));
  }
}

// Blocks of a composite mapper carry the material, and look as one mesh does.
void TestBlocks()
{
  Scene scene;
  const auto one = scene.Picture();
  scene.Material->Detach(scene.Actor);
  scene.Stage.Renderer->RemoveActor(scene.Actor);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, scene.Mesh);
  vtkNew<vtkRelievoCompositeMapper> mapper;
  mapper->SetInputDataObject(blocks);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->DeepCopy(scene.Actor->GetProperty());
  scene.Stage.Renderer->AddActor(actor);
  const auto bare = scene.Picture();
  scene.Material->Attach(actor);
  const auto many = scene.Picture();
  RELIEVO_CHECK_THAT(many != bare, "blocks: the material is seen");
  RELIEVO_CHECK_THAT(many == one, "blocks: as one mesh");
  scene.Material->Detach(actor);
  // Colours of points that are interpolated as values take the coordinates: they stay.
  vtkNew<vtkFloatArray> values;
  for (vtkIdType i = 0; i < scene.Mesh->GetNumberOfPoints(); ++i)
  {
    values->InsertNextValue(static_cast<float>(scene.Mesh->GetPoint(i)[0]));
  }
  scene.Mesh->GetPointData()->SetScalars(values);
  scene.Mesh->Modified();
  mapper->InterpolateScalarsBeforeMappingOn();
  mapper->SetScalarRange(-1., 1.);
  const auto colored = scene.Picture();
  RELIEVO_CHECK_THAT(colored != bare, "blocks: colours");
  scene.Material->Attach(actor);
  ExpectMessage expect("InterpolateScalarsBeforeMapping");
  RELIEVO_CHECK_THAT(scene.Picture() == colored, "blocks: colours stay");
  RELIEVO_CHECK_THAT(scene.Picture() == colored, "blocks: and in the next picture");
  RELIEVO_CHECK_THAT(expect.Count() == 1, "blocks: said once");
  scene.Material->Detach(actor);
}

void TestTogether()
{
  // Two actors with a material each, one of them twice, in two windows; shadows and layers beside.
  Scene scene;
  const auto alone = scene.Picture();
  vtkNew<vtkRelievoMaterial> second;
  second->SetNormalMap([] {
    vtkNew<vtkUnsignedCharArray> values;
    values->SetNumberOfComponents(3);
    return Image(16, 16, values);
  }());
  auto far = AddActor(scene.Stage.Renderer, ReliefPlane(2));
  far->SetPosition(0., 60., -60.);
  second->Attach(far);
  scene.Picture();
  Scene other;
  RELIEVO_CHECK_THAT(other.Picture() == alone, "another window");
  scene.Material->Attach(far);
  RELIEVO_CHECK(vtkRelievoMaterial::Get(far) == scene.Material);
  scene.Picture();
  scene.Material->Detach(far);
  scene.Stage.Renderer->RemoveActor(far);
  RELIEVO_CHECK_THAT(scene.Picture() == alone, "alone again");
  vtkRelievoPass* frame = vtkRelievoPass::Attach(scene.Stage.Renderer);
  RELIEVO_CHECK_THAT(scene.Picture() == alone, "in a frame with nothing on");
  frame->ShadowsOn();
  scene.Picture();
  scene.CheckSound("with shadows");
  vtkRelievoPass::Detach(scene.Stage.Renderer);
  for (int i = 0; i < 50; ++i)
  {
    scene.Material->SetReliefMethod(i % 5);
    scene.Material->SetSelfShadow(i % 2 == 0);
    scene.Material->SetClipAtBorders(i % 3 == 0);
    scene.Picture();
  }
  scene.Material->SetReliefMethod(vtkRelievoMaterial::METHOD_RELIEF);
  scene.Material->SelfShadowOff();
  scene.Material->ClipAtBordersOff();
  RELIEVO_CHECK_THAT(scene.Picture() == alone, "after 50 toggles");
  const vtkIdType bytes = scene.Material->GetBytesHeld();
  RELIEVO_CHECK_THAT(bytes > 0 && bytes < 64 * 64 * 4 * 2, "bytes: one texture");
  scene.Material->ReleaseGraphicsResources(scene.Stage.Window);
  RELIEVO_CHECK(scene.Material->GetBytesHeld() == 0);
}

// A relief that is deeper than the gap to the ground casts the shadow of its mesh, in the frame in
// which VTK's own shaders draw it into the map and in later ones, whatever changes.
void TestCasts()
{
  constexpr double Gap = 0.1;
  Scene scene;
  vtkRenderer* renderer = scene.Stage.Renderer;
  const auto ground =
    MakePolygons({ { -3., -3., -Gap }, { 3., -3., -Gap }, { 3., 3., -Gap }, { -3., 3., -Gap } });
  ground->GetPolys()->InsertNextCell({ 0, 1, 2, 3 });
  AddActor(renderer, ground);
  renderer->RemoveAllLights();
  vtkNew<vtkLight> sun;
  sun->SetLightTypeToSceneLight();
  sun->SetPosition(-3., 0., 1.);
  renderer->AddLight(sun);
  vtkRelievoPass::Attach(renderer);
  const auto check = [&scene, renderer](const std::string& what) {
    const Layers layers(renderer, { "shadow_0", "position" });
    int dark = 0;
    int mismatches = 0;
    for (int y = 0; y < Height; ++y)
    {
      for (int x = 0; x < Width; ++x)
      {
        // Where the ray to the sun passes the mesh's plane; its square is between -1 and 1.
        const glm::dvec3 place = layers.Vector("position", x, y);
        const double along = place.x - 3. * Gap;
        const bool nearEdge =
          std::abs(along - 1.) < 0.03 || std::abs(std::abs(place.y) - 1.) < 0.03;
        if (std::abs(place.z + Gap) < 1e-4 && place.x > 1.02 && !nearEdge)
        {
          const bool blocked = along < 1. && std::abs(place.y) < 1.;
          dark += blocked ? 1 : 0;
          mismatches += (layers.Value("shadow_0", x, y) < 0.5) != blocked ? 1 : 0;
        }
      }
    }
    RELIEVO_CHECK_THAT(dark > 100, what + ": pixels in the mesh's shadow");
    RELIEVO_CHECK_AT_MOST(mismatches, 0, what + ": pixels of the ground in a wrong light");
  };
  check("the first frame");
  scene.Material->SetAlphaCutoff(0.1);
  check("with a cutoff");
  scene.Material->SetAlphaCutoff(0.);
  check("without it again");
  scene.Material->SetTextureOffset(0.5, 0.5);
  scene.Material->ClipAtBordersOn();
  scene.Actor->SetPosition(0., 0., 1e-9); // draws the map again
  check("clipped");
  vtkRelievoPass::Detach(renderer);
}
}

RELIEVO_TEST_CASE(testMaterialStability)
{
  relievoTest::Session session;
  TestMeshes();
  TestMaps();
  TestRepairs();
  TestViews();
  TestBlocks();
  TestTogether();
  TestCasts();
  return session.Result();
}
}
