// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The sun: the first --light of kind sun, by angles or by date, time and place.
 */
#ifndef SunGroup_h
#define SunGroup_h

#include "Document.h"
#include "Sun.h"

#include <QGroupBox>

class QComboBox;
class QDateEdit;
class QFormLayout;
class QLabel;

namespace viewer
{
class NumberEdit;

class SunGroup : public QGroupBox
{
  Q_OBJECT

public:
  explicit SunGroup(Document* document, QWidget* parent = nullptr);

  ///@{
  /// Place and clock, which only the session keeps.
  SunTime GetTime() const;
  void SetTime(const SunTime& time, bool byTime);
  bool IsByTime() const;
  ///@}

  /// Another axis points up: a sun by time stands where it did in the sky, elsewhere in the data.
  void FollowUpAxis();

private:
  NumberEdit* AddNumber(const QString& title, const QString& name, double least, double most,
    double step, int decimals, const QString& unit, const QString& tip);
  void ShowSettings();
  void ShowRows();
  void ShowPlace(const SunAngles& angles);
  void Place();
  void Switch(bool on);

  Document* Edited;
  QFormLayout* Rows;
  QComboBox* By;
  QDateEdit* Date;
  QLabel* Words;
  NumberEdit *Azimuth, *Elevation, *Hour, *Latitude, *Longitude, *TimeZone;
  bool Placing = false;
};
}

#endif
