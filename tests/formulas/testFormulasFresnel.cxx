// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The reflected share of light: Schlick's formula, its limits from straight above and at grazing
// angles, its difference to Fresnel's equations, and the reduction by roughness.
#include "Check.h"
#include "Samples.h"
#include "Session.h"
#include "TestCase.h"
#include "vtkRelievoFormulas.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace testFormulasFresnel
{
namespace
{
using namespace relievoTest;
namespace f32 = relievo::f32;
namespace f64 = relievo::f64;

constexpr double Radians = 0.017453292519943295769;
const double Shares[] = { 0., 0.02, 0.04, 0.17, 0.5, 0.9, 1. };

// R0 + (1 - R0) (1 - cos)^5.
double Schlick(double straight, double cosine)
{
  return straight + (1. - straight) * std::pow(1. - cosine, 5);
}

// Fresnel's equations for unpolarised light from air on glass of this index.
double Fresnel(double index, double cosine)
{
  const double within = std::sqrt(1. - (1. - cosine * cosine) / (index * index));
  const double s = (cosine - index * within) / (cosine + index * within);
  const double p = (index * cosine - within) / (index * cosine + within);
  return 0.5 * (s * s + p * p);
}

void TestSchlick()
{
  double apart = 0.;
  double rounded = 0.;
  for (const double straight : Shares)
  {
    double last = -1.;
    for (int i = 0; i <= 9000; ++i)
    {
      const double cosine = std::cos(Radians * 0.01 * i);
      const double share = f64::relievoFresnel(straight, cosine, 0.);
      apart = std::max(apart, std::abs(share - Schlick(straight, cosine)));
      const float single =
        f32::relievoFresnel(static_cast<float>(straight), static_cast<float>(cosine), 0.f);
      rounded = std::max(rounded, std::abs(single - Schlick(straight, cosine)));
      RELIEVO_CHECK(share >= last && share >= straight && share <= 1.);
      last = share;
    }
    RELIEVO_CHECK(f64::relievoFresnel(straight, 1., 0.) == straight);
    RELIEVO_CHECK_NEAR(f64::relievoFresnel(straight, 0., 0.), 1., 1e-15, "at 90 degrees");
    RELIEVO_CHECK_NEAR(f32::relievoFresnel(static_cast<float>(straight), 0.f, 0.f), 1., 1e-7,
      "at 90 degrees, float");
    // Beyond both ends of the range: as at them.
    RELIEVO_CHECK(f64::relievoFresnel(straight, -0.3, 0.) == f64::relievoFresnel(straight, 0., 0.));
    RELIEVO_CHECK(f64::relievoFresnel(straight, 1.5, 0.) == straight);
  }
  RELIEVO_CHECK_AT_MOST(apart, 2e-15, "double against Schlick's formula");
  RELIEVO_CHECK_AT_MOST(rounded, 3e-7, "float against Schlick's formula");
}

// Glass mirrors 4 % straight from above; Schlick keeps within a few per cent of the light.
void TestFresnel()
{
  const double straight = Fresnel(1.5, 1.);
  RELIEVO_CHECK_NEAR(straight, 0.04, 1e-12, "glass from straight above");
  double apart = 0.;
  for (int i = 0; i <= 900; ++i)
  {
    const double cosine = std::cos(Radians * 0.1 * i);
    apart =
      std::max(apart, std::abs(f64::relievoFresnel(straight, cosine, 0.) - Fresnel(1.5, cosine)));
  }
  RELIEVO_CHECK_AT_MOST(apart, 0.036, "glass: off Fresnel's equations, share of the light");
}

// At grazing angles a rough surface mirrors 1 - roughness, but never less than from above.
void TestRoughness()
{
  double apart = 0.;
  for (const double straight : Shares)
  {
    for (const double roughness : { 0., 0.1, 0.5, 0.97, 1. })
    {
      const double grazing = std::max(1. - roughness, straight);
      RELIEVO_CHECK_NEAR(
        f64::relievoFresnel(straight, 0., roughness), grazing, 1e-15, "rough, at 90 degrees");
      RELIEVO_CHECK(f64::relievoFresnel(straight, 1., roughness) == straight);
      for (int i = 0; i <= 900; ++i)
      {
        const double cosine = std::cos(Radians * 0.1 * i);
        const double share = f64::relievoFresnel(straight, cosine, roughness);
        // Schlick's formula, its rise made smaller.
        const double rise = straight < 1.
          ? (Schlick(straight, cosine) - straight) / (1. - straight) * (grazing - straight)
          : 0.;
        apart = std::max(apart, std::abs(share - straight - rise));
      }
    }
  }
  RELIEVO_CHECK_AT_MOST(apart, 1e-15, "rough, double against Schlick's formula");
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testFormulasFresnel)
{
  relievoTest::Session session;
  TestSchlick();
  TestFresnel();
  TestRoughness();
  return session.Result();
}
}
