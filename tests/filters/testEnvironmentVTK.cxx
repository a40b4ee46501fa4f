// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Relievo's orientation is VTK's: the cube that vtkEquirectangularToCubeMapTexture makes is ours;
// vtkSkybox shows an equirectangular image, and a cube (since VTK 9.2 with OutputMirrored), where
// we say it is.
#include "Check.h"
#include "Environments.h"
#include "Session.h"
#include "TestCase.h"
#include "Window.h"
#include "vtkRelievoEnvironmentConvert.h"

#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkOpenGLError.h> // for the OpenGL symbols
#include <vtkOpenGLTexture.h>
#include <vtkPixelBufferObject.h>
#include <vtkPointData.h>
#include <vtkRelievoVTKVersions.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSkybox.h>
#include <vtkTextureObject.h>
#if __has_include(<vtkEquirectangularToCubeMapTexture.h>)
#include <vtkEquirectangularToCubeMapTexture.h>
#endif

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace testEnvironmentVTK
{
namespace
{
using namespace relievoTest;

// Colours between 0 and 1, different in every direction, without a turn or mirror that keeps them.
glm::dvec3 Shade(const glm::dvec3& d)
{
  return glm::dvec3(0.5 + 0.3 * d.x + 0.15 * d.y * d.z, 0.5 + 0.35 * d.y - 0.1 * d.x * d.z,
    0.5 - 0.4 * d.z + 0.05 * d.x);
}

vtkSmartPointer<vtkTexture> MakeTexture(vtkImageData* image)
{
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  texture->SetColorModeToDirectScalars();
  texture->InterpolateOn();
  return texture;
}

#if __has_include(<vtkEquirectangularToCubeMapTexture.h>)
void TestCubeMap()
{
  const vtkSmartPointer<vtkImageData> image = MakeEnvironment(Shade, Equirectangular, 128);
  vtkNew<vtkRenderer> renderer;
  const vtkSmartPointer<vtkRenderWindow> window = MakeWindow(32, 32, renderer);
  window->Render();
  vtkNew<vtkEquirectangularToCubeMapTexture> texture;
  const vtkSmartPointer<vtkTexture> input = MakeTexture(image);
  texture->SetInputTexture(vtkOpenGLTexture::SafeDownCast(input));
  texture->SetCubeMapSize(32);
  texture->Load(renderer);
  vtkNew<vtkRelievoEnvironmentConvert> filter;
  filter->SetInputData(image);
  filter->SetOutputSize(32);
  filter->Update();
  vtkDataArray* ours = filter->GetOutput()->GetPointData()->GetScalars();
  double worst = 0.;
  for (int face = 0; face < 6; ++face)
  {
    vtkSmartPointer<vtkPixelBufferObject> buffer;
    buffer.TakeReference(
      texture->GetTextureObject()->Download(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0));
    std::vector<float> theirs(32 * 32 * 3);
    unsigned int size[2] = { 32, 32 };
    vtkIdType increments[2] = { 0, 0 };
    if (!RELIEVO_CHECK(buffer && buffer->Download2D(VTK_FLOAT, theirs.data(), size, 3, increments)))
    {
      break;
    }
    for (vtkIdType i = 0; i < 32 * 32; ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        worst =
          std::max(worst, std::abs(theirs[3 * i + c] - ours->GetComponent(face * 32 * 32 + i, c)));
      }
    }
  }
  texture->ReleaseGraphicsResources(window);
  input->ReleaseGraphicsResources(window);
  // Theirs is a sample, with 0.1591 for 1 / (2 pi); ours is a mean.
  RELIEVO_CHECK_AT_MOST(worst, 0.004, "vtkEquirectangularToCubeMapTexture's cube against ours");
}
#endif

// The largest difference between a skybox's pictures along the six axes and the light.
double WorstOfPictures(vtkSkybox* skybox)
{
  constexpr int Size = 64;
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(skybox);
  const vtkSmartPointer<vtkRenderWindow> window = MakeWindow(Size, Size, renderer);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetViewAngle(70.);
  double worst = 0.;
  for (int axis = 0; axis < 6; ++axis)
  {
    glm::dvec3 ahead(0.);
    ahead[axis / 2] = axis % 2 ? -1. : 1.;
    const glm::dvec3 up = axis / 2 == 1 ? glm::dvec3(0., 0., 1.) : glm::dvec3(0., 1., 0.);
    const glm::dvec3 right = glm::cross(ahead, up);
    camera->SetPosition(0., 0., 0.);
    camera->SetFocalPoint(ahead.x, ahead.y, ahead.z);
    camera->SetViewUp(up.x, up.y, up.z);
    renderer->ResetCameraClippingRange();
    const vtkSmartPointer<vtkImageData> picture = Picture(window);
    for (int j = 0; j < Size; ++j)
    {
      for (int i = 0; i < Size; ++i)
      {
        const double half = std::tan(35. * 3.14159265358979 / 180.);
        const double x = half * ((i + 0.5) / Size * 2. - 1.);
        const double y = half * ((j + 0.5) / Size * 2. - 1.);
        const glm::dvec3 truth = Shade(glm::normalize(ahead + x * right + y * up));
        for (int c = 0; c < 3; ++c)
        {
          const double got = picture->GetScalarComponentAsDouble(i, j, 0, c) / 255.;
          worst = std::max(worst, std::abs(got - truth[c]));
        }
      }
    }
  }
  skybox->ReleaseGraphicsResources(window);
  return worst;
}

void TestSkybox()
{
  vtkNew<vtkSkybox> skybox;
  skybox->SetProjectionToSphere();
  skybox->SetFloorRight(0.f, 0.f, 1.f);
  skybox->SetTexture(MakeTexture(MakeEnvironment(Shade, Equirectangular, 256)));
  RELIEVO_CHECK_AT_MOST(WorstOfPictures(skybox), 0.01, "vtkSkybox of an equirectangular image");

  vtkNew<vtkRelievoEnvironmentConvert> filter;
  filter->SetInputData(MakeEnvironment(Shade, Equirectangular, 256));
  filter->SetOutputMirrored(RELIEVO_VTK_MIRRORED_CUBES);
  filter->Update();
  const int n = filter->GetOutput()->GetDimensions()[0];
  vtkDataArray* texels = filter->GetOutput()->GetPointData()->GetScalars();
  vtkNew<vtkTexture> cube;
  cube->CubeMapOn();
  cube->InterpolateOn();
  cube->SetColorModeToDirectScalars();
  for (int face = 0; face < 6; ++face)
  {
    vtkNew<vtkImageData> picture;
    picture->SetDimensions(n, n, 1);
    picture->AllocateScalars(VTK_FLOAT, 3);
    picture->GetPointData()->GetScalars()->InsertTuples(
      0, vtkIdType(n) * n, vtkIdType(face) * n * n, texels);
    cube->SetInputDataObject(face, picture);
  }
  vtkNew<vtkSkybox> box;
  box->SetProjectionToCube();
  box->SetTexture(cube);
  RELIEVO_CHECK_AT_MOST(WorstOfPictures(box), 0.01, "vtkSkybox of a cube");
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testEnvironmentVTK)
{
  Session session;
#if __has_include(<vtkEquirectangularToCubeMapTexture.h>)
  TestCubeMap();
#endif
  TestSkybox();
  return session.Result();
}
}
