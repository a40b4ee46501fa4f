// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fog where it could fail: data that is no fog, eyes on and in spheres, sizes and places far apart,
// small and several viewports; and that switched off, or without data, it leaves no trace.
#include "Check.h"
#include "FogScene.h"
#include "GLCheck.h"
#include "Session.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkImageProperty.h>
#include <vtkImageSlice.h>
#include <vtkImageSliceMapper.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace testFogStability
{
namespace
{
using namespace relievoTest;

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();
const glm::dvec3 White(1.);
const FogSphere Good = { { 0., 0.5, 0.4 }, 0.6, 0.8, White };

void CheckAgainstTruth(FogScene& scene, const std::string& what, double limit = 1e-6)
{
  const FogErrors errors = scene.Compare();
  RELIEVO_CHECK_AT_MOST(errors.Transmittance, limit, what + ": what passes");
  RELIEVO_CHECK_AT_MOST(errors.Picture, 1.01, what + ": levels of 255");
}

void TestData()
{
  FogScene scene(60, 45);
  const auto plain = Picture(scene.Window);
  RELIEVO_CHECK(scene.Stage->GetReasonCode() == "idle" && scene.Frame->GetBytesHeld() == 0);

  scene.Set({ Good });
  const Layers expected = scene.Read({ "fog", "color" });
  scene.Set({ { { NaN, 0., 0. }, 1., 1., White }, { { 0., Infinity, 0. }, 1., 1., White },
    { { 0., 0., 0. }, NaN, 1., White }, { { 0., 0., 0. }, Infinity, 1., White },
    { { 0., 0., 0. }, 1., -Infinity, White }, { { 0., 0., 0. }, 1., 1., { NaN, 0., 0. } }, Good,
    { { 0., 0., 0. }, 1., 1., { 1., 0., -0.1 } }, { { 0., 0., 0. }, 0., 1., White },
    { { 0., 0., 0. }, -1., 1., White }, { { 0., 0., 0. }, 1., 0., White },
    { { 0., 0., 0. }, 1., -2., White } });
  CheckSame(expected, scene, "fog");
  RELIEVO_CHECK(scene.Fog->GetNumberLeftOut() == 11 && scene.Stage->GetNumberDrawn() == 1);

  // None at all: nothing is held, and the picture is VTK's own.
  scene.Set({ { { 0., 0., 0. }, 0., 1., White } });
  RELIEVO_CHECK(SamePicture(plain, Picture(scene.Window), "only one without a radius"));
  RELIEVO_CHECK(scene.Fog->GetNumberLeftOut() == 1);
  scene.Set({});
  RELIEVO_CHECK(SamePicture(plain, Picture(scene.Window), "no points"));
  scene.Fog->SetInputData(vtkNew<vtkPolyData>());
  RELIEVO_CHECK(SamePicture(plain, Picture(scene.Window), "empty polydata"));
  scene.Fog->SetInputData(nullptr);
  RELIEVO_CHECK(SamePicture(plain, Picture(scene.Window), "no data"));
  scene.Stage->RemoveAllPoints();
  RELIEVO_CHECK(SamePicture(plain, Picture(scene.Window), "no fog"));
  RELIEVO_CHECK(scene.Stage->GetBytesHeld() == 0 && scene.Frame->GetBytesHeld() == 0);

  // Blocks, and one value for all.
  CheckBlocks(scene, scene.Stage, scene.Fog, MakeFogPoints({ Good }),
    MakeFogPoints({ { { 5., 5., 5. }, -1., 1., White } }), expected, "fog");
  scene.Fog->SetRadius(Good.Radius);
  scene.Fog->SetDensity(Good.Density);
  CheckSame(expected, scene, "fog");
}

void TestArrays()
{
  FogScene scene(60, 45);
  const vtkSmartPointer<vtkPolyData> points = MakeFogPoints({ Good });
  vtkNew<vtkUnsignedCharArray> bytes;
  bytes->SetName("bytes");
  bytes->SetNumberOfComponents(4);
  bytes->InsertNextTuple4(255, 51, 0, 7);
  points->GetPointData()->AddArray(bytes);
  CheckWrongArrays(scene, scene.Fog, points,
    { { "radius", "size", "not among the point arrays" },
      { "density", "pairs", "has 2 components; needed: one number per point" },
      { "color", "density", "has 1 components; needed: red, green and blue" },
      { "radius", "words", "holds no numbers" } });
  {
    ExpectMessage expect("one of radius, density, color");
    scene.Fog->SetArray("colour", "density");
  }
  scene.Fog->SetArray("color", "bytes");
  scene.Window->Render();
  RELIEVO_CHECK_NEAR(scene.Fog->GetRows()[6], 0.2, 1e-12, "green of a byte 51");
}

void TestEyes()
{
  FogScene scene(61, 45);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  const glm::dvec3 eye(
    camera->GetPosition()[0], camera->GetPosition()[1], camera->GetPosition()[2]);
  GLCheck gl(scene.Window);
  scene.Set({ { eye, 0.3, 1.5, White } }); // all before the near plane
  CheckAgainstTruth(scene, "eye at the centre, near plane outside");
  scene.Set({ { eye, 2., 0.2, White } });
  CheckAgainstTruth(scene, "near plane inside");
  scene.Set({ { eye + glm::dvec3(0., 0., -1.), 1., 0.5, White } });
  CheckAgainstTruth(scene, "eye on the sphere, looking in");
  scene.Set({ { eye + glm::dvec3(0., 0., 1.), 1., 0.5, White } });
  CheckAgainstTruth(scene, "eye on the sphere, looking away");
  scene.Set({ { eye + glm::dvec3(1., 0., 0.), 1., 0.5, White } });
  CheckAgainstTruth(scene, "eye on the sphere, looking along");
  scene.Set({ { eye + glm::dvec3(0., 0., -0.02), 0.01, 50., White } });
  CheckAgainstTruth(scene, "between eye and near plane");
  camera->SetClippingRange(1e-6, 10.);
  scene.Set({ Good, { eye, 1e-3, 100., White } });
  CheckAgainstTruth(scene, "far / near 1e7");
}

void TestSizes()
{
  FogScene scene(61, 45);
  GLCheck gl(scene.Window);
  for (const double overlap : { 0, 1 })
  {
    scene.Stage->SetOverlap(static_cast<int>(overlap));
    scene.Set({ { { 1., 2., 3. }, 1e9, 0.1, { 0.5, 0.6, 0.7 } } });
    CheckAgainstTruth(scene, "radius 1e9");
    scene.Set({ { { 0., 0.6, 4.5 - 1e-3 }, 1e-6, 1e6, White }, Good });
    CheckAgainstTruth(scene, "radius 1e-6");
    scene.Set({ { { 0., 0.5, 0. }, 1., 1e300, { 0.5, 0.6, 0.7 } } });
    CheckAgainstTruth(scene, "density 1e300");
    scene.Set({ { { 0., 0.5, 0. }, 1e-300, 1., White }, { { 0., 0.5, 0. }, 1., 1e-300, White },
      { { 1e300, 0., 0. }, 1., 1., White }, Good });
    CheckAgainstTruth(scene, "hardly any");
  }
  // One pixel's ray hits the centre of a sphere smaller than a millionth of the pixel.
  scene.Renderer->GetActiveCamera()->SetPosition(0., 0.5, 4.5);
  scene.Set({ { { 0., 0.5, 3. }, 1e-6, 1e6, White } });
  const Layers layers = scene.Read({ "fog" });
  RELIEVO_CHECK_NEAR(layers.Value("fog", 30, 22), std::exp(-2.), 1e-5, "through 1e-6");
  RELIEVO_CHECK(layers.Value("fog", 31, 22) == 1.);
}

void TestPlaces()
{
  // Coordinates have steps of 2e-9 there.
  FogScene far(60, 45, glm::dvec3(1e7, -1e7, 1e7));
  GLCheck gl(far.Window);
  far.Set({ Good, { { 1.6, 1.5, 0. }, 0.3, 1.5, { 1., 1., 0. } } });
  CheckAgainstTruth(far, "at 1e7");

  FogScene small(1, 3);
  small.Set({ Good });
  CheckAgainstTruth(small, "1 x 3 pixels");
  RELIEVO_CHECK(small.Stage->GetNumberDrawn() == 1);

  // Two viewports of a window: each has its own fog, in its own pixels.
  FogScene one(60, 45);
  one.Set({ Good });
  FogScene both(120, 45);
  both.Renderer->SetViewport(0.5, 0., 1., 1.);
  both.Set({ Good });
  vtkNew<vtkRenderer> other;
  other->SetViewport(0., 0., 0.5, 1.);
  other->SetBackground(0.2, 0.3, 0.4);
  both.Window->AddRenderer(other);
  const Layers alone = one.Read({ "fog" });
  const Layers beside = both.Read({ "fog" });
  RELIEVO_CHECK(beside.Width == 60 && LargestDifference(alone, beside, "fog") < 1e-6);
  CheckBeside(one, both, { 5, 30, 31, 40 }, 22);
}

void TestToggles()
{
  FogScene scene(60, 45);
  scene.Stage->EnabledOff();
  const auto plain = Picture(scene.Window);
  RELIEVO_CHECK(scene.Frame->GetBytesHeld() == 0);
  scene.Stage->EnabledOn();
  scene.Set({ Good });
  const auto fogged = Picture(scene.Window);
  const vtkIdType held = scene.Frame->GetBytesHeld();
  RELIEVO_CHECK(held > 60 * 45 * 16 && scene.Stage->GetBytesHeld() == 60 * 45 * 16 + 128);
  CheckToggles(scene, scene.Stage, fogged, [&](int i) {
    // SUM, of frames that are judged again below.
    scene.Stage->SetOverlap(i % 3 == 0);
  });
  scene.Stage->EnabledOff();
  RELIEVO_CHECK(SamePicture(plain, Picture(scene.Window), "off"));
  RELIEVO_CHECK(scene.Frame->GetBytesHeld() == 0);
}

void TestRequests()
{
  FogScene scene(60, 45);
  scene.Set({ { { 100., 0., 0. }, 1., 1., White } });
  const Layers none = scene.Read({ "fog" });
  RELIEVO_CHECK(none.Value("fog", 30, 22) == 1. && scene.Stage->GetNumberDrawn() == 0);
  RELIEVO_CHECK(scene.Stage->GetDrawCalls() == 0);

  // The layer shown as the picture: white is all.
  scene.Set({ Good });
  scene.Frame->SetDisplayLayer("fog");
  const Layers layers = scene.Read({ "fog" });
  const auto shown = Picture(scene.Window);
  RELIEVO_CHECK_NEAR(shown->GetScalarComponentAsDouble(30, 22, 0, 1),
    255. * layers.Value("fog", 30, 22), 1., "shown as grey");
  scene.Frame->SetDisplayLayer(nullptr);

  // Parameters by name; unknown ones are refused with a message.
  RELIEVO_CHECK(scene.Stage->SetParameter("mode", "chord") && scene.Stage->GetMode() == 1);
  RELIEVO_CHECK(scene.Stage->SetParameter("overlap", "dominant"));
  RELIEVO_CHECK(!scene.Stage->TrySetParameter("mode", "linear").empty());

  // Without any fog all passes; a stage that is off makes no layer.
  scene.Stage->RemoveAllPoints();
  const Layers without = scene.Read({ "fog" });
  RELIEVO_CHECK(without.Value("fog", 30, 22) == 1. && without.Value("fog", 0, 0) == 1.);
  CheckOff(scene, "fog", "fog");
}

// Fog ends at surfaces, with or without layers, for any other request to the frame. Where z is too
// coarse for the fog, the layer of depths is used.
void TestDrawn()
{
  FogScene scene(60, 45);
  scene.Set({ Good });
  const auto open = Picture(scene.Window);
  RELIEVO_CHECK(scene.Frame->GetStage("gbuffer")->GetReasonCode() == "not_asked");
  vtkNew<vtkImageData> image;
  image->SetDimensions(8, 8, 1);
  image->SetSpacing(0.4, 0.4, 1.);
  image->SetOrigin(-1.4, -0.9, 0.8); // through the fog's front
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::fill_n(static_cast<unsigned char*>(image->GetScalarPointer()), 3 * 8 * 8, 0);
  vtkNew<vtkImageSliceMapper> mapper;
  mapper->SetInputData(image);
  vtkNew<vtkImageSlice> slice;
  slice->SetMapper(mapper);
  slice->GetProperty()->SetInterpolationTypeToNearest();
  scene.Renderer->AddViewProp(slice);
  const auto sliced = Picture(scene.Window);
  RELIEVO_CHECK(std::abs(open->GetScalarComponentAsDouble(30, 22, 0, 1) -
                  sliced->GetScalarComponentAsDouble(30, 22, 0, 1)) > 20.);
  scene.Frame->RequestLayer("depth");
  const auto asked = Picture(scene.Window);
  RELIEVO_CHECK(scene.Frame->GetStage("gbuffer")->GetReasonCode() == "ran");
  RELIEVO_CHECK(SamePicture(sliced, asked, "with the layer depth"));
  scene.Frame->ReleaseLayers();
  scene.Renderer->RemoveViewProp(slice);

  scene.Renderer->GetActiveCamera()->SetClippingRange(1e-4, 1e4);
  Picture(scene.Window);
  RELIEVO_CHECK(scene.Frame->GetStage("gbuffer")->GetReasonCode() == "ran");
  CheckAgainstTruth(scene, "a near plane of 1e-4");
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testFogStability)
{
  Session session;
  TestData();
  TestArrays();
  TestEyes();
  TestSizes();
  TestPlaces();
  TestToggles();
  TestRequests();
  TestDrawn();
  return session.Result();
}
}
