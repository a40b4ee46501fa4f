// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Exact shadows of vtkGlyph3DMapper: VTK's places, sizes, turns, masks and sources, against the
// same instances as meshes of their own; and the effect of changing any of them.
#include "Check.h"
#include "EmbreeScene.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Session.h"
#include "ShadowErrors.h"
#include "ShadowPictures.h"
#include "ShadowScenes.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkBitArray.h>
#include <vtkCamera.h>
#include <vtkCompositeDataDisplayAttributes.h>
#include <vtkConeSource.h>
#include <vtkCubeSource.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkGlyph3DMapper.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataAlgorithm.h>
#include <vtkProperty.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowCertificate.h>
#include <vtkRelievoShadowStage.h>
#include <vtkRenderer.h>
#include <vtkTransform.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace testShadowGlyphs
{
namespace
{
using relievoTest::EmbreeScene;
using relievoTest::ShadowStage;

constexpr double Limit = 2e-5;

enum class Way
{
  Plain, // neither turned nor sized by data
  Direction,
  Rotation,
  Quaternion
};

vtkSmartPointer<vtkPolyData> Copy(vtkPolyDataAlgorithm* source)
{
  source->Update();
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->DeepCopy(source->GetOutput());
  return data;
}

// Glyphs above the ground of a stage, and a truth of their own.
struct Swarm
{
  ShadowStage Stage;
  Way Is;
  vtkNew<vtkPolyData> Data;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkFloatArray> Size;
  vtkNew<vtkDoubleArray> Turn;
  vtkNew<vtkIntArray> Source;
  vtkNew<vtkBitArray> Mask;
  std::vector<vtkSmartPointer<vtkPolyData>> Sources;
  vtkNew<vtkGlyph3DMapper> Mapper;
  vtkNew<vtkActor> Actor;

  Swarm(int count, Way is)
    : Is(is)
  {
    this->Stage.AddGround();
    this->Stage.AddSun(-3., 4., -2.);
    this->Stage.Renderer->GetActiveCamera()->SetPosition(0.5, 6., 5.);
    vtkNew<vtkConeSource> cone;
    cone->SetResolution(5);
    vtkNew<vtkCubeSource> cube;
    this->Sources = { Copy(cone), Copy(cube) };
    this->Size->SetName("size");
    this->Size->SetNumberOfComponents(3);
    this->Turn->SetName("turn");
    this->Turn->SetNumberOfComponents(is == Way::Quaternion ? 4 : 3);
    this->Source->SetName("source");
    this->Mask->SetName("mask");
    std::mt19937 random(7);
    const auto next = [&random]() { return static_cast<double>(random() % 20001) / 10000. - 1.; };
    for (int i = 0; i < count; ++i)
    {
      this->Points->InsertNextPoint(2.6 * next(), 0.9 + 0.7 * next(), 2.6 * next());
      this->Size->InsertNextTuple3(0.6 + 0.4 * next(), 0.6 + 0.4 * next(), 0.6 + 0.4 * next());
      const double degrees = is == Way::Rotation ? 180. : 1.;
      const double turn[4] = { degrees * next(), i % 9 ? degrees * next() : 0.,
        i % 9 ? degrees * next() : 0., next() };
      this->Turn->InsertNextTuple(turn);
      this->Source->InsertNextValue(i % 4 - 1); // its size, and at most the last of two
      this->Mask->InsertNextValue(i % 5 != 0);
    }
    this->Data->SetPoints(this->Points);
    for (vtkAbstractArray* array :
      std::initializer_list<vtkAbstractArray*>{ this->Size, this->Turn, this->Source, this->Mask })
    {
      this->Data->GetPointData()->AddArray(array);
    }
    this->Mapper->SetInputData(this->Data);
    this->Mapper->SetSourceData(0, this->Sources[0]);
    this->Mapper->SetScaleFactor(this->Factor);
    this->Mapper->SetOrient(is != Way::Plain);
    this->Mapper->SetOrientationArray("turn");
    this->Mapper->SetOrientationMode(is == Way::Rotation ? vtkGlyph3DMapper::ROTATION
        : is == Way::Quaternion                          ? vtkGlyph3DMapper::QUATERNION
                                                         : vtkGlyph3DMapper::DIRECTION);
    if (is == Way::Direction || is == Way::Rotation)
    {
      this->Mapper->SetScaleArray("size");
      this->Mapper->SetScaleMode(is == Way::Direction ? vtkGlyph3DMapper::SCALE_BY_MAGNITUDE
                                                      : vtkGlyph3DMapper::SCALE_BY_COMPONENTS);
    }
    if (is == Way::Direction)
    {
      this->Mapper->ClampingOn();
      this->Mapper->SetRange(0.5, 1.3);
    }
    this->Actor->SetMapper(this->Mapper);
    this->Actor->RotateY(20.);
    this->Actor->SetScale(1., 0.9, 1.1);
    this->Stage.Renderer->AddActor(this->Actor);
    this->Stage.GetShadows()->SetMethodToExact();
  }

  // Where a glyph is, by vtkGlyph3DMapper's documentation and vtkTransform.
  void Place(vtkIdType i, vtkTransform* transform) const
  {
    double p[3];
    this->Points->GetPoint(i, p);
    transform->Translate(p);
    double t[4] = { 0., 0., 0., 0. };
    this->Turn->GetTuple(i, t);
    const double length = std::sqrt(t[0] * t[0] + t[1] * t[1] + t[2] * t[2]);
    switch (this->Is)
    {
      case Way::Direction: // x becomes the direction, by half a turn, or none
        if (t[1] != 0. || t[2] != 0.)
        {
          transform->RotateWXYZ(180., t[0] + length, t[1], t[2]);
        }
        else if (t[0] < 0.)
        {
          transform->RotateY(180.);
        }
        break;
      case Way::Rotation:
        transform->RotateZ(t[2]);
        transform->RotateX(t[0]);
        transform->RotateY(t[1]);
        break;
      case Way::Quaternion:
      {
        const double sine = std::sqrt(t[1] * t[1] + t[2] * t[2] + t[3] * t[3]);
        transform->RotateWXYZ(360. / vtkMath::Pi() * std::atan2(sine, t[0]), t[1], t[2], t[3]);
        break;
      }
      case Way::Plain:
        break;
    }
    double s[3];
    this->Size->GetTuple(i, s);
    double clamped = std::sqrt(s[0] * s[0] + s[1] * s[1] + s[2] * s[2]);
    clamped = (std::min(std::max(clamped, 0.5), 1.3) - 0.5) / 0.8;
    clamped = clamped == 0. ? 1e-10 / this->Factor : clamped;
    for (double& each : s)
    {
      each = this->Factor *
        (this->Is == Way::Direction     ? clamped
            : this->Is == Way::Rotation ? each
                                        : 1.);
    }
    transform->Scale(s);
  }

  std::unique_ptr<EmbreeScene> MakeTruth() const
  {
    auto truth = std::make_unique<EmbreeScene>();
    truth->AddActors(this->Stage.Renderer);
    for (vtkIdType i = 0; i < this->Points->GetNumberOfPoints() && this->Actor->GetVisibility();
         ++i)
    {
      if (this->Mapper->GetMasking() && this->Mask->GetValue(i) == 0)
      {
        continue;
      }
      vtkNew<vtkTransform> transform;
      transform->SetMatrix(this->Actor->GetMatrix());
      this->Place(i, transform);
      const int source =
        this->Mapper->GetSourceIndexing() ? std::min(1, std::abs(this->Source->GetValue(i))) : 0;
      truth->AddActor(this->Sources[static_cast<std::size_t>(source)], transform->GetMatrix());
    }
    return truth;
  }

  // Pixels that agree with the truth.
  void Check(const std::string& what, double leastDark = 0.03)
  {
    const auto truth = this->MakeTruth();
    const relievoTest::View view(this->Stage.Renderer);
    const auto seen = truth->Trace(view);
    vtkRenderer* renderer = this->Stage.Renderer;
    auto* sun = vtkLight::SafeDownCast(renderer->GetLights()->GetItemAsObject(0));
    auto verdicts = relievoTest::WithoutEdges(relievoTest::TraceShadow(*truth, seen, sun), seen);
    const relievoTest::Layers layers(renderer, { "shadow_0", "depth" });
    const auto floats = [&layers](const char* name) {
      return vtkFloatArray::SafeDownCast(layers.Image->GetPointData()->GetArray(name))
        ->GetPointer(0);
    };
    const float* depth = floats("depth");
    long long other = 0;
    for (std::size_t i = 0; i < seen.Pixels.size(); ++i)
    {
      const bool same = seen.Pixels[i].Hit == (std::isfinite(depth[i]) != 0) &&
        (!seen.Pixels[i].Hit || std::abs(depth[i] - seen.Pixels[i].Depth) < 1e-3);
      other += same ? 0 : 1;
      verdicts.Verdicts[i] = same ? verdicts.Verdicts[i] : relievoTest::ShadowTruth::Unjudged;
    }
    const auto errors = relievoTest::CompareShadow(verdicts, floats("shadow_0"));
    std::cout << what << ": " << errors.ToString() << ", " << other << " show another\n";
    const auto pixels = static_cast<double>(seen.Pixels.size());
    RELIEVO_CHECK_AT_MOST(static_cast<double>(other), 0.004 * pixels, what + ": show another");
    RELIEVO_CHECK_THAT(static_cast<double>(errors.Compared) > 0.2 * pixels &&
        static_cast<double>(errors.Dark) >= leastDark * static_cast<double>(errors.Compared),
      what + ": what is compared");
    RELIEVO_CHECK_AT_MOST(errors.Wrong(), Limit, what + ": share of wrong verdicts");
  }

  void CheckMaps(int maps, const std::string& what)
  {
    this->Stage.GetFrame()->ShadowsOn();
    this->Stage.Window->Render();
    RELIEVO_CHECK_THAT(this->Stage.GetShadows()->GetNumberOfMaps() == maps, what + ": maps");
    this->Stage.GetFrame()->ShadowsOff();
  }

  double Factor = 0.12;
};

void TestWays()
{
  for (const auto& [way, name] :
    { std::pair<Way, const char*>{ Way::Plain, "plain" }, { Way::Direction, "direction" },
      { Way::Rotation, "rotation" }, { Way::Quaternion, "quaternion" } })
  {
    Swarm swarm(2500, way);
    const relievoTest::GLCheck gl(swarm.Stage.Window);
    if (way == Way::Quaternion || way == Way::Rotation)
    {
      swarm.Mapper->SetSourceData(1, swarm.Sources[1]);
      swarm.Mapper->SourceIndexingOn();
      swarm.Mapper->SetSourceIndexArray("source");
    }
    if (way == Way::Plain || way == Way::Quaternion)
    {
      swarm.Mapper->MaskingOn();
      swarm.Mapper->SetMaskArray("mask");
    }
    swarm.Check(name);
    swarm.CheckMaps(0, name);
  }
}

// A mapper that was changed draws the picture of one that was never anything else.
void TestChanges()
{
  Swarm swarm(800, Way::Rotation);
  swarm.Check("before");
  for (vtkIdType i = 0; i < swarm.Points->GetNumberOfPoints(); ++i)
  {
    double p[3];
    swarm.Points->GetPoint(i, p);
    swarm.Points->SetPoint(i, p[0] + 0.3, p[1] + 0.2, p[2] - 0.2);
  }
  swarm.Points->Modified();
  swarm.Check("moved points");
  for (vtkIdType i = 0; i < swarm.Turn->GetNumberOfTuples(); ++i)
  {
    swarm.Turn->SetComponent(i, 0, swarm.Turn->GetComponent(i, 0) + 40.);
  }
  swarm.Turn->Modified();
  swarm.Check("turned");
  vtkPoints* points = swarm.Sources[0]->GetPoints();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double p[3];
    points->GetPoint(i, p);
    points->SetPoint(i, 1.5 * p[0], 0.7 * p[1], p[2]);
  }
  points->Modified();
  swarm.Sources[0]->Modified();
  swarm.Check("changed source");
  vtkNew<vtkCubeSource> cube;
  swarm.Sources[0] = Copy(cube);
  swarm.Mapper->SetSourceData(0, swarm.Sources[0]);
  swarm.Check("another source");
  swarm.Actor->SetPosition(0.2, 0.3, 0.);
  swarm.Check("moved actor");
  swarm.Mapper->SetScaleFactor(swarm.Factor = 0.2);
  swarm.Check("larger");
  swarm.Mapper->SetMaskArray("mask");
  swarm.Mapper->MaskingOn();
  swarm.Actor->SetScale(-1., 0.9, 1.1);
  swarm.Check("masked and mirrored");
  swarm.Actor->VisibilityOff();
  swarm.Check("hidden", 0.);
}

// One that is far away is rounded more, and takes no shadow from the others.
void TestFar()
{
  Swarm swarm(900, Way::Plain);
  swarm.Stage.GetFrame()->ShadowsOn();
  const auto without = relievoTest::Picture(swarm.Stage.Window);
  swarm.Points->InsertNextPoint(1e5, 0., 0.);
  swarm.Points->Modified();
  const auto with = relievoTest::Picture(swarm.Stage.Window);
  RELIEVO_CHECK_AT_MOST(
    relievoTest::CountUnlike(without, with, 2), 3, "pixels that change by a glyph far away");
}

// Blocks of points; where VTK's versions differ in drawing them, maps are used.
void TestBlocks()
{
  Swarm swarm(300, Way::Direction);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(1, swarm.Data);
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  swarm.Mapper->SetInputDataObject(blocks);
  swarm.Mapper->SetBlockAttributes(attributes);
  swarm.Check("blocks");
  swarm.CheckMaps(0, "blocks");
  attributes->SetBlockVisibility(swarm.Data, false);
  swarm.CheckMaps(1, "hidden block");
  attributes->RemoveBlockVisibilities();
  swarm.CheckMaps(0, "shown again");
  swarm.Mapper->SetInputData(swarm.Data);
  swarm.Mapper->SetScaleModeToScaleByVectorComponents();
  swarm.Mapper->ClampingOff();
  swarm.Size->SetComponent(0, 1, 0.);
  swarm.Size->Modified();
  swarm.CheckMaps(1, "a flat glyph");
}

// Verdicts for each pixel where VTK's places are known bit for bit, otherwise for each fragment.
void TestFound()
{
  constexpr int Count = 800;
  const auto getBytes = [](Swarm& swarm) {
    return static_cast<double>(swarm.Stage.GetShadows()->GetBytesHeld());
  };
  Swarm swarm(Count, Way::Plain);
  swarm.Check("found");
  swarm.Actor->GetProperty()->EdgeVisibilityOn();
  swarm.Check("edges");
  const double edges = getBytes(swarm);
  swarm.Actor->GetProperty()->EdgeVisibilityOff();
  swarm.Check("faces again");
  const double most = getBytes(swarm) - 64. * Count; // without the matrices of places
  RELIEVO_CHECK_AT_MOST(edges, most, "edges: bytes held");
  vtkPoints* points = swarm.Sources[0]->GetPoints();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double p[3];
    points->GetPoint(i, p);
    points->SetPoint(i, 0.01 * p[0], 0.01 * p[1], 0.01 * p[2]);
  }
  points->Modified();
  swarm.Sources[0]->Modified();
  swarm.Mapper->SetScaleFactor(swarm.Factor *= 100.);
  swarm.Check("small source");
  RELIEVO_CHECK_AT_MOST(getBytes(swarm), most, "small source: bytes held");
}

// 10^5 instances: a source once, at most 208 bytes for each of them, and a certificate.
void TestMany()
{
  constexpr int Count = 100000;
  Swarm swarm(Count, Way::Quaternion);
  swarm.Mapper->SetScaleFactor(0.02);
  swarm.Stage.GetFrame()->ShadowsOn();
  swarm.Stage.Window->Render();
  const auto certificate = swarm.Stage.GetShadows()->Certify(4000);
  std::cout << "many: " << certificate->GetWords() << "\n";
  RELIEVO_CHECK_THAT(certificate->GetJudged() == 4000, certificate->GetWords());
  RELIEVO_CHECK_THAT(certificate->GetWrong() == 0, certificate->GetWords());
  RELIEVO_CHECK_THAT(certificate->GetUnknown() < 40, certificate->GetWords());
  const int* size = swarm.Stage.Window->GetSize();
  RELIEVO_CHECK_AT_MOST(static_cast<double>(swarm.Stage.GetShadows()->GetBytesHeld()),
    208. * Count + 4096. + (24. + 4. / 64.) * (size[0] + 7) * (size[1] + 7), "many: bytes held");
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testShadowGlyphs)
{
  relievoTest::Session session;
  TestWays();
  TestChanges();
  TestFar();
  TestBlocks();
  TestFound();
  TestMany();
  return session.Result();
}
}
