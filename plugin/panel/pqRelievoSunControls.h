// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqRelievoSunControls
 * @brief The dock's section of the sun: on or off; by angles, or by date and place with a slider
 * over the day; brightness and fill.
 */
#ifndef pqRelievoSunControls_h
#define pqRelievoSunControls_h

#include "pqRelievoControls.h"

class QCheckBox;
class QDateEdit;
class QLabel;

class pqRelievoSunControls : public pqRelievoControls
{
  Q_OBJECT
  using Superclass = pqRelievoControls;

public:
  explicit pqRelievoSunControls(QWidget* parent = nullptr);

  void ShowState() override;

private:
  pqRelievoNumber* AddNumber(QFormLayout* rows, const QString& title, pqRelievoNumber* number,
    const char* property, const char* tip);
  QWidget* MakeAngles();
  QWidget* MakeDateAndPlace();
  void ShowPlace();

  QCheckBox* On;
  QWidget* Rest; // shown while it is on
  QWidget* Angles;
  QWidget* DateAndPlace;
  QDateEdit* Date;
  QLabel* Clock;
  QLabel* Place; // where it stands, and whether that is night
};

#endif
