// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The picture with lamps: its linear colour plus the light of lamps reflected by surfaces.
#include "Check.h"
#include "GLCheck.h"
#include "LampScenes.h"
#include "Layers.h"
#include "Session.h"
#include "SrgbCurve.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkProperty.h>
#include <vtkRelievoSoftwareOpenGL.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace testLampsPicture
{
namespace
{
using namespace relievoTest;

// The gloss of one lamp's unit of light at a point, in the linear colour, beside diffuse light.
using Gloss = std::function<glm::dvec3(
  const glm::dvec3& normal, const glm::dvec3& toLamp, const glm::dvec3& toEye)>;

// The largest error of the linear colour against the picture without lamps and their sum in double,
// where the first actor gives back the linear colour `own` of the light, and `gloss` beside it, and
// the second one, which is not lit, nothing, however it would shine.
void CheckColor(const std::function<void(vtkProperty*)>& set, const glm::dvec3& own,
  const std::string& what, const Gloss& gloss = {}, int count = 60)
{
  LampScene scene(120, 90);
  const GLCheck gl(scene.Window);
  vtkActorCollection* actors = scene.Renderer->GetActors();
  std::vector<glm::dvec3> colors;
  for (int i = 0; i < actors->GetNumberOfItems(); ++i)
  {
    const glm::dvec3 color(0.3 + 0.2 * i, 0.9 - 0.2 * i, 0.5);
    vtkProperty* property = vtkActor::SafeDownCast(actors->GetItemAsObject(i))->GetProperty();
    property->SetColor(color.x, color.y, color.z);
    colors.emplace_back(LinearFromSrgb(color.x), LinearFromSrgb(color.y), LinearFromSrgb(color.z));
    if (i == 0)
    {
      set(property);
      colors[0] = own;
    }
    else if (i == 1)
    {
      property->LightingOff();
      property->SetSpecular(0.5);
      colors[1] = glm::dvec3(0.0);
    }
  }
  const Layers plain(scene.Read({ "color" }));
  const std::vector<Lamp> truth = RandomLamps(count, count == 1 ? 6.0 : 1.5, false);
  const auto lamps = scene.AddLamps(truth);
  const double* eye = scene.Renderer->GetActiveCamera()->GetPosition();
  for (const int way : { vtkRelievoLampsStage::QUADS, vtkRelievoLampsStage::CLUSTERS,
         vtkRelievoLampsStage::ALL, vtkRelievoLampsStage::AUTOMATIC })
  {
    scene.Stage->SetWay(way);
    const Layers lit(scene.Read({ "color", "actor", "position", "normal", "depth" }));
    double worst = 0.0;
    double most = 0.0;
    for (int y = 0; y < lit.Height; ++y)
    {
      for (int x = 0; x < lit.Width; ++x)
      {
        const int actor = lit.Id("actor", x, y);
        glm::dvec3 added(0.0);
        double slack = 0.0;
        if (actor >= 0)
        {
          const glm::dvec3 place = lit.Vector("position", x, y);
          const glm::dvec3 normal = lit.Vector("normal", x, y);
          const glm::dvec3 toEye = glm::normalize(glm::dvec3(eye[0], eye[1], eye[2]) - place);
          for (const Lamp& lamp : truth)
          {
            const double range = glm::distance(lamp.Place, place);
            const glm::dvec3 toLamp = (lamp.Place - place) / range;
            const double cosine = glm::dot(normal, toLamp);
            if (range < lamp.Radius && cosine > 0.0)
            {
              const glm::dvec3 light = lamp.Intensity * (1.0 - range / lamp.Radius) * lamp.Color;
              added += light * cosine * colors[actor];
              added += actor == 0 && gloss ? light * gloss(normal, toLamp, toEye) : glm::dvec3(0.0);
              // Colours have 10, 10 and 9 bits: half a step of the last, through the sRGB curve.
              slack += (light.x + light.y + light.z) * 2.3 / 1022.0;
            }
          }
        }
        for (int c = 0; c < 3; ++c)
        {
          const double expected = plain.Value("color", x, y, c) + added[c];
          const double off = std::abs(lit.Value("color", x, y, c) - expected);
          // Two roundings to half floats, which Mesa's software cuts.
          worst = std::max(worst, off / (4.0 / 1024.0 * (expected + 0.01) + slack));
          most = std::max(most, actor == 0 ? added[c] : 0.0);
        }
        RELIEVO_CHECK(lit.Value("color", x, y, 3) == plain.Value("color", x, y, 3));
      }
    }
    RELIEVO_CHECK_AT_MOST(worst, 1.0, what + ": linear colour, largest error of what is allowed");
    RELIEVO_CHECK(most > 0.05 || own == glm::dvec3(0.0));
  }
}

void TestMaterials()
{
  const glm::dvec3 color(LinearFromSrgb(0.3), LinearFromSrgb(0.9), LinearFromSrgb(0.5));
  CheckColor([](vtkProperty*) {}, color, "plain surfaces");
  CheckColor([](vtkProperty*) {}, color, "plain surfaces, one lamp", {}, 1);
  CheckColor([](vtkProperty* property) { property->SetDiffuse(0.6); }, 0.6 * color, "diffuse 0.6");
  CheckColor(
    [](vtkProperty* property) { property->LightingOff(); }, glm::dvec3(0.0), "no lighting");
}

void TestHighlights()
{
  const glm::dvec3 color(LinearFromSrgb(0.3), LinearFromSrgb(0.9), LinearFromSrgb(0.5));
  const glm::dvec3 shine(LinearFromSrgb(0.5), LinearFromSrgb(0.45), LinearFromSrgb(0.25));
  const auto shiny = [](vtkProperty* property) {
    property->SetSpecular(0.5);
    property->SetSpecularColor(1.0, 0.9, 0.5);
    property->SetSpecularPower(30.0);
  };
  const Gloss highlight = [&](const glm::dvec3& normal, const glm::dvec3& toLamp,
                            const glm::dvec3& toEye) {
    return shine * std::pow(std::max(0.0, glm::dot(glm::reflect(-toLamp, normal), toEye)), 30.0);
  };
  CheckColor(shiny, color, "Phong's highlight", highlight);
  CheckColor(shiny, color, "Phong's highlight, one lamp", highlight, 1);
  // A Lambertian surface of the same albedo as a white lamp's light is 1: pi times the radiance.
  const glm::dvec3 albedo(0.3, 0.9, 0.5);
  CheckColor(
    [](vtkProperty* property) {
      property->SetInterpolationToPBR();
      property->SetMetallic(0.4);
      property->SetRoughness(0.3);
    },
    glm::dvec3(1e-30), "PBR",
    [&](const glm::dvec3& n, const glm::dvec3& l, const glm::dvec3& v) {
      const glm::dvec3 h = glm::normalize(l + v);
      const double nh = glm::dot(n, h);
      const double nv = std::max(1e-5, glm::dot(n, v));
      const double nl = glm::dot(n, l);
      const double a2 = std::pow(0.3, 4.0);
      const double spread = nh * nh * (a2 - 1.0) + 1.0;
      const double shares = a2 / (spread * spread); // times pi
      const double k = 0.09; // VTK takes the roughness for its square root here
      const double hidden =
        0.5 / (nl * std::sqrt(k + nv * nv * (1.0 - k)) + nv * std::sqrt(k + nl * nl * (1.0 - k)));
      const glm::dvec3 f0 = 0.6 * 0.04 + 0.4 * albedo;
      // VTK's term for an edge without tint; here it is 1.
      const glm::dvec3 fresnel = f0 + (1.0 - f0) * std::pow(1.0 - glm::dot(h, l), 5.0);
      return nl * (0.6 * (1.0 - fresnel) * albedo + shares * hidden * fresnel);
    });
}

// The picture is the same bit for bit with and without layers of the lamps, in every way.
void TestRequestedLayers()
{
  for (const int count : { 1, 3, 6, 40 })
  {
    LampScene scene(60, 45);
    const auto lamps = scene.AddLamps(RandomLamps(count, count < 4 ? 6.0 : 2.0, false));
    for (const int way : { vtkRelievoLampsStage::AUTOMATIC, vtkRelievoLampsStage::QUADS,
           vtkRelievoLampsStage::CLUSTERS, vtkRelievoLampsStage::ALL })
    {
      scene.Stage->SetWay(way);
      const auto picture = scene.Read({ "color" });
      const int taken = scene.Stage->GetWayTaken();
      for (const char* layer : { "light", "lamps_reaching" })
      {
        const auto with = scene.Read({ "color", layer });
        vtkDataArray* colors[2] = { picture->GetPointData()->GetArray("color"),
          with->GetPointData()->GetArray("color") };
        vtkIdType different = 0;
        for (vtkIdType i = 0; i < colors[0]->GetNumberOfTuples(); ++i)
        {
          for (int c = 0; c < 3; ++c)
          {
            different += colors[0]->GetComponent(i, c) != colors[1]->GetComponent(i, c) ? 1 : 0;
          }
        }
        RELIEVO_CHECK_THAT(different == 0 && scene.Stage->GetWayTaken() == taken,
          std::to_string(count) + " lamps, way " + std::to_string(way) + ", " + layer + ": " +
            std::to_string(different) + " components differ");
      }
    }
  }
}

// Words alone are wanted of the frame where it has no light to add.
void TestCost()
{
  LampScene scene(64, 48);
  scene.Window->Render();
  RELIEVO_CHECK(scene.Frame->GetBytesHeld() == 0);
  RELIEVO_CHECK(scene.Stage->GetReasonCode() == "idle");
  vtkNew<vtkRelievoLamps> lamps;
  scene.Stage->AddPoints(lamps);
  scene.Window->Render();
  RELIEVO_CHECK(scene.Frame->GetBytesHeld() == 0);
  lamps->SetInputData(ToPolyData(RandomLamps(3, 1.0, true)));
  scene.Window->Render();
  const long long pixels = 64 * 48;
  // The linear colour with its depth, three words of the G-buffer, in four on a GPU; as quads, a
  // sum of one float with a depth as well.
  const long long texel = vtkRelievoIsSoftwareOpenGL() ? 16 : 8;
  const long long color = (texel + 4) + texel;
  const long long words = vtkRelievoIsSoftwareOpenGL() ? 12 : 16;
  const long long lists = 3 * 8 * 4 + 4 * 4;
  RELIEVO_CHECK_NEAR(static_cast<double>(scene.Frame->GetBytesHeld()),
    static_cast<double>(pixels * (color + words) + lists), 0.0, "bytes");
  scene.Stage->SetWay(vtkRelievoLampsStage::QUADS);
  scene.Window->Render();
  RELIEVO_CHECK_NEAR(static_cast<double>(scene.Frame->GetBytesHeld()),
    static_cast<double>(pixels * (color + words + 4 + 4) + lists + 3 * 4 * 4), 0.0,
    "bytes of quads");
}
}

RELIEVO_TEST_CASE(testLampsPicture)
{
  relievoTest::Session session;
  TestMaterials();
  TestHighlights();
  TestRequestedLayers();
  TestCost();
  return session.Result();
}
}
