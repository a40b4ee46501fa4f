// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqRelievoEnvironmentControls
 * @brief The dock's section for the environment: file, lit surfaces, skybox, rotation, intensity.
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
  QWidget* Rest; // shown if there is an environment
  QPushButton* Light;
  QCheckBox* Sky;
};

#endif
