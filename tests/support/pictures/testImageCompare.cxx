// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The image comparator accepts equal images, and above all rejects different ones.
#include "Check.h"
#include "ImageCompare.h"
#include "Session.h"
#include "TestCase.h"

#include <vtkImageData.h>
#include <vtkImageDifference.h>
#include <vtkNew.h>

#include <vtksys/SystemTools.hxx>

#include <cstdlib>
#include <iostream>

namespace testImageCompare
{
namespace
{
using relievoTest::CompareImages;
using relievoTest::ImageDifference;

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
      auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0));
      for (int c = 0; c < components; ++c)
      {
        pixel[c] = static_cast<unsigned char>(c == 3 ? 255 : level);
      }
    }
  }
  return image;
}

// Adds `amount` to one channel of the first `count` pixels.
void Disturb(vtkImageData* image, int count, int amount, int channel = 1)
{
  auto* pixels = static_cast<unsigned char*>(image->GetScalarPointer());
  const int components = image->GetNumberOfScalarComponents();
  for (int i = 0; i < count; ++i)
  {
    pixels[i * components + channel] += static_cast<unsigned char>(amount);
  }
}

void TestLimits()
{
  // 10000 pixels: 0.1 % is 10 of them.
  const auto expected = Grey(100, 100, 100);
  auto same = CompareImages(Grey(100, 100, 100), expected);
  RELIEVO_CHECK(same.Passed && same.Largest == 0 && same.Mean == 0. && same.Pixels == 0);

  auto atLimit = Grey(100, 100, 100);
  Disturb(atLimit, 10, 100);
  RELIEVO_CHECK(CompareImages(atLimit, expected).Passed);

  auto overShare = Grey(100, 100, 100);
  Disturb(overShare, 11, 100);
  const ImageDifference share = CompareImages(overShare, expected);
  RELIEVO_CHECK(!share.Passed && share.Comparable && share.Pixels == 11);
  RELIEVO_CHECK_NEAR(share.Mean, 11 * 100 / 30000., 1e-12, "mean of 11 disturbed pixels");

  // Exactly the threshold does not count; one level more does.
  auto atThreshold = Grey(100, 100, 100);
  Disturb(atThreshold, 100, 5);
  RELIEVO_CHECK(CompareImages(atThreshold, expected).Pixels == 0);
  auto overThreshold = Grey(100, 100, 100);
  Disturb(overThreshold, 100, 6);
  RELIEVO_CHECK(CompareImages(overThreshold, expected).Pixels == 100);
  RELIEVO_CHECK(!CompareImages(overThreshold, expected).Passed);

  // No pixel above the threshold, yet the mean is: 5000 * 3 / 30000 is the limit of 0.5.
  auto atMean = Grey(100, 100, 100);
  Disturb(atMean, 5000, 3);
  RELIEVO_CHECK(CompareImages(atMean, expected).Passed);
  auto overMean = Grey(100, 100, 100);
  Disturb(overMean, 5001, 3);
  const ImageDifference mean = CompareImages(overMean, expected);
  RELIEVO_CHECK(!mean.Passed && mean.Share == 0. && mean.Mean > 0.5);

  // Darker counts as much as lighter.
  auto darker = Grey(100, 100, 90);
  RELIEVO_CHECK(!CompareImages(darker, expected).Passed);
  RELIEVO_CHECK(CompareImages(darker, expected).Mean == 10.);

  relievoTest::ImageLimits none;
  none.MaxShare = 0.;
  none.Threshold = 0;
  none.MaxMean = 0.;
  auto oneLevel = Grey(100, 100, 100);
  Disturb(oneLevel, 1, 1);
  RELIEVO_CHECK(!CompareImages(oneLevel, expected, none).Passed);
  RELIEVO_CHECK(CompareImages(expected, expected, none).Passed);
}

void TestAlpha()
{
  const auto rgb = Grey(20, 20, 60);
  const auto rgba = Grey(20, 20, 60, 4);
  RELIEVO_CHECK(CompareImages(rgb, rgba).Passed);
  Disturb(rgba, 400, -55, 3);
  RELIEVO_CHECK(!CompareImages(rgb, rgba).Passed);
  const auto difference = relievoTest::TenfoldDifference(rgb, rgba);
  RELIEVO_CHECK(difference->GetScalarComponentAsDouble(0, 0, 0, 0) == 255.);
}

void TestTenfold()
{
  const auto expected = Grey(8, 8, 100);
  auto actual = Grey(8, 8, 100);
  Disturb(actual, 1, 7, 2);
  const auto difference = relievoTest::TenfoldDifference(actual, expected);
  RELIEVO_CHECK(difference->GetScalarComponentAsDouble(0, 0, 0, 2) == 70.);
  RELIEVO_CHECK(difference->GetScalarComponentAsDouble(0, 0, 0, 1) == 0.);
  RELIEVO_CHECK(difference->GetScalarComponentAsDouble(1, 0, 0, 2) == 0.);
  RELIEVO_CHECK(!relievoTest::TenfoldDifference(actual, Grey(8, 9, 100)));
}

void TestIncomparable()
{
  const auto image = Grey(20, 20, 60);
  const ImageDifference sizes = CompareImages(image, Grey(20, 21, 60));
  RELIEVO_CHECK(!sizes.Passed && !sizes.Comparable);
  RELIEVO_CHECK(sizes.Summary.find("20x20") != std::string::npos);
  RELIEVO_CHECK(sizes.Summary.find("20x21") != std::string::npos);
  RELIEVO_CHECK(!CompareImages(nullptr, image).Passed);
  RELIEVO_CHECK(!CompareImages(image, nullptr).Passed);
  vtkNew<vtkImageData> empty;
  RELIEVO_CHECK(!CompareImages(empty, empty).Passed);
  vtkNew<vtkImageData> floats;
  floats->SetDimensions(20, 20, 1);
  floats->AllocateScalars(VTK_FLOAT, 3);
  RELIEVO_CHECK(!CompareImages(floats, floats).Passed);
}

// VTK's own comparison accepts grey 96 for grey 200, at least in VTK 9.1 and 9.2; ours must not.
void TestWhatVTKDoesNotSee()
{
  const auto light = Grey(100, 100, 200);
  const auto dark = Grey(100, 100, 96);
  vtkNew<vtkImageDifference> peer;
  peer->SetInputData(light);
  peer->SetImageData(dark);
  peer->Update();
  std::cout << "vtkImageDifference, grey 200 against 96: error " << peer->GetThresholdedError()
            << "\n";
  const ImageDifference ours = CompareImages(light, dark);
  RELIEVO_CHECK(!ours.Passed && ours.Mean == 104. && ours.Share == 1.);
}

void TestBaseline()
{
  const std::string folder = relievoTest::OutputFolder();
  vtksys::SystemTools::PutEnv("RELIEVO_BASELINES=" + folder);
  const std::string stem = folder + "/picture";
  vtksys::SystemTools::RemoveFile(stem + ".png");
  const auto exists = [&](const char* kind) {
    return vtksys::SystemTools::FileExists(stem + kind, true);
  };

  bool missing = true;
  const int counted = relievoTest::FailuresOf(
    [&] { missing = relievoTest::CheckBaseline("picture", Grey(30, 20, 50)); });
  RELIEVO_CHECK_THAT(!missing && counted == 1, "a missing baseline must fail once");
  RELIEVO_CHECK(exists(".actual.png") && !exists(".expected.png") && !exists(".difference.png"));

  RELIEVO_CHECK(relievoTest::WriteImage(stem + ".png", Grey(30, 20, 50)));
  RELIEVO_CHECK(relievoTest::CheckBaseline("picture", Grey(30, 20, 50)));
  RELIEVO_CHECK_THAT(!exists(".actual.png"), "a pass must clear an earlier failure's pictures");

  bool different = true;
  RELIEVO_CHECK(relievoTest::FailuresOf([&] {
    different = relievoTest::CheckBaseline("picture", Grey(30, 20, 60));
  }) == 1);
  RELIEVO_CHECK(!different);
  RELIEVO_CHECK(exists(".actual.png") && exists(".expected.png") && exists(".difference.png"));
  const auto difference = relievoTest::ReadImage(stem + ".difference.png");
  RELIEVO_CHECK(difference && difference->GetScalarComponentAsDouble(3, 3, 0, 0) == 100.);

  std::string reason;
  RELIEVO_CHECK(!relievoTest::ReadImage(folder, &reason) && !reason.empty());
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testImageCompare)
{
  relievoTest::Session session;
  TestLimits();
  TestAlpha();
  TestTenfold();
  TestIncomparable();
  TestWhatVTKDoesNotSee();
  TestBaseline();
  return session.Result();
}
}
