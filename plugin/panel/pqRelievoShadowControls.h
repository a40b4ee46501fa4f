// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqRelievoShadowControls
 * @brief The dock's section of shadows: on or off, method, map size, softness, strength.
 */
#ifndef pqRelievoShadowControls_h
#define pqRelievoShadowControls_h

#include "pqRelievoControls.h"

class QCheckBox;

class pqRelievoShadowControls : public pqRelievoControls
{
  Q_OBJECT
  using Superclass = pqRelievoControls;

public:
  explicit pqRelievoShadowControls(QWidget* parent = nullptr);

  void ShowState() override;

private:
  QCheckBox* On;
  QWidget* Rest; // shown while they are on
};

#endif
