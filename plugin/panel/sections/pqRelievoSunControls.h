// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqRelievoSunControls
 * @brief The dock's section for the sun: on or off; by angles, or by date and place with a slider
 * for the time of day; brightness and fill. Below it, a button that adds a ground.
 */
#ifndef pqRelievoSunControls_h
#define pqRelievoSunControls_h

#include "pqRelievoControls.h"

namespace relievoQt
{
class SunEdit;
}

class QCheckBox;
class QPushButton;

class pqRelievoSunControls : public pqRelievoControls
{
  Q_OBJECT
  using Superclass = pqRelievoControls;

public:
  explicit pqRelievoSunControls(QWidget* parent = nullptr);

  void ShowState() override;
  void ShowScene() override;

private:
  void ShowPlace();

  QCheckBox* On;
  relievoQt::SunEdit* Rest; // shown while the sun is on
  QPushButton* Ground;
};

#endif
