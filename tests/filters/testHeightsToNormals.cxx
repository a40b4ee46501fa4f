// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Normals of height fields against those of the formulas the heights were made from: planes and
// paraboloids to the last digits, sums of sines within the stated errors; holes, borders, small
// images, number types, messages.
#include "Check.h"
#include "HeightFields.h"
#include "Refusal.h"
#include "Session.h"
#include "TestCase.h"
#include "vtkRelievoHeightsToNormals.h"

#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace testHeightsToNormals
{
namespace
{
using namespace relievoTest;
using Filter = vtkRelievoHeightsToNormals;

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

vtkSmartPointer<vtkImageData> Run(Filter* filter, vtkImageData* heights)
{
  filter->SetInputData(heights);
  filter->Update();
  RELIEVO_CHECK(filter->GetErrorCode() == vtkErrorCode::NoError);
  return filter->GetOutput();
}

void TestExact()
{
  // Heights in centimetres on a grid of 2 x 3 metres: HeightScale makes metres of them.
  const HeightField plane = { [](double x, double y) { return 70. * x - 45. * y + 123456.; },
    [](double, double) { return glm::dvec2(0.7, -0.45); } };
  const HeightField bowl = { [](double x, double y) { return x * x - 2. * y * y + 3. * x * y; },
    [](double x, double y) { return 0.01 * glm::dvec2(2. * x + 3. * y, -4. * y + 3. * x); } };
  const GridOf grid = { { 33, 21 }, { 2., 3. }, { 500000., 4500000. } };
  const GridOf small = { { 33, 21 }, { 2., 3. }, { -30., 10. } };
  vtkNew<Filter> filter;
  filter->SetHeightScale(0.01);
  for (const int kernel : { Filter::CENTRAL, Filter::SOBEL, Filter::FOURTH_ORDER })
  {
    filter->SetKernel(kernel);
    const std::string name = "kernel " + std::to_string(kernel);
    const NormalErrors flat =
      ErrorsOf(Run(filter, MakeHeights(plane, grid, VTK_DOUBLE)), plane, grid);
    RELIEVO_CHECK_AT_MOST(flat.Worst, 1e-5, name + ", plane far away, degrees");
    const NormalErrors bent =
      ErrorsOf(Run(filter, MakeHeights(bowl, small, VTK_DOUBLE)), bowl, small);
    RELIEVO_CHECK_AT_MOST(bent.Worst, 1e-5, name + ", paraboloid with its borders, degrees");
  }
}

struct Limit
{
  int Kernel;
  int Encoding;
  double TexelsPerWave;
  double Mean; // degrees
};

// Sums of three sines, the shortest of them with so many texels a wave, mean slope 0.5.
void TestSines()
{
  const Limit limits[] = {
    { Filter::CENTRAL, Filter::FLOAT, 85., 0.02 },
    { Filter::SOBEL, Filter::FLOAT, 128., 0.02 },
    { Filter::FOURTH_ORDER, Filter::FLOAT, 16., 0.02 },
    { Filter::CENTRAL, Filter::UNSIGNED_CHAR, 32., 0.3 },
    { Filter::SOBEL, Filter::UNSIGNED_CHAR, 32., 0.3 },
    { Filter::FOURTH_ORDER, Filter::UNSIGNED_CHAR, 16., 0.3 },
    { Filter::FOURTH_ORDER, Filter::UNSIGNED_SHORT, 16., 0.02 },
  };
  const char* kernels[] = { "central", "Sobel", "fourth order" };
  const char* encodings[] = { "float", "8 bits", "16 bits" };
  const GridOf grid = { { 512, 512 }, { 0.5, 0.5 }, { 0., 0. } };
  for (const Limit& limit : limits)
  {
    const HeightField sines = Sines(256., limit.TexelsPerWave * 0.5, 0.5);
    vtkNew<Filter> filter;
    filter->SetKernel(limit.Kernel);
    filter->SetEncoding(limit.Encoding);
    filter->WrapColumnsOn();
    filter->WrapRowsOn();
    const std::string name = std::string(kernels[limit.Kernel]) + ", " + encodings[limit.Encoding] +
      ", " + std::to_string(int(limit.TexelsPerWave)) + " texels a wave";
    const vtkSmartPointer<vtkImageData> heights = MakeHeights(sines, grid, VTK_FLOAT);
    const NormalErrors errors = ErrorsOf(Run(filter, heights), sines, grid);
    RELIEVO_CHECK_AT_MOST(errors.Mean, limit.Mean, name + ": mean degrees");
    RELIEVO_CHECK_AT_MOST(errors.SeamMean, 1.2 * errors.Mean, name + ": mean at the seam");
    RELIEVO_CHECK_AT_MOST(errors.Worst, 6. * limit.Mean, name + ": worst");
  }
}

// Without wrapping the border keeps the order of the error: half the step, a quarter of it.
void TestBorders()
{
  double last = 0.;
  for (const int texels : { 64, 128, 256 })
  {
    const GridOf grid = { { texels + 1, texels + 1 }, { 1. / texels, 1. / texels }, { 0.1, 0.2 } };
    const HeightField sines = Sines(1.3, 0.5, 0.5);
    vtkNew<Filter> filter;
    const NormalErrors errors =
      ErrorsOf(Run(filter, MakeHeights(sines, grid, VTK_DOUBLE)), sines, grid);
    RELIEVO_CHECK_AT_MOST(
      errors.SeamMean, 4. * errors.Mean, "open border against all texels, mean degrees");
    RELIEVO_CHECK(last == 0. || errors.SeamMean < 0.3 * last);
    last = errors.SeamMean;
  }
}

glm::dvec3 NormalAt(vtkImageData* normals, int i, int j)
{
  double n[3];
  normals->GetPointData()->GetArray("normal")->GetTuple(
    i + vtkIdType(j) * normals->GetDimensions()[0], n);
  return glm::dvec3(n[0], n[1], n[2]);
}

bool IsFlat(const glm::dvec3& n)
{
  return n == glm::dvec3(0., 0., 1.);
}

void TestHoles()
{
  const HeightField plane = { [](double x, double y) { return 0.5 * x + 0.25 * y; },
    [](double, double) { return glm::dvec2(0.5, 0.25); } };
  const GridOf grid = { { 12, 9 }, { 1., 1. }, { 0., 0. } };
  const glm::dvec3 whole = glm::normalize(glm::dvec3(-0.5, -0.25, 1.));
  const glm::dvec3 onlyX = glm::normalize(glm::dvec3(-0.5, 0., 1.));
  for (const int kernel : { Filter::CENTRAL, Filter::SOBEL, Filter::FOURTH_ORDER })
  {
    for (const double none : { NaN, double(std::numeric_limits<float>::infinity()) })
    {
      const vtkSmartPointer<vtkImageData> heights = MakeHeights(plane, grid, VTK_FLOAT);
      vtkDataArray* array = heights->GetPointData()->GetScalars();
      // A hole of one texel; a hole of 3 x 3 about a known texel; a column that is all unknown.
      array->SetComponent(3 + 4 * 12, 0, none);
      for (int j = 2; j < 5; ++j)
      {
        for (int i = 6; i < 9; ++i)
        {
          if (i != 7 || j != 3)
          {
            array->SetComponent(i + 12 * j, 0, none);
          }
        }
      }
      for (int j = 0; j < 9; ++j)
      {
        array->SetComponent(11 + 12 * j, 0, none);
      }
      vtkNew<Filter> filter;
      filter->SetKernel(kernel);
      const vtkSmartPointer<vtkImageData> normals = Run(filter, heights);
      for (int j = 0; j < 9; ++j)
      {
        for (int i = 0; i < 12; ++i)
        {
          const glm::dvec3 n = NormalAt(normals, i, j);
          RELIEVO_CHECK(std::abs(glm::length(n) - 1.) < 1e-6);
          const bool inHole = (i >= 6 && i < 9 && j >= 2 && j < 5) || i == 11;
          if (!inHole)
          {
            RELIEVO_CHECK_THAT(glm::length(n - whole) < 1e-6,
              "slope beside a hole at " + std::to_string(i) + ", " + std::to_string(j));
          }
        }
      }
      RELIEVO_CHECK(glm::length(NormalAt(normals, 3, 4) - whole) < 1e-6); // both sides are known
      RELIEVO_CHECK(IsFlat(NormalAt(normals, 7, 3)));                     // no neighbour is
      RELIEVO_CHECK(IsFlat(NormalAt(normals, 6, 2)));
      RELIEVO_CHECK(IsFlat(NormalAt(normals, 11, 4)));
      filter->WrapColumnsOn(); // the unknown column lies between known ones then
      const glm::dvec3 seam = NormalAt(Run(filter, heights), 11, 4);
      RELIEVO_CHECK(seam.x != 0. && seam.y == 0.);
    }
  }
  // Every height unknown.
  const HeightField none = { [](double, double) { return NaN; }, {} };
  vtkNew<Filter> filter;
  const vtkSmartPointer<vtkImageData> flat = Run(filter, MakeHeights(none, grid, VTK_DOUBLE));
  RELIEVO_CHECK(IsFlat(NormalAt(flat, 0, 0)) && IsFlat(NormalAt(flat, 5, 5)));
  // One row: no slope along y.
  const GridOf row = { { 12, 1 }, { 1., 1. }, { 0., 0. } };
  RELIEVO_CHECK(
    glm::length(NormalAt(Run(filter, MakeHeights(plane, row, VTK_FLOAT)), 0, 0) - onlyX) < 1e-6);
}

void TestSmall()
{
  const HeightField plane = { [](double x, double y) { return 3. * x - 2. * y; },
    [](double, double) { return glm::dvec2(3., -2.); } };
  for (const int wrap : { 0, 1 })
  {
    for (const int kernel : { Filter::CENTRAL, Filter::SOBEL, Filter::FOURTH_ORDER })
    {
      vtkNew<Filter> filter;
      filter->SetKernel(kernel);
      filter->SetWrapColumns(wrap);
      filter->SetWrapRows(wrap);
      const GridOf one = { { 1, 1 }, { 1., 1. }, { 0., 0. } };
      RELIEVO_CHECK(IsFlat(NormalAt(Run(filter, MakeHeights(plane, one, VTK_FLOAT)), 0, 0)));
      const GridOf two = { { 2, 2 }, { 1., 1. }, { 0., 0. } };
      const glm::dvec3 n = NormalAt(Run(filter, MakeHeights(plane, two, VTK_FLOAT)), 1, 0);
      // Two texels that go round are as far up as down.
      RELIEVO_CHECK(
        wrap ? IsFlat(n) : glm::length(n - glm::normalize(glm::dvec3(-3., 2., 1.))) < 1e-6);
    }
  }
  vtkNew<vtkImageData> empty;
  vtkNew<Filter> filter;
  RELIEVO_CHECK(Run(filter, empty)->GetNumberOfPoints() == 0);
}

void TestTypesAndOptions()
{
  const HeightField steps = { [](double x, double y) { return 3. * x + 5. * y; },
    [](double, double) { return glm::dvec2(3., 5.) / 8.; } };
  const GridOf grid = { { 16, 14 }, { 1., 1. }, { 0., 0. } };
  for (const int type :
    { VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT, VTK_INT, VTK_FLOAT, VTK_DOUBLE })
  {
    vtkNew<Filter> filter;
    filter->SetHeightScale(0.125);
    const NormalErrors errors = ErrorsOf(Run(filter, MakeHeights(steps, grid, type)), steps, grid);
    RELIEVO_CHECK_AT_MOST(errors.Worst, 1e-5, "type " + std::to_string(type) + ", degrees");
  }
  // The second component of another array than the scalars.
  const vtkSmartPointer<vtkImageData> image = MakeHeights(steps, grid, VTK_FLOAT);
  vtkNew<vtkDoubleArray> pair;
  pair->SetName("pair");
  pair->SetNumberOfComponents(2);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    pair->InsertNextTuple2(7., -image->GetPointData()->GetScalars()->GetComponent(i, 0));
  }
  image->GetPointData()->AddArray(pair);
  vtkNew<Filter> filter;
  filter->SetHeightScale(-0.125);
  filter->SetComponent(1);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "pair");
  RELIEVO_CHECK_AT_MOST(
    ErrorsOf(Run(filter, image), steps, grid).Worst, 1e-5, "second component, degrees");
  const glm::dvec3 up = NormalAt(filter->GetOutput(), 4, 4);
  filter->FlipGreenOn();
  const glm::dvec3 down = NormalAt(Run(filter, image), 4, 4);
  RELIEVO_CHECK(down.x == up.x && down.y == -up.y && down.z == up.z && up.y < -0.1);
  // Codes are those of the float normals, rounded.
  for (const int encoding : { Filter::UNSIGNED_CHAR, Filter::UNSIGNED_SHORT })
  {
    const double most = encoding == Filter::UNSIGNED_CHAR ? 255. : 65535.;
    filter->SetEncoding(encoding);
    const glm::dvec3 codes = NormalAt(Run(filter, image), 4, 4);
    RELIEVO_CHECK(filter->GetOutput()->GetScalarType() ==
      (encoding == Filter::UNSIGNED_CHAR ? VTK_UNSIGNED_CHAR : VTK_UNSIGNED_SHORT));
    RELIEVO_CHECK(codes == glm::floor((down * 0.5 + 0.5) * most + 0.5));
  }
  // Two slices are two maps.
  const vtkSmartPointer<vtkImageData> pile = MakeHeights(steps, grid, VTK_FLOAT);
  vtkDataArray* heights = pile->GetPointData()->GetScalars();
  pile->SetDimensions(16, 7, 2);
  heights->SetComponent(16 * 7, 0, 1e6);
  vtkNew<Filter> slices;
  const glm::dvec3 top = NormalAt(Run(slices, pile), 0, 6);
  RELIEVO_CHECK(glm::length(top - glm::normalize(glm::dvec3(-3., -5., 1.))) < 1e-6);
}

template <typename Spoil>
void MustRefuse(const std::string& words, Spoil spoil)
{
  const HeightField plane = { [](double x, double) { return x; }, {} };
  const vtkSmartPointer<vtkImageData> image =
    MakeHeights(plane, { { 4, 4 }, { 1., 1. }, { 0., 0. } }, VTK_FLOAT);
  vtkNew<Filter> filter;
  spoil(filter.Get(), image.Get());
  filter->SetInputData(image);
  CheckRefused(filter.Get(), words);
}

void TestRefusals()
{
  MustRefuse("Its point arrays are: none",
    [](Filter*, vtkImageData* image) { image->GetPointData()->Initialize(); });
  MustRefuse("Component is 1, but the heights have 1 component(s)",
    [](Filter* filter, vtkImageData*) { filter->SetComponent(1); });
  MustRefuse("spacing is 0", [](Filter*, vtkImageData* image) { image->SetSpacing(1., 0., 1.); });
  MustRefuse("not finite", [](Filter* filter, vtkImageData*) { filter->SetHeightScale(NaN); });
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testHeightsToNormals)
{
  Session session;
  TestExact();
  TestSines();
  TestBorders();
  TestHoles();
  TestSmall();
  TestTypesAndOptions();
  TestRefusals();
  return session.Result();
}
}
