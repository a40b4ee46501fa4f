// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The watch over a test detects VTK's errors and warnings, failed checks, and objects left alive.
#include "Check.h"
#include "LeakCounter.h"
#include "Session.h"
#include "TestCase.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSphereSource.h>
#include <vtkTrivialProducer.h>

#include <limits>

namespace testSession
{
namespace
{
// `work` must count exactly `wanted` failures.
template <typename Work>
void MustFail(int wanted, const char* what, Work work)
{
  const int counted = relievoTest::FailuresOf(work);
  RELIEVO_CHECK_THAT(counted == wanted, what);
}

void TestChecks()
{
  MustFail(1, "false condition", [] { RELIEVO_CHECK(1 + 1 == 3); });
  MustFail(1, "above the limit", [] { RELIEVO_CHECK_AT_MOST(2., 1., "two"); });
  MustFail(1, "NaN is above every limit",
    [] { RELIEVO_CHECK_AT_MOST(std::numeric_limits<double>::quiet_NaN(), 1., "nan"); });
  MustFail(1, "far", [] { RELIEVO_CHECK_NEAR(2., 1., 0.5, "two"); });
  MustFail(1, "NaN is near nothing",
    [] { RELIEVO_CHECK_NEAR(std::numeric_limits<double>::quiet_NaN(), 1., 0.5, "nan"); });
  MustFail(1, "NaN is the worst of many", [] {
    double worst = 0.;
    for (const double each : { 0.5, std::numeric_limits<double>::quiet_NaN(), 0.2 })
    {
      worst = relievoTest::Larger(worst, each);
    }
    RELIEVO_CHECK_AT_MOST(worst, 1., "worst");
  });
  MustFail(0, "all well", [] {
    RELIEVO_CHECK(relievoTest::Larger(1., 2.) == 2. && relievoTest::Larger(2., 1.) == 2.);
    RELIEVO_CHECK(true);
    RELIEVO_CHECK_AT_MOST(1., 1., "one");
    RELIEVO_CHECK_NEAR(1.5, 1., 0.5, "near");
  });
  MustFail(1, "a mesh that is not there",
    [] { RELIEVO_CHECK(relievoTest::DataFile("no-such.off").empty()); });
}

void TestMessages()
{
  vtkNew<vtkTrivialProducer> object;
  MustFail(1, "error", [&] { vtkErrorWithObjectMacro(object, "an error of the test"); });
  MustFail(1, "warning", [&] { vtkWarningWithObjectMacro(object, "a warning of the test"); });
  MustFail(1, "generic warning", [] { vtkGenericWarningMacro("a generic warning of the test"); });
  MustFail(0, "expected error", [&] {
    relievoTest::ExpectMessage expect("expected words");
    vtkErrorWithObjectMacro(object, "some expected words here");
    vtkErrorWithObjectMacro(object, "and expected words again");
    RELIEVO_CHECK(expect.Count() == 2);
    RELIEVO_CHECK(expect.Messages()[1].find("again") != std::string::npos);
  });
  MustFail(1, "another error than the expected one", [&] {
    relievoTest::ExpectMessage expect("expected words");
    vtkErrorWithObjectMacro(object, "some expected words here");
    vtkErrorWithObjectMacro(object, "something else");
  });
  MustFail(1, "an expected error that does not come",
    [] { relievoTest::ExpectMessage expect("expected words"); });
}

void TestLeaks()
{
  RELIEVO_CHECK(relievoTest::CanCountObjects());
  const relievoTest::LeakCounter leaks;
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->Update();
  }
  RELIEVO_CHECK_THAT(leaks.Leaks().empty(), "a sphere and its pipeline: " + leaks.Leaks());
  vtkPolyData* left = vtkPolyData::New();
  RELIEVO_CHECK(leaks.Leaks().find("vtkPolyData: 1 more") != std::string::npos);
  left->Delete();
  RELIEVO_CHECK(leaks.Leaks().empty());
}

void TestResult()
{
  MustFail(1, "an object left alive fails the session", [] {
    vtkPolyData* left = nullptr;
    relievoTest::Session* inner = new relievoTest::Session;
    left = vtkPolyData::New();
    RELIEVO_CHECK(inner->Result() == 1);
    left->Delete();
    delete inner;
  });
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testSession)
{
  {
    relievoTest::Session session;
    TestChecks();
    TestMessages();
    TestLeaks();
    session.Allow("words that may come");
    vtkGenericWarningMacro("some words that may come");
    if (session.Result() != 0)
    {
      return 1;
    }
  }
  TestResult();
  relievoTest::Session session;
  return session.Result();
}
}
