// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Soft shadows where something changes that tells no prop of it: settings of the environment's
// light, of texts in the scene, and levels of detail, which VTK chooses by time. Each begins the
// gathering anew. And the times of frames that gather at once.
#include "Check.h"
#include "Layers.h"
#include "Props.h"
#include "Session.h"
#include "ShadowPictures.h"
#include "SoftStage.h"
#include "TestCase.h"

#include <vtkBillboardTextActor3D.h>
#include <vtkImageData.h>
#include <vtkLODProp3D.h>
#include <vtkOpenGLActor.h>
#include <vtkOpenGLRenderer.h>
#include <vtkPBRIrradianceTexture.h>
#include <vtkPBRLUTTexture.h>
#include <vtkPBRPrefilterTexture.h>
#include <vtkProperty.h>
#include <vtkTextActor3D.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace testShadowSoftState
{
namespace
{
using relievoTest::CountUnlike;
using relievoTest::SamePicture;

vtkSmartPointer<vtkPolyDataMapper> MakeMapper(vtkPolyData* mesh)
{
  auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputData(mesh);
  return mapper;
}

// A small version of VTK's data for an environment.
struct Environment : SoftStage
{
  explicit Environment(bool first)
    : SoftStage(4)
  {
    vtkNew<vtkImageData> sky;
    sky->SetDimensions(16, 8, 1);
    sky->AllocateScalars(VTK_FLOAT, 3);
    auto* texels = static_cast<float*>(sky->GetScalarPointer());
    for (int i = 0; i < 3 * 16 * 8; ++i)
    {
      texels[i] = i / 3 % 16 < 2 ? 8.f : 0.05f;
    }
    vtkNew<vtkTexture> texture;
    texture->SetInputData(sky);
    texture->SetColorModeToDirectScalars();
    texture->MipmapOn();
    texture->InterpolateOn();
    this->Renderer->UseImageBasedLightingOn();
    this->Renderer->SetEnvironmentTexture(texture);
    auto* renderer = vtkOpenGLRenderer::SafeDownCast(this->Renderer);
    renderer->UseSphericalHarmonicsOff();
    renderer->GetEnvMapLookupTable()->SetLUTSize(16);
    renderer->GetEnvMapLookupTable()->SetLUTSamples(16);
    renderer->GetEnvMapPrefiltered()->SetPrefilterMaxSamples(8);
    renderer->GetEnvMapPrefiltered()->SetPrefilterLevels(2);
    renderer->GetEnvMapIrradiance()->SetIrradianceSize(16);
    renderer->GetEnvMapIrradiance()->SetIrradianceStep(0.4f);
    this->Box->GetProperty()->SetInterpolationToPBR();
    this->Box->GetProperty()->SetRoughness(0.9);
    this->Change(first);
  }
  void Change(bool first)
  {
    vtkOpenGLRenderer::SafeDownCast(this->Renderer)
      ->GetEnvMapIrradiance()
      ->SetIrradianceSize(first ? 16 : 2);
  }
};

struct Texts : SoftStage
{
  vtkNew<vtkTextActor3D> Text;
  vtkNew<vtkBillboardTextActor3D> Billboard;
  bool Turns;

  Texts(bool first, bool billboard)
    : SoftStage(4)
    , Turns(billboard)
  {
    this->Text->SetInput("text");
    this->Text->SetScale(0.04);
    this->Text->SetPosition(-2.2, 0.4, 1.);
    this->Billboard->SetInput("billboard");
    this->Billboard->SetPosition(-0.6, 1.4, 1.);
    this->Renderer->AddActor(this->Text);
    this->Renderer->AddActor(this->Billboard);
    this->AddSun(2., 3., 6.); // billboards look at the camera, the other lights at their backs
    this->Change(first);
  }
  void Change(bool first)
  {
    vtkTextProperty* property =
      this->Turns ? this->Billboard->GetTextProperty() : this->Text->GetTextProperty();
    property->SetColor(first ? 1. : 0.1, 0.9, 0.2);
  }
};
struct Billboards : Texts
{
  explicit Billboards(bool first)
    : Texts(first, true)
  {
  }
};
struct PlainTexts : Texts
{
  explicit PlainTexts(bool first)
    : Texts(first, false)
  {
  }
};

// A change of the levels to choose from emits no event.
struct Levels : SoftStage
{
  vtkNew<vtkLODProp3D> Prop;
  int Ids[2];

  explicit Levels(bool first)
    : SoftStage(4)
  {
    for (int i = 0; i < 2; ++i)
    {
      this->Ids[i] =
        this->Prop->AddLOD(MakeMapper(relievoTest::MakeBox(0.5, 0.3 + 0.6 * i, 0.5)), 0.);
    }
    this->Prop->SetPosition(1.4, 0.5, 1.4);
    this->Renderer->AddActor(this->Prop);
    this->Change(first);
  }
  void Change(bool first)
  {
    this->Prop->EnableLOD(this->Ids[first ? 0 : 1]);
    this->Prop->DisableLOD(this->Ids[first ? 1 : 0]);
  }
};

// Chooses by the time that the window leaves it, while it draws, as VTK's class of that name, which
// not all builds have.
class vtkLODActor : public vtkOpenGLActor
{
public:
  static vtkLODActor* New();
  vtkTypeMacro(vtkLODActor, vtkOpenGLActor);
  vtkSmartPointer<vtkMapper> Coarse;

  void Render(vtkRenderer* renderer, vtkMapper* mapper) override
  {
    const bool coarse = renderer->GetRenderWindow()->GetDesiredUpdateRate() > 1.;
    this->Superclass::Render(renderer, coarse ? this->Coarse.Get() : mapper);
  }
};
vtkStandardNewMacro(vtkLODActor);

struct ActorLevels : SoftStage
{
  vtkNew<vtkLODActor> Actor;

  explicit ActorLevels(bool first)
    : SoftStage(4)
  {
    this->Actor->SetMapper(MakeMapper(relievoTest::MakeBox(0.5, 0.3, 0.5)));
    this->Actor->Coarse = MakeMapper(relievoTest::MakeBox(0.5, 0.9, 0.5));
    this->Actor->SetPosition(1.4, 0.5, 1.4);
    this->Renderer->AddActor(this->Actor);
    this->Change(first);
  }
  void Change(bool first) { this->Window->SetDesiredUpdateRate(first ? 0.0001 : 15.); }
};

// After the change the picture is that of a gathering that was never of anything else.
template <typename Changing>
void TestChange(const std::string& what)
{
  Changing stage(true);
  stage.Window->Render();
  stage.Window->Render();
  RELIEVO_CHECK_THAT(stage.GetFrame()->GetSamplesLeft() == 2,
    what + ": " + std::to_string(stage.GetFrame()->GetSamplesLeft()) + " samples left, not 2");
  stage.Change(false);
  const auto gathered = stage.DrawAll();
  Changing fresh(false);
  SamePicture(fresh.DrawAll(), gathered, what);
  Changing before(true);
  RELIEVO_CHECK_THAT(CountUnlike(before.DrawAll(), gathered, 8) > 20, what + " changes nothing");
}

// Milliseconds of the last frame that was timed.
double GetTime(SoftStage& stage)
{
  const std::string report = stage.GetFrame()->GetFrameReport();
  const std::string key = "\n  \"gpu_ms\": ";
  const std::size_t at = report.find(key);
  return at == std::string::npos ? 0. : std::atof(report.c_str() + at + key.size());
}

// A frame of 24 samples takes as long as 24 frames, or nearly so, and says so.
void TestTimes()
{
  constexpr int Many = 24;
  SoftStage single(Many);
  std::vector<double> times;
  for (int frame = 0; frame < Many; ++frame)
  {
    GetTime(single); // asks for the next one's
    single.Window->Render();
    times.push_back(GetTime(single));
  }
  std::sort(times.begin(), times.end());
  const double one = times[Many / 2];
  SoftStage together(Many);
  together.GetFrame()->WaitForSamplesOn();
  GetTime(together);
  for (int frame = 0; frame < 3; ++frame)
  {
    together.Box->GetProperty()->SetColor(0.2 * frame, 0.5, 0.5); // begins anew
    together.Window->Render();
  }
  const double all = GetTime(together);
  std::cout << "a sample takes " << one << " ms, " << Many << " at once " << all << " ms\n";
  RELIEVO_CHECK_THAT(one > 0. && all > 6. * one, "times of frames that gather at once");
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testShadowSoftState)
{
  relievoTest::Session session;
  TestChange<Environment>("an environment's irradiance");
  TestChange<PlainTexts>("a text's colour");
  TestChange<Billboards>("a billboard's colour");
  TestChange<Levels>("a level of detail");
  TestChange<ActorLevels>("a level of detail by the window's rate");
  TestTimes();
  return session.Result();
}
}
