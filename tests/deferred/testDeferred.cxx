// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Deferred shading against VTK's own picture of the same scene: every kind of surface, light and
// view, with and without shadows. VTK's picture is the truth.
#include "Check.h"
#include "DeferredScenes.h"
#include "GLCheck.h"
#include "Session.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkProperty.h>
#include <vtkRelievoShadowStage.h>

#include <functional>
#include <string>
#include <vector>

namespace testDeferred
{
namespace
{
using namespace relievoTest;
using Set = std::function<void(DeferredScene&)>;

struct Case
{
  const char* Name;
  Set Do;
  int Levels = 1;    // of 255
  bool Left = false; // whether VTK lights some of it
};

void AllProperties(DeferredScene& scene, const std::function<void(vtkProperty*)>& set)
{
  for (const auto& actor : scene.Actors)
  {
    set(actor->GetProperty());
  }
}

const std::vector<Case> Surfaces{
  { "matte", [](DeferredScene&) {} },
  { "flat",
    [](DeferredScene& s) { AllProperties(s, [](auto* p) { p->SetInterpolationToFlat(); }); } },
  { "shares",
    [](DeferredScene& s) {
      AllProperties(s, [](auto* p) {
        p->SetAmbient(0.2);
        p->SetAmbientColor(0.2, 0.9, 0.4);
        p->SetDiffuse(0.7);
      });
    } },
  { "highlights",
    [](DeferredScene& s) {
      AllProperties(s, [](auto* p) {
        p->SetDiffuse(0.6);
        p->SetSpecular(0.4);
        p->SetSpecularColor(1.0, 0.9, 0.5);
      });
      s.Actors[0]->GetProperty()->SetSpecularPower(100.0);
      s.Actors[1]->GetProperty()->SetSpecularPower(7.5);
    } },
  { "some shine, one is unlit",
    [](DeferredScene& s) {
      s.Actors[0]->GetProperty()->SetSpecular(0.5);
      s.Actors[0]->GetProperty()->SetSpecularPower(30.0);
      s.Actors[1]->GetProperty()->LightingOff();
    } },
  { "edges", [](DeferredScene& s) { s.Actors[1]->GetProperty()->EdgeVisibilityOn(); }, 1, true },
  { "wire frame",
    [](DeferredScene& s) { s.Actors[0]->GetProperty()->SetRepresentationToWireframe(); }, 1, true },
  { "points with normals",
    [](DeferredScene& s) {
      s.Actors[0]->GetProperty()->SetRepresentationToPoints();
      s.Actors[0]->GetProperty()->SetPointSize(5.0);
    },
    1, true },
  { "both sides",
    [](DeferredScene& s) {
      vtkNew<vtkProperty> back;
      back->SetColor(0.9, 0.2, 0.1);
      back->SetDiffuse(0.8);
      back->SetSpecular(0.3);
      back->SetSpecularPower(20.0);
      s.Actors[1]->SetBackfaceProperty(back);
      s.Actors[1]->RotateX(140.0);
    } },
  { "colours of points", [](DeferredScene& s) { s.ColorByHeight(0); } },
  { "texture", [](DeferredScene& s) { s.SetTexture(2); } },
  { "texture and highlights",
    [](DeferredScene& s) {
      s.SetTexture(2);
      s.Actors[2]->GetProperty()->SetSpecular(0.4);
      s.Actors[2]->GetProperty()->SetSpecularPower(12.0);
    } },
  { "PBR",
    [](DeferredScene& s) {
      AllProperties(s, [](auto* p) { p->SetInterpolationToPBR(); });
      s.Actors[0]->GetProperty()->SetMetallic(0.7);
      s.Actors[0]->GetProperty()->SetRoughness(0.25);
      s.Actors[1]->GetProperty()->SetRoughness(0.6);
    },
    2 },
  { "dark PBR",
    [](DeferredScene& s) {
      AllProperties(s, [](auto* p) {
        p->SetInterpolationToPBR();
        p->SetColor(0.004, 0.002, 0.0015);
        p->SetRoughness(0.9);
      });
      for (int i = 0; i < 3; ++i)
      {
        s.AddLight()->SetIntensity(2.0);
      }
    },
    2 },
  { "PBR and Phong",
    [](DeferredScene& s) {
      s.Actors[0]->GetProperty()->SetInterpolationToPBR();
      s.Actors[0]->GetProperty()->SetMetallic(1.0);
      s.Actors[0]->GetProperty()->SetRoughness(0.4);
      s.Actors[1]->GetProperty()->SetSpecular(0.5);
      s.Actors[1]->GetProperty()->SetSpecularPower(40.0);
    },
    2 },
};

const std::vector<Case> Lights{
  { "headlight", [](DeferredScene& s) { s.AddLight()->SetLightTypeToHeadlight(); } },
  { "sun", [](DeferredScene& s) { s.AddLight(); } },
  { "suns, one off",
    [](DeferredScene& s) {
      s.AddLight()->SetIntensity(0.5);
      s.AddLight()->SwitchOff();
      s.AddLight()->SetPosition(-3.0, 2.0, 1.0);
    } },
  { "lamp with attenuation",
    [](DeferredScene& s) {
      vtkLight* light = s.AddLight();
      light->PositionalOn();
      light->SetConeAngle(180.0);
      light->SetAttenuationValues(0.5, 0.1, 0.02);
    } },
  { "sun, spot and lamp",
    [](DeferredScene& s) {
      s.AddLight()->SetIntensity(0.4);
      vtkLight* spot = s.AddLight();
      spot->PositionalOn();
      spot->SetConeAngle(25.0);
      spot->SetExponent(2.0);
      spot->SetDiffuseColor(0.9, 0.6, 0.3);
      vtkLight* lamp = s.AddLight();
      lamp->PositionalOn();
      lamp->SetConeAngle(180.0);
      lamp->SetPosition(-1.5, 1.8, 1.0);
      lamp->SetDiffuseColor(0.2, 0.3, 0.5);
    } },
};

void Compare(const std::string& what, const std::vector<const Case*>& cases, const Set& more = {})
{
  DeferredScene scene(180, 130);
  int levels = 1;
  bool left = false;
  for (const Case* each : cases)
  {
    each->Do(scene);
    levels = std::max(levels, each->Levels);
    left = left || each->Left;
  }
  if (more)
  {
    more(scene);
  }
  const GLCheck gl(scene.Window);
  const int most = scene.CompareWithVTK(what);
  RELIEVO_CHECK_AT_MOST(most, levels, what + ": largest difference, levels");
  RELIEVO_CHECK(scene.Stage->GetReasonCode() == "ran");
  RELIEVO_CHECK(scene.Stage->GetNumberDeferred() > 0);
  RELIEVO_CHECK((scene.Stage->GetNumberLeft() > 0) == left);
}

// Kinds of light in turn: VTK's shaders depend on the lights, and TestLights has all.
void TestSurfaces()
{
  const Case* const kinds[] = { &Lights[0], &Lights[1], &Lights[4] };
  int i = 0;
  for (const Case& surface : Surfaces)
  {
    const Case* light = kinds[i++ % 3];
    Compare(std::string(surface.Name) + ", " + light->Name, { light, &surface });
  }
}

void TestLights()
{
  for (const Case& light : Lights)
  {
    Compare(std::string("shares, ") + light.Name, { &light, &Surfaces[2] });
    Compare(std::string("highlights, shadows, ") + light.Name, { &light, &Surfaces[3] },
      [](DeferredScene& s) {
        s.Frame->ShadowsOn();
        s.Frame->GetShadowStage()->SetStrength(0.8);
      });
    Compare(
      std::string("exact shadows, ") + light.Name, { &light, &Surfaces[2] }, [](DeferredScene& s) {
        s.Frame->ShadowsOn();
        s.Frame->GetShadowStage()->SetMethodToExact();
      });
    Compare(std::string("PBR, shadows, ") + light.Name, { &light, &Surfaces[12] },
      [](DeferredScene& s) { s.Frame->ShadowsOn(); });
  }
}

void TestViews()
{
  const Set views[] = { [](DeferredScene& s) {
                         s.Renderer->GetActiveCamera()->ParallelProjectionOn();
                       },
    [](DeferredScene& s) { s.Renderer->SetViewport(0.2, 0.3, 0.9, 0.8); },
    [](DeferredScene& s) { s.Renderer->GetActiveCamera()->SetViewShear(0.2, -0.1, 1.0); },
    [](DeferredScene& s) { s.Window->SetSize(1, 3); },
    [](DeferredScene& s) { s.Renderer->TwoSidedLightingOff(); } };
  int i = 0;
  for (const Set& view : views)
  {
    Compare("view " + std::to_string(i++), { &Lights[4], &Surfaces[3] }, view);
  }
}
}

RELIEVO_TEST_CASE(testDeferred)
{
  relievoTest::Session session;
  TestSurfaces();
  TestLights();
  TestViews();
  return session.Result();
}
}
