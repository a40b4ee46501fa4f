// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Dithering of vtkRelievoToneStage: the mean of a patch of one colour, gradients without bands, the
// same thresholds on the GPU as in C++, and the spectrum that makes noise blue.
#include "Check.h"
#include "Session.h"
#include "TestCase.h"
#include "ToneScene.h"

#include <complex>
#include <set>
#include <string>
#include <vector>

namespace testToneDither
{
namespace
{
using relievoTest::IsSame;
using relievoTest::ToneScene;

constexpr int Side = 64;

double GetMean(vtkImageData* picture)
{
  const auto* bytes = static_cast<unsigned char*>(picture->GetScalarPointer());
  double sum = 0.;
  for (vtkIdType i = 0; i < picture->GetNumberOfPoints(); ++i)
  {
    sum += bytes[4 * i];
  }
  return sum / static_cast<double>(picture->GetNumberOfPoints());
}

void TestMeans()
{
  ToneScene scene(128, 128);
  double off[3] = { 0., 0., 0. };
  for (const double value : { 0.0011, 0.01, 0.0473, 0.18, 0.2, 0.35, 0.61, 0.9, 3.3 })
  {
    const auto light = static_cast<float>(value);
    scene.Paint->Fill(128, 128, glm::vec4(light, light, light, 1.f));
    for (int dither = 0; dither < 3; ++dither)
    {
      scene.Tone->SetDither(dither);
      const auto picture = scene.Picture();
      const double expected = scene.GetExpected(scene.Paint->Pixels[0]).x;
      off[dither] = std::max(off[dither], std::abs(GetMean(picture) - expected));
      // No pixel is a step away.
      RELIEVO_CHECK_AT_MOST(
        scene.GetError(picture), dither ? 1. : 0.501, "light " + std::to_string(value));
      RELIEVO_CHECK(IsSame(picture, scene.Picture()));
    }
  }
  RELIEVO_CHECK_AT_MOST(off[0], 0.501, "mean without dithering, steps of 255");
  RELIEVO_CHECK(off[0] > 0.3); // the patches are where rounding shows
  RELIEVO_CHECK_AT_MOST(off[1], 0.01, "mean of ordered dithering, steps of 255");
  RELIEVO_CHECK_AT_MOST(off[2], 0.01, "mean of blue noise, steps of 255");
}

// A gradient of 4 steps over 512 columns: bands of 128 columns without dithering.
void TestBands()
{
  ToneScene scene(512, 64);
  scene.Tone->SetOperatorToClamp();
  scene.Tone->SetExposure(1.0);
  scene.Paint->Fill(512, 64, glm::vec4(0.f));
  for (std::size_t i = 0; i < scene.Paint->Pixels.size(); ++i)
  {
    const double shown = (120. + 4. * static_cast<double>(i % 512) / 512.) / 255.;
    const auto light = static_cast<float>(0.5 * relievo::f64::relievoLinearFromSrgb(shown));
    scene.Paint->Pixels[i] = glm::vec4(light, light, light, 1.f);
  }
  double worst[3];
  for (int dither = 0; dither < 3; ++dither)
  {
    scene.Tone->SetDither(dither);
    const auto picture = scene.Picture();
    const auto* bytes = static_cast<unsigned char*>(picture->GetScalarPointer());
    worst[dither] = 0.;
    for (int block = 0; block < 512 / 16; ++block)
    {
      double apart = 0.;
      for (int y = 0; y < 64; ++y)
      {
        for (int x = 16 * block; x < 16 * block + 16; ++x)
        {
          apart += bytes[4 * (512 * y + x)] - scene.GetExpected(scene.Paint->Pixels[x]).x;
        }
      }
      worst[dither] = std::max(worst[dither], std::abs(apart) / (16. * 64.));
    }
  }
  RELIEVO_CHECK(worst[0] > 0.4);
  RELIEVO_CHECK_AT_MOST(worst[1], 0.05, "gradient, ordered: block's mean, steps of 255");
  RELIEVO_CHECK_AT_MOST(worst[2], 0.05, "gradient, blue noise: block's mean, steps of 255");
}

void TestThresholds()
{
  ToneScene scene(130, 70);
  scene.Tone->SetDitherToBlueNoise();
  const auto picture = scene.Picture();
  const double value = scene.GetExpected(scene.Paint->Pixels[0]).x;
  std::set<double> thresholds;
  for (int y = 0; y < 70; ++y)
  {
    for (int x = 0; x < 130; ++x)
    {
      const double threshold = vtkRelievoToneStage::GetBlueNoise(x, y);
      thresholds.insert(threshold);
      // But where the value meets the threshold to float's last bits.
      const double sum = value + threshold;
      const auto* pixel = static_cast<unsigned char*>(picture->GetScalarPointer(x, y, 0));
      RELIEVO_CHECK(std::abs(sum - std::round(sum)) < 1e-4 || pixel[0] == std::floor(sum));
    }
  }
  RELIEVO_CHECK(thresholds.size() == Side * Side);
  RELIEVO_CHECK(*thresholds.begin() == 0.5 / (Side * Side));
  RELIEVO_CHECK(*thresholds.rbegin() == 1. - 0.5 / (Side * Side));
  RELIEVO_CHECK(
    vtkRelievoToneStage::GetBlueNoise(-1, -65) == vtkRelievoToneStage::GetBlueNoise(63, 63));
}

// Power of the dots that a share of the thresholds makes, per frequency, in units of the mean over
// all frequencies but 0: the mean over those up to `to` cycles per tile.
double GetLowPower(const std::vector<double>& thresholds, double share, double to)
{
  using Complex = std::complex<double>;
  std::vector<Complex> rows(Side * Side);
  std::vector<Complex> turn(Side);
  for (int k = 0; k < Side; ++k)
  {
    turn[k] = std::polar(1., -6.283185307179586 * k / Side);
  }
  for (int y = 0; y < Side; ++y)
  {
    for (int u = 0; u < Side; ++u)
    {
      for (int x = 0; x < Side; ++x)
      {
        const double dot = thresholds[y * Side + x] < share ? 1. : 0.;
        rows[y * Side + u] += dot * turn[u * x % Side];
      }
    }
  }
  double all = 0.;
  double low = 0.;
  int count = 0;
  for (int v = 0; v < Side; ++v)
  {
    for (int u = 0; u < Side; ++u)
    {
      Complex sum = 0.;
      for (int y = 0; y < Side; ++y)
      {
        sum += rows[y * Side + u] * turn[v * y % Side];
      }
      const double frequency = std::hypot(std::min(u, Side - u), std::min(v, Side - v));
      const double power = frequency > 0. ? std::norm(sum) : 0.;
      all += power;
      if (frequency > 0. && frequency <= to)
      {
        low += power;
        ++count;
      }
    }
  }
  return low / count / (all / (Side * Side - 1));
}

void TestSpectrum()
{
  std::vector<double> blue(Side * Side);
  std::vector<double> white(Side * Side);
  std::mt19937 random(4);
  for (int i = 0; i < Side * Side; ++i)
  {
    blue[i] = vtkRelievoToneStage::GetBlueNoise(i % Side, i / Side);
    white[i] = static_cast<double>(random()) / 4294967296.;
  }
  for (const double share : { 1. / 16., 1. / 4., 1. / 2., 3. / 4., 15. / 16. })
  {
    // Dots of an even pattern have the principal frequency sqrt(share) per pixel, up to the grid's
    // own of a half; blue noise has next to nothing below half of it (Ulichney).
    const double rare = std::min(share, 1. - share);
    const double to = 0.5 * std::min(0.5, std::sqrt(rare)) * Side;
    RELIEVO_CHECK_AT_MOST(GetLowPower(blue, share, to), 0.1,
      "power of low frequencies, share " + std::to_string(share));
    RELIEVO_CHECK(GetLowPower(white, share, to) > 0.7);
  }
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testToneDither)
{
  relievoTest::Session session;
  TestMeans();
  TestBands();
  TestThresholds();
  TestSpectrum();
  return session.Result();
}
}
