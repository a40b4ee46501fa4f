// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where lamps fail: values that are none, lamps at the eye, on the near plane, on a surface, all in
// one pixel or behind; arrays that do not fit; small viewports; and that nothing stays of them.
#include "Check.h"
#include "GLCheck.h"
#include "LampScenes.h"
#include "Layers.h"
#include "Session.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkCamera.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>

#include <limits>
#include <string>

namespace testLampsFailures
{
namespace
{
using namespace relievoTest;

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();
const glm::dvec3 White(1.0);
const std::vector<std::string> Needed{ "light", "depth", "range", "position", "normal" };
const int Ways[] = { vtkRelievoLampsStage::QUADS, vtkRelievoLampsStage::CLUSTERS,
  vtkRelievoLampsStage::ALL };

void CheckWays(LampScene& scene, const std::vector<Lamp>& lamps, const std::string& what)
{
  const auto set = scene.AddLamps(lamps);
  for (const int way : Ways)
  {
    scene.Stage->SetWay(way);
    CheckLight(scene.Read(Needed), lamps, vtkRelievoLamps::LINEAR, glm::dvec3(1.0, 0.0, 0.0),
      what + ", way " + std::to_string(way));
  }
  scene.Stage->RemovePoints(set);
}

void TestPlaces()
{
  LampScene scene(90, 70);
  const glm::dvec3 eye(2.5, 3.0, 6.0);
  const glm::dvec3 forward = glm::normalize(glm::dvec3(0.0, 0.5, 0.0) - eye);
  CheckWays(scene, { { eye, 8.0, 1.0, White } }, "at the eye");
  CheckWays(scene, { { eye + 1.0 * forward, 7.0, 1.0, White } }, "on the near plane");
  CheckWays(scene, { { eye - 2.0 * forward, 9.0, 1.0, White } }, "behind the eye, reaching");
  CheckWays(scene, { { glm::dvec3(0.0), 1.0, 1.0, White } }, "on the floor");
  CheckWays(scene, { { glm::dvec3(0.0, 0.3, 0.0), 1.0, -2.0, White } }, "darkness");
  CheckWays(scene, { { glm::dvec3(0.0, 0.3, 0.0), 1e9, 1.0, White } }, "a radius of 1e9");
  CheckWays(scene, { { glm::dvec3(0.0, 1e-4, 0.0), 1e-3, 1.0, White } }, "a radius of 1e-3");
  std::vector<Lamp> many(20000, { glm::dvec3(0.0, 0.4, 0.0), 0.9, 1e-3, White });
  CheckWays(scene, many, "20000 lamps at one place");

  std::vector<Lamp> behind(100, { eye - 5.0 * forward, 1.0, 1.0, White });
  const auto set = scene.AddLamps(behind);
  scene.Read(Needed);
  RELIEVO_CHECK(scene.Stage->GetNumberOfLamps() == 100);
  RELIEVO_CHECK(scene.Stage->GetNumberDrawn() == 0);
}

void TestValues()
{
  LampScene scene(90, 70);
  const std::vector<Lamp> good{ { glm::dvec3(0.0, 0.6, 1.0), 2.0, 1.0, White } };
  std::vector<Lamp> all = good;
  for (const double bad : { NaN, Infinity, -Infinity })
  {
    all.push_back({ glm::dvec3(0.0, bad, 1.0), 2.0, 1.0, White });
    all.push_back({ glm::dvec3(0.0, 0.6, 1.0), bad, 1.0, White });
    all.push_back({ glm::dvec3(0.0, 0.6, 1.0), 2.0, bad, White });
    all.push_back({ glm::dvec3(0.0, 0.6, 1.0), 2.0, 1.0, glm::dvec3(0.0, bad, 1.0) });
  }
  all.push_back({ glm::dvec3(0.0, 0.6, 1.0), 0.0, 1.0, White });
  all.push_back({ glm::dvec3(0.0, 0.6, 1.0), -2.0, 1.0, White });
  all.push_back({ glm::dvec3(0.0, 0.6, 1.0), 2.0, 0.0, White });
  all.push_back({ glm::dvec3(0.0, 0.6, 1.0), 2.0, 1.0, glm::dvec3(1.0, -0.5, 0.0) });
  const auto set = scene.AddLamps(all);
  RELIEVO_CHECK(CheckLight(scene.Read(Needed), good, vtkRelievoLamps::LINEAR, White,
                  "among lamps that are none") > 0);
  RELIEVO_CHECK(set->GetNumberOfPoints() == 1);
  RELIEVO_CHECK(set->GetNumberLeftOut() == 16);
}

// An array that does not fit is said once, in words that have `text`; one value is taken for all.
void CheckArray(vtkAbstractArray* array, const std::string& text)
{
  vtkSmartPointer<vtkPolyData> data =
    ToPolyData({ { glm::dvec3(0.0), 1.0, 1.0, White }, { White, 1.0, 1.0, White } });
  if (array)
  {
    array->SetName("size");
    data->GetPointData()->AddArray(array);
  }
  vtkNew<vtkRelievoLamps> set;
  set->SetRadius(7.0);
  set->SetArray("radius", "size");
  set->SetInputData(data);
  const ExpectMessage expect("array 'size', asked for the radius, " + text);
  RELIEVO_CHECK(set->GetNumberOfPoints() == 2);
  data->Modified();
  RELIEVO_CHECK(set->GetNumberOfPoints() == 2);
  RELIEVO_CHECK(expect.Count() == 1);
  RELIEVO_CHECK(set->GetRows()[3] == 7.0);
}

void TestArrays()
{
  CheckArray(nullptr, "is not among the point arrays");
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(2);
  CheckArray(vectors, "has 3 components");
  vtkNew<vtkDoubleArray> few;
  few->SetNumberOfTuples(1);
  CheckArray(few, "has 1 values for 2 points");
  vtkNew<vtkStringArray> words;
  words->SetNumberOfTuples(2);
  CheckArray(words, "holds no numbers");

  vtkNew<vtkRelievoLamps> set;
  RELIEVO_CHECK(set->GetNumberOfPoints() == 0);
  vtkNew<vtkPolyData> nothing;
  set->SetInputData(nothing);
  RELIEVO_CHECK(set->GetNumberOfPoints() == 0);
  {
    const ExpectMessage expect("no value 'size'; expected one of radius, intensity, color, casts");
    set->SetArray("size", "radius");
  }
  // Colours of bytes, with unused opacity; integers as radius; ghosts.
  vtkSmartPointer<vtkPolyData> data =
    ToPolyData({ { glm::dvec3(0.0), 1.0, 1.0, White }, { White, 1.0, 1.0, White } });
  vtkNew<vtkUnsignedCharArray> bytes;
  bytes->SetName("color");
  bytes->SetNumberOfComponents(4);
  bytes->InsertNextTuple4(255, 0, 51, 7);
  bytes->InsertNextTuple4(255, 0, 51, 7);
  data->GetPointData()->AddArray(bytes);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName("vtkGhostType");
  ghosts->InsertNextValue(0);
  ghosts->InsertNextValue(vtkDataSetAttributes::DUPLICATEPOINT);
  data->GetPointData()->AddArray(ghosts);
  set->SetInputData(data);
  RELIEVO_CHECK(set->GetNumberOfPoints() == 1);
  RELIEVO_CHECK(set->GetNumberLeftOut() == 0);
  RELIEVO_CHECK_NEAR(set->GetRows()[5], 1.0, 0.0, "red");
  RELIEVO_CHECK_NEAR(set->GetRows()[6], 0.0, 0.0, "green");
  RELIEVO_CHECK_NEAR(set->GetRows()[7], 0.2, 1e-15, "blue");
}

void TestSizes()
{
  const std::vector<Lamp> lamps = RandomLamps(50, 1.5, false);
  const int sizes[][2] = { { 1, 1 }, { 1, 3 }, { 37, 5 }, { 500, 3 } };
  for (const auto& size : sizes)
  {
    LampScene scene(size[0], size[1]);
    CheckWays(scene, lamps, std::to_string(size[0]) + " x " + std::to_string(size[1]) + " pixels");
  }
}

// On, off, other sizes, other ways: the same pictures, and nothing held that is not needed.
void TestToggles()
{
  LampScene scene(120, 90);
  GLCheck gl(scene.Window);
  vtkSmartPointer<vtkImageData> plain = Picture(scene.Window);
  vtkNew<vtkRelievoLamps> set;
  set->SetInputData(ToPolyData(RandomLamps(200, 1.0, false)));
  RELIEVO_CHECK(scene.Frame->GetBytesHeld() == 0);
  scene.Stage->AddPoints(set);
  vtkSmartPointer<vtkImageData> lit = Picture(scene.Window);
  RELIEVO_CHECK(FailuresOf([&]() { SamePicture(plain, lit, "lit"); }) > 0);
  const vtkIdType bytes = scene.Frame->GetBytesHeld();
  RELIEVO_CHECK(bytes > 0);
  GLObjects objects;
  for (int i = 0; i < 200; ++i)
  {
    switch (i % 4)
    {
      case 0:
        scene.Stage->RemovePoints(set);
        scene.Window->Render();
        RELIEVO_CHECK(scene.Frame->GetBytesHeld() == 0);
        scene.Stage->AddPoints(set);
        break;
      case 1:
        scene.Stage->SetWay(i % 3 + 1);
        scene.Window->Render();
        scene.Stage->SetWay(vtkRelievoLampsStage::AUTOMATIC);
        break;
      case 2:
        scene.Window->SetSize(60 + i % 7, 50);
        scene.Window->Render();
        scene.Window->SetSize(120, 90);
        break;
      default:
        scene.Stage->EnabledOff();
        scene.Window->Render();
        RELIEVO_CHECK(scene.Frame->GetBytesHeld() == 0);
        scene.Stage->EnabledOn();
    }
    scene.Window->Render();
    RELIEVO_CHECK(scene.Frame->GetBytesHeld() == bytes);
    const GLObjects now = CountGLObjects(scene.Window);
    if (i == 20)
    {
      objects = now;
    }
    RELIEVO_CHECK(i <= 20 || now.Bytes <= objects.Bytes);
  }
  SamePicture(lit, Picture(scene.Window), "after 200 changes");
  scene.Stage->RemoveAllPoints();
  SamePicture(plain, Picture(scene.Window), "without lamps again");
  gl.Poll("end of the test");
}
}

RELIEVO_TEST_CASE(testLampsFailures)
{
  relievoTest::Session session;
  TestPlaces();
  TestValues();
  TestArrays();
  TestSizes();
  TestToggles();
  return session.Result();
}
}
