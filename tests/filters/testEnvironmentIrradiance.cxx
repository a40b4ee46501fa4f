// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Spherical harmonics of environments: closed forms of constant light, gradients, quadratics and a
// cosine lobe; smooth light against sums over a fine sphere; a single sun; messages.
#include "Check.h"
#include "Environments.h"
#include "Session.h"
#include "TestCase.h"
#include "vtkRelievoEnvironmentIrradiance.h"

#include <vtkDataArray.h>
#include <vtkErrorCode.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkTable.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace testEnvironmentIrradiance
{
namespace
{
using namespace relievoTest;

constexpr double Pi = 3.14159265358979323846;
const char* Names[] = { "", "equirectangular", "cube", "sphere map" };

vtkSmartPointer<vtkRelievoEnvironmentIrradiance> Run(vtkImageData* image)
{
  auto filter = vtkSmartPointer<vtkRelievoEnvironmentIrradiance>::New();
  filter->SetInputData(image);
  filter->Update();
  RELIEVO_CHECK(filter->GetErrorCode() == vtkErrorCode::NoError);
  return filter;
}

std::vector<glm::dvec3> Normals()
{
  std::vector<glm::dvec3> normals;
  for (int i = 0; i < 6; ++i)
  {
    glm::dvec3 axis(0.);
    axis[i / 2] = i % 2 ? -1. : 1.;
    normals.push_back(axis);
  }
  for (int i = 0; i < 60; ++i)
  {
    // Evenly round a spiral.
    const double z = -1. + (2. * i + 1.) / 60.;
    const double a = 2.39996322972865 * i;
    const double r = std::sqrt(1. - z * z);
    normals.push_back({ r * std::cos(a), r * std::sin(a), z });
  }
  return normals;
}

glm::dvec3 IrradianceOf(vtkRelievoEnvironmentIrradiance* filter, const glm::dvec3& normal)
{
  double color[3];
  filter->GetIrradiance(&normal.x, color);
  return glm::dvec3(color[0], color[1], color[2]);
}

// Light of known irradiance, in all projections.
void TestClosedForms()
{
  const glm::dvec3 up = glm::normalize(glm::dvec3(0.3, 0.8, -0.5));
  const struct
  {
    const char* Name;
    Light Of;
    Light Irradiance; // by the normal
    double Limit;     // of its largest
  } cases[] = {
    { "constant", [](const glm::dvec3&) { return glm::dvec3(1., 2., 0.); },
      [](const glm::dvec3&) { return Pi * glm::dvec3(1., 2., 0.); }, 1e-6 },
    // A linear part keeps 2/3 of pi, a product of two different coordinates a quarter.
    { "gradient", [](const glm::dvec3& d) { return 1. + d; },
      [](const glm::dvec3& n) { return Pi * (1. + 2. / 3. * n); }, 2e-4 },
    { "quadratic",
      [](const glm::dvec3& d) {
        return 2. + glm::dvec3(d.x * d.y, d.y * d.z, d.x * d.x - d.y * d.y);
      },
      [](const glm::dvec3& n) {
        return Pi * (2. + 0.25 * glm::dvec3(n.x * n.y, n.y * n.z, n.x * n.x - n.y * n.y));
      },
      2e-4 },
    // A clamped cosine about `up` is 1/4 + c / 2 + 5 / 32 (3 c c - 1) and higher orders.
    { "cosine lobe",
      [&up](const glm::dvec3& d) { return glm::dvec3(std::max(0., glm::dot(d, up))); },
      [&up](const glm::dvec3& n) {
        const double c = glm::dot(n, up);
        return glm::dvec3(Pi * (0.25 + c / 3. + 5. / 128. * (3. * c * c - 1.)));
      },
      3e-4 },
  };
  for (const auto& one : cases)
  {
    for (const int projection : { Equirectangular, Cube, SphereMap })
    {
      const int n = projection == SphereMap ? 256 : 64;
      const auto filter = Run(MakeEnvironment(one.Of, projection, n));
      double worst = 0.;
      double largest = 0.;
      for (const glm::dvec3& normal : Normals())
      {
        const glm::dvec3 truth = one.Irradiance(normal);
        const glm::dvec3 off = glm::abs(IrradianceOf(filter, 3. * normal) - truth);
        worst = std::max({ worst, off.x, off.y, off.z });
        largest = std::max({ largest, truth.x, truth.y, truth.z });
      }
      // A sphere map's circle runs through texels, drawn out behind.
      const double limit = projection == SphereMap ? 1e-3 : one.Limit;
      RELIEVO_CHECK_AT_MOST(
        worst / largest, limit, std::string(one.Name) + ", " + Names[projection]);
    }
  }
}

// A sum over the texels of a fine cube, each with its exact solid angle.
template <typename Work>
glm::dvec3 OverSphere(Work work)
{
  const int size[3] = { 160, 160, 6 };
  glm::dvec3 sum(0.);
  for (int slice = 0; slice < 6; ++slice)
  {
    for (int row = 0; row < size[1]; ++row)
    {
      for (int column = 0; column < size[0]; ++column)
      {
        sum += SolidAngleOf(Cube, size, slice, column, row) *
          work(DirectionOf(Cube, size, slice, column + 0.5, row + 0.5));
      }
    }
  }
  return sum;
}

void TestSmooth()
{
  for (const int projection : { Equirectangular, Cube })
  {
    const auto filter = Run(MakeEnvironment(SmoothLight, projection, 128));
    double worst = 0.;
    for (const glm::dvec3& n : Normals())
    {
      const glm::dvec3 truth = OverSphere(
        [&n](const glm::dvec3& d) { return SmoothLight(d) * std::max(0., glm::dot(d, n)); });
      const glm::dvec3 off = glm::abs(IrradianceOf(filter, n) - truth) / truth;
      worst = std::max({ worst, off.x, off.y, off.z });
    }
    // Includes the light of orders from 4 on.
    RELIEVO_CHECK_AT_MOST(
      worst, 2e-3, std::string("smooth light, ") + Names[projection] + ": worst, relative");
  }
}

// Whatever the size, a texel's light arrives: the coefficients against its own direction.
void TestSun()
{
  for (const int n : { 1, 2, 7, 64 })
  {
    for (const int projection : { Equirectangular, Cube })
    {
      const vtkSmartPointer<vtkImageData> image =
        MakeEnvironment([](const glm::dvec3&) { return glm::dvec3(0.); }, projection, n);
      const vtkIdType place = image->GetNumberOfPoints() / 3;
      image->GetPointData()->GetScalars()->SetTuple3(place, 1e5, 0., 1.);
      const auto filter = Run(image);
      const int* size = image->GetDimensions();
      const auto column = static_cast<int>(place % size[0]);
      const auto row = static_cast<int>(place / size[0] % size[1]);
      const auto slice = static_cast<int>(place / size[0] / size[1]);
      double color[3];
      filter->GetCoefficient(0, color);
      const double flux = 1e5 * SolidAngleOf(projection, size, slice, column, row);
      const std::string name =
        std::string("sun, ") + Names[projection] + " of " + std::to_string(n);
      RELIEVO_CHECK_AT_MOST(
        std::abs(color[0] / (flux / std::sqrt(4. * Pi)) - 1.), 2e-5, name + ": its light");
      RELIEVO_CHECK_NEAR(color[2], color[0] * 1e-5, 1e-9 * color[0], name + ": blue");
      RELIEVO_CHECK(color[1] == 0.);
      // The linear part points at it: its middle, up to the bend of a large texel.
      double linear[3][3];
      for (int i = 0; i < 3; ++i)
      {
        filter->GetCoefficient(i + 1, linear[i]);
      }
      const glm::dvec3 at(linear[2][0], linear[0][0], linear[1][0]);
      const glm::dvec3 truth = DirectionOf(projection, size, slice, column + 0.5, row + 0.5);
      RELIEVO_CHECK_AT_MOST(glm::length(glm::normalize(at) - truth), n < 3 ? 1. : 0.05 / n,
        name + ": where it seems to be");
    }
  }
}

void TestTable()
{
  const auto filter = Run(MakeEnvironment(SmoothLight, Cube, 16));
  vtkDataArray* radiance =
    vtkDataArray::SafeDownCast(filter->GetOutput()->GetColumnByName("radiance"));
  if (RELIEVO_CHECK(radiance && radiance->GetNumberOfTuples() == 9))
  {
    for (int i = 0; i < 9; ++i)
    {
      double color[3];
      filter->GetCoefficient(i, color);
      for (int c = 0; c < 3; ++c)
      {
        RELIEVO_CHECK(color[c] == radiance->GetComponent(i, c));
      }
    }
  }
  double color[3] = { 1., 1., 1. };
  filter->GetCoefficient(9, color);
  RELIEVO_CHECK(color[0] == 0. && color[1] == 0. && color[2] == 0.);
  // Mirrored: the coefficients of odd powers of z change sign.
  vtkNew<vtkRelievoEnvironmentIrradiance> mirrored;
  mirrored->SetInputData(MakeEnvironment(SmoothLight, Cube, 16));
  mirrored->InputMirroredOn();
  mirrored->Update();
  for (int i = 0; i < 9; ++i)
  {
    double plain[3];
    double turned[3];
    filter->GetCoefficient(i, plain);
    mirrored->GetCoefficient(i, turned);
    const double sign = i == 2 || i == 5 || i == 7 ? -1. : 1.;
    RELIEVO_CHECK_NEAR(turned[1], sign * plain[1], 1e-12, "mirrored coefficient");
  }
}

void TestRefusals()
{
  vtkNew<vtkImageData> odd;
  odd->SetDimensions(5, 3, 1);
  odd->AllocateScalars(VTK_FLOAT, 3);
  vtkNew<vtkRelievoEnvironmentIrradiance> filter;
  filter->SetInputData(odd);
  {
    ExpectMessage expect("No irradiance: the image is 5 x 3 x 1");
    filter->Update();
    RELIEVO_CHECK(expect.Count() == 1);
  }
  RELIEVO_CHECK(filter->GetErrorCode() == vtkErrorCode::UserError);
  RELIEVO_CHECK(filter->GetOutput()->GetNumberOfRows() == 0);
  vtkNew<vtkImageData> empty;
  RELIEVO_CHECK(Run(empty)->GetOutput()->GetNumberOfRows() == 0);
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testEnvironmentIrradiance)
{
  Session session;
  TestClosedForms();
  TestSmooth();
  TestSun();
  TestTable();
  TestRefusals();
  return session.Result();
}
}
