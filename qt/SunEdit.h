// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Edits the sun's position: by angles, or by date, time and place. The owner interprets the values.
 */
#ifndef SunEdit_h
#define SunEdit_h

#include <QWidget>

class QComboBox;
class QDateEdit;
class QLabel;

namespace relievoQt
{
class Number;

class SunEdit : public QWidget
{
  Q_OBJECT

public:
  explicit SunEdit(QWidget* parent = nullptr);

  bool IsByPlace() const;

  /// Shows the rows of the choice; call it after a change without a signal.
  void ShowRows();

  /// Text below the rows; empty hides it.
  void SetWords(const QString& words);

  /// The part of the day at this elevation, in degrees: "day" above 0, "civil twilight" above -6,
  /// "nautical twilight" above -12, "astronomical twilight" above -18, or "night".
  static QString NamePartOfDay(double elevation);

  /// Describes the sun's position: for date and place, "Day: the sun is 65.4° above the
  /// horizon, at azimuth 179.0°", or that it gives no light; for angles, a note if it shines from
  /// below.
  static QString WritePlace(double azimuth, double elevation, bool byPlace);

  /// Each emits its own signals. Angles are in degrees, the time in hours of the clock, the zone in
  /// hours ahead of universal time.
  QComboBox* By; // 0: angles, 1: date and place
  QDateEdit* Date;
  Number *Azimuth, *Elevation, *Time, *Latitude, *Longitude, *TimeZone;

private:
  QWidget *Angles, *Place;
  QLabel* Words;
};
}

#endif
