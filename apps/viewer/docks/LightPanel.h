// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Where light comes from: presets, the sun, other lights, the environment.
 */
#ifndef LightPanel_h
#define LightPanel_h

#include "Panel.h"

class QCheckBox;
class QComboBox;
class QLineEdit;
class QPlainTextEdit;

namespace viewer
{
class NumberEdit;
class SunGroup;

class LightPanel : public Panel
{
  Q_OBJECT

public:
  explicit LightPanel(Document* document, QWidget* parent = nullptr);

  SunGroup* GetSun() { return this->Sun; }

private:
  void AddScene();
  void AddLights();
  void AddEnvironment();
  void ShowSettings();
  void SetEnvironment();

  SunGroup* Sun;
  QComboBox *Preset, *Up;
  QPlainTextEdit* Lights;
  QGroupBox* Environment;
  QLineEdit* File;
  NumberEdit *Rotation, *Reflectivity, *Roughness;
  QCheckBox* Sky;
  std::string KeptFile;
};
}

#endif
