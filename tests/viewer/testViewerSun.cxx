// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The sun against published positions, and from angles to directions and back.
#include "ViewerTest.h"

#include "Sun.h"

#include <QtTest>

#include <cmath>

using viewer::SunAngles;

class TestViewerSun : public QObject
{
  Q_OBJECT

private Q_SLOTS:
  // NREL's report on the Solar Position Algorithm (TP-560-34302, appendix A.5): 17 October 2003,
  // 12:30:30, 7 hours behind UTC, 39.742476 N, 105.1786 W: azimuth 194.34024, zenith 50.11162 with
  // 0.017 of refraction at a height of 1830 m.
  void published()
  {
    viewer::SunTime time;
    time.Year = 2003;
    time.Month = 10;
    time.Day = 17;
    time.Hour = 12.0 + 30.5 / 60.0;
    time.TimeZone = -7.0;
    time.Latitude = 39.742476;
    time.Longitude = -105.1786;
    const SunAngles angles = viewer::GetSunAngles(time);
    QVERIFY2(
      std::abs(angles.Azimuth - 194.340) < 0.03, qPrintable(QString::number(angles.Azimuth)));
    QVERIFY2(std::abs(angles.Elevation - (90.0 - 50.112 - 0.017)) < 0.03,
      qPrintable(QString::number(angles.Elevation)));
  }

  void directions()
  {
    using Direction = std::array<double, 3>;
    const auto same = [](const Direction& a, const Direction& b) {
      return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) < 1e-12;
    };
    const SunAngles east = { 90.0, 0.0 }, north = { 0.0, 0.0 }, above = { 0.0, 90.0 };
    QVERIFY(same(viewer::GetSunDirection(east, 1), { 1, 0, 0 }));
    QVERIFY(same(viewer::GetSunDirection(north, 0), { 0, 0, 1 }));
    QVERIFY(same(viewer::GetSunDirection(north, 1), { 0, 0, -1 }));
    QVERIFY(same(viewer::GetSunDirection(north, 2), { 0, 1, 0 }));
    for (int axis = 0; axis < 3; ++axis)
    {
      Direction up = { 0, 0, 0 };
      up[axis] = 1.0;
      QVERIFY(same(viewer::GetSunDirection(above, axis), up));
      const SunAngles back =
        viewer::GetSunAngles(viewer::GetSunDirection({ 222.0, 33.0 }, axis), axis);
      QVERIFY(std::abs(back.Azimuth - 222.0) < 1e-9 && std::abs(back.Elevation - 33.0) < 1e-9);
    }
    QCOMPARE(viewer::WriteSun(viewer::GetSunDirection(east, 1)), std::string("sun:1,0,0"));
  }
};

int main(int argc, char* argv[])
{
  TestViewerSun tests;
  return viewerTest::Run(tests, argc, argv);
}

#include "testViewerSun.moc"
