// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqRelievoEnvironmentControls
 * @brief The dock's section of the environment: the file, the surfaces it lights, the sky,
 * rotation, intensity.
 */
#ifndef pqRelievoEnvironmentControls_h
#define pqRelievoEnvironmentControls_h

#include "pqRelievoControls.h"

class QCheckBox;
class QPushButton;
class QToolButton;

class pqRelievoEnvironmentControls : public pqRelievoControls
{
  Q_OBJECT
  using Superclass = pqRelievoControls;

public:
  explicit pqRelievoEnvironmentControls(QWidget* parent = nullptr);

  void ShowState() override;
  void ShowScene() override;

private:
  void Choose();

  QToolButton* File;
  QToolButton* None;
  QWidget* Rest; // shown while there is one
  QPushButton* Light;
  QCheckBox* Sky;
};

#endif
