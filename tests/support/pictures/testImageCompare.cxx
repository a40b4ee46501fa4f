// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The image comparator accepts equal images, and above all rejects different ones.
#include "Check.h"
#include "ImageCompare.h"
#include "Session.h"
#include "TestCase.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

namespace testImageCompare
{
namespace
{
using relievoTest::GetLargestDifference;
using relievoTest::IsSame;

// A uniform grey picture; components 3 or 4, alpha 255.
vtkSmartPointer<vtkImageData> Grey(int width, int height, int level, int components = 3)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, components);
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      for (int c = 0; c < components; ++c)
      {
        image->SetScalarComponentFromDouble(x, y, 0, c, c == 3 ? 255. : level);
      }
    }
  }
  return image;
}

void TestDifferences()
{
  const auto image = Grey(20, 10, 60);
  const auto rgba = Grey(20, 10, 60, 4);
  RELIEVO_CHECK(GetLargestDifference(image, Grey(20, 10, 60)) == 0);
  RELIEVO_CHECK(IsSame(image, Grey(20, 10, 60)));
  RELIEVO_CHECK(GetLargestDifference(image, rgba) == 0 && !IsSame(image, rgba));
  for (const auto& changed : { Grey(20, 10, 60), rgba })
  {
    const int last = changed->GetNumberOfScalarComponents() - 1; // blue, alpha
    const double level = changed->GetScalarComponentAsDouble(19, 9, 0, last);
    changed->SetScalarComponentFromDouble(19, 9, 0, last, level - 7.);
    RELIEVO_CHECK(GetLargestDifference(image, changed) == 7);
    RELIEVO_CHECK(GetLargestDifference(changed, image) == 7);
    RELIEVO_CHECK(!IsSame(image, changed));
  }
  vtkNew<vtkImageData> empty;
  vtkNew<vtkImageData> floats;
  floats->SetDimensions(20, 10, 1);
  floats->AllocateScalars(VTK_FLOAT, 3);
  const auto other = Grey(10, 20, 60);
  for (vtkImageData* each : std::initializer_list<vtkImageData*>{ other, empty, floats, nullptr })
  {
    RELIEVO_CHECK(GetLargestDifference(image, each) == 256);
    RELIEVO_CHECK(GetLargestDifference(each, image) == 256);
  }
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testImageCompare)
{
  relievoTest::Session session;
  TestDifferences();
  return session.Result();
}
}
