// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqRelievoShadowControls
 * @brief The dock's section for shadows: on or off, soft or not, strength; folded, their method.
 * Below them, the reason why no shadow is visible, and a remedy.
 */
#ifndef pqRelievoShadowControls_h
#define pqRelievoShadowControls_h

#include "pqRelievoControls.h"

class QCheckBox;
class QLabel;

class pqRelievoShadowControls : public pqRelievoControls
{
  Q_OBJECT
  using Superclass = pqRelievoControls;

public:
  explicit pqRelievoShadowControls(QWidget* parent = nullptr);

  void ShowState() override;
  void ShowScene() override;

private:
  void AddSoft(QWidget* parent);
  void AddMethods(QWidget* parent);
  QString FindHint() const;

  QCheckBox* On;
  QWidget* Rest; // shown while shadows are on
  QCheckBox* Soft;
  QWidget* Softness; // shown while they are soft
  QLabel* Hint;
};

#endif
