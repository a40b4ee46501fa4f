// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Where the sun stands: by angles, or by date, time and place. What they make of it is their
 * owner's to say.
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

  /// Those of the choice, after a change of which no signal was sent.
  void ShowRows();

  /// Words below the rows; none hides them.
  void SetWords(const QString& words);

  /// Words on where the sun is: by date and place its angles, "Azimuth 179.0°, elevation 65.4°", or
  /// that it is night; by angles that it lights from beneath, where it does.
  static QString WritePlace(double azimuth, double elevation, bool byPlace);

  /// Each sends its own signals. Angles are in degrees, the time in hours of the clock, the zone in
  /// hours that the clock is ahead of universal time.
  QComboBox* By; // 0: angles, 1: date and place
  QDateEdit* Date;
  Number *Azimuth, *Elevation, *Time, *Latitude, *Longitude, *TimeZone;

private:
  QWidget *Angles, *Place;
  QLabel* Words;
};
}

#endif
