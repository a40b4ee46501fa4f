// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The sun against published positions, from angles to directions and back, and its words.
#include "TestCase.h"
#include "ViewerTest.h"

#include "LightOptions.h"
#include "SunEdit.h"

#include <QtTest>

#include <cmath>
#include <utility>

namespace testViewerSun
{
using look::SunAngles;

class TestViewerSun : public QObject
{
  Q_OBJECT

private Q_SLOTS:
  // NREL's report on the Solar Position Algorithm (TP-560-34302, appendix A.5): 17 October 2003,
  // 12:30:30, 7 hours behind UTC, 39.742476 N, 105.1786 W: azimuth 194.34024, zenith 50.11162 with
  // 0.017 of refraction at a height of 1830 m.
  void published()
  {
    const look::LightChoice light =
      look::ParseLight("sun:2003-10-17T12:30:30-07:00,39.742476,-105.1786,size=1");
    QVERIFY(light.Time);
    const SunAngles angles = look::GetSunAngles(*light.Time);
    QVERIFY2(
      std::abs(angles.Azimuth - 194.340) < 0.03, qPrintable(QString::number(angles.Azimuth)));
    QVERIFY2(std::abs(angles.Elevation - (90.0 - 50.112 - 0.017)) < 0.03,
      qPrintable(QString::number(angles.Elevation)));
    QVERIFY(!light.IsNight());
    QVERIFY(look::ParseLight("sun:2003-10-17T23:30-07:00,39.742476,-105.1786").IsNight());
    QVERIFY(!look::ParseLight("sun:0,-1,0").IsNight()); // which lights from beneath
  }

  void words_data()
  {
    QTest::addColumn<QString>("words");
    for (const char* words : { "2026-06-21T15:30+02:00,48.1,11.6", "1999-12-31T00:00-03:30,-90,0",
           "2024-02-29T24:00Z,0.125,-180", "2026-01-02T03:04:05+14:00,90,180" })
    {
      QTest::newRow(words) << QString(words);
    }
  }

  // Written words are read as the same.
  void words()
  {
    QFETCH(QString, words);
    QCOMPARE(
      QString::fromStdString(look::WriteSunTime(look::ParseSunTime("", words.toStdString()))),
      words);
  }

  void directions()
  {
    using Direction = std::array<double, 3>;
    const auto same = [](const Direction& a, const Direction& b) {
      return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) < 1e-12;
    };
    const SunAngles east = { 90.0, 0.0 }, north = { 0.0, 0.0 }, above = { 0.0, 90.0 };
    QVERIFY(same(look::GetSunDirection(east, 1), { 1, 0, 0 }));
    QVERIFY(same(look::GetSunDirection(north, 0), { 0, 0, 1 }));
    QVERIFY(same(look::GetSunDirection(north, 1), { 0, 0, -1 }));
    QVERIFY(same(look::GetSunDirection(north, 2), { 0, 1, 0 }));
    for (int axis = 0; axis < 3; ++axis)
    {
      Direction up = { 0, 0, 0 };
      up[axis] = 1.0;
      QVERIFY(same(look::GetSunDirection(above, axis), up));
      const SunAngles back = look::GetSunAngles(look::GetSunDirection({ 222.0, 33.0 }, axis), axis);
      QVERIFY(std::abs(back.Azimuth - 222.0) < 1e-9 && std::abs(back.Elevation - 33.0) < 1e-9);
    }
  }

  // Texts for users, in the viewer and in ParaView.
  void sayings()
  {
    using relievoQt::SunEdit;
    for (const auto& [elevation, text] : { std::pair(-2.34, "Civil twilight: the sun is 2.3"),
           std::pair(-8.34, "Nautical twilight: the sun is 8.3"),
           std::pair(-12.34, "Astronomical twilight: the sun is 12.3"),
           std::pair(-18.34, "Night: the sun is 18.3") })
    {
      QVERIFY2(SunEdit::WritePlace(180.0, elevation, true).startsWith(text), text);
    }
    QVERIFY(SunEdit::WritePlace(180.0, 12.34, true).startsWith("Day: the sun is 12.3"));
    QVERIFY(SunEdit::WritePlace(180.0, -12.34, false).contains("from beneath"));
    QVERIFY(SunEdit::WritePlace(180.0, 12.34, false).isEmpty());
  }
};

RELIEVO_TEST_CASE_APART(testViewerSun)
{
  TestViewerSun tests;
  return viewerTest::Run(tests, argc, argv);
}
}

#include "testViewerSun.moc"
