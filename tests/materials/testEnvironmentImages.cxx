// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Images that are no environment, and values that are no light, where a skybox shows them.
#include "Check.h"
#include "GLCheck.h"
#include "Session.h"
#include "Stage.h"
#include "Surroundings.h"
#include "TestCase.h"

#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkPointData.h>
#include <vtkRelievoEnvironment.h>
#include <vtkRelievoSkybox.h>
#include <vtkTextureObject.h>

#include <cmath>

namespace testEnvironmentImages
{
namespace
{
using namespace relievoTest;

struct Scene
{
  relievoTest::Stage Stage{ 80, 60 };
  vtkRenderWindow* Window = this->Stage.Window;
  vtkNew<vtkRelievoEnvironment> Environment;
  vtkNew<vtkRelievoSkybox> Sky;
  std::vector<unsigned char> Plain = Photo(this->Window).Bytes;
  GLCheck Watch{ this->Window };

  Scene()
  {
    this->Sky->SetEnvironment(this->Environment);
    this->Stage.Renderer->AddViewProp(this->Sky);
  }
  bool ShowsNothing() { return Photo(this->Window).Bytes == this->Plain; }
  glm::dvec3 Middle() { return Photo(this->Window).At(40, 30); }
};

vtkSmartPointer<vtkImageData> Grey(int width, int height, int depth, double value)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, depth);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  image->GetPointData()->GetScalars()->Fill(value);
  return image;
}

void TestShapes()
{
  Scene scene;
  RELIEVO_CHECK_THAT(scene.ShowsNothing(), "no image: nothing is shown");
  {
    ExpectMessage expect("5 x 4 x 1 points");
    scene.Environment->SetImage(Grey(5, 4, 1, 200.));
    RELIEVO_CHECK_THAT(scene.ShowsNothing(), "a wrong shape: nothing");
    scene.Environment->SetRotation(1.);
    RELIEVO_CHECK_THAT(scene.ShowsNothing(), "a wrong shape, turned: nothing");
    RELIEVO_CHECK_THAT(expect.Count() == 1, "said once");
  }
  {
    ExpectMessage expect("n x n x 6 was expected");
    scene.Environment->SetProjection(vtkRelievoEnvironment::CUBE);
    scene.Environment->SetImage(Grey(8, 4, 1, 200.));
    RELIEVO_CHECK_THAT(scene.ShowsNothing(), "said to be a cube: nothing");
    scene.Environment->SetProjection(vtkRelievoEnvironment::AUTOMATIC);
  }
  {
    ExpectMessage expect("no scalars");
    vtkNew<vtkImageData> image;
    image->SetDimensions(4, 4, 6);
    scene.Environment->SetImage(image);
    RELIEVO_CHECK_THAT(scene.ShowsNothing(), "no scalars: nothing");
  }
  {
    ExpectMessage expect("reduced to");
    const int limit =
      vtkTextureObject::GetMaximumTextureSize(vtkOpenGLRenderWindow::SafeDownCast(scene.Window));
    scene.Environment->SetImage(Grey(limit + 2, limit / 2 + 1, 1, 200.));
    RELIEVO_CHECK_NEAR(255. * scene.Middle().x, 200., 0.01, "larger than OpenGL's limit");
  }
  scene.Environment->SetImage(nullptr);
  RELIEVO_CHECK_THAT(scene.ShowsNothing(), "no image again");
}

void TestValues()
{
  Scene scene;
  auto strange = MakeEnvironment([](const glm::dvec3&) { return glm::dvec3(0.5); }, Cube, 1);
  auto* values = vtkFloatArray::SafeDownCast(strange->GetPointData()->GetScalars());
  for (vtkIdType i = 0; i < 6; ++i)
  {
    values->SetTuple3(i, NAN, INFINITY, 0.5);
  }
  scene.Environment->SetImage(strange);
  const glm::dvec3 off = glm::abs(scene.Middle() - glm::dvec3(0., 1., 0.5));
  RELIEVO_CHECK_AT_MOST(std::max({ off.x, off.y, off.z }), 1. / 254., "NaN, infinity");
  scene.Environment->SetImage(Grey(2, 1, 1, 188.));
  RELIEVO_CHECK_NEAR(255. * scene.Middle().x, 188., 0.01, "grey bytes");
  scene.Environment->SRGBOn();
  // IEC 61966-2-1: ((188 / 255 + 0.055) / 1.055)^2.4.
  RELIEVO_CHECK_NEAR(255. * scene.Middle().x, 255. * 0.50289, 0.6, "grey bytes, sRGB");
}

void TestLevels()
{
  Scene scene;
  vtkNew<vtkMultiBlockDataSet> levels;
  levels->SetBlock(0, Grey(8, 8, 6, 200.));
  levels->SetBlock(1, Grey(4, 4, 6, 100.));
  levels->SetBlock(2, Grey(2, 2, 6, 50.));
  scene.Environment->SetLevels(levels);
  const double expected[5] = { 200., 150., 100., 75., 50. };
  for (int i = 0; i < 5; ++i)
  {
    scene.Sky->SetRoughness(i / 4.);
    RELIEVO_CHECK_NEAR(255. * scene.Middle().x, expected[i], 0.6, "a level, or two mixed");
  }
  scene.Environment->SetImage(Grey(2, 1, 1, 250.));
  scene.Sky->SetRoughness(0.);
  RELIEVO_CHECK_NEAR(255. * scene.Middle().x, 250., 0.01, "an image of its own is the sharp one");
  scene.Sky->SetRoughness(1.);
  RELIEVO_CHECK_NEAR(255. * scene.Middle().x, 50., 0.01, "and levels the rough ones");
  {
    ExpectMessage expect("half of the level before");
    vtkNew<vtkMultiBlockDataSet> invalid;
    invalid->SetBlock(0, Grey(8, 8, 6, 200.));
    invalid->SetBlock(1, Grey(3, 3, 6, 100.));
    scene.Environment->SetLevels(invalid);
    RELIEVO_CHECK_NEAR(255. * scene.Middle().x, 250., 0.01, "wrong levels: sharp");
    RELIEVO_CHECK(expect.Count() == 1);
  }
  {
    ExpectMessage expect("nine of three were expected");
    vtkNew<vtkDoubleArray> four;
    four->SetNumberOfTuples(4);
    scene.Environment->SetLevels(nullptr);
    scene.Environment->SetIrradiance(four);
    RELIEVO_CHECK_NEAR(255. * scene.Middle().x, 250., 0.01, "wrong coefficients");
  }
}
}

RELIEVO_TEST_CASE(testEnvironmentImages)
{
  relievoTest::Session session;
  TestShapes();
  TestValues();
  TestLevels();
  return session.Result();
}
}
