// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Where light comes from, and how: the sun, other lights, the environment; shadows and lamps.
 */
#ifndef LightPanel_h
#define LightPanel_h

#include "Panel.h"
#include "Values.h"

class QCheckBox;
class QLabel;
class QPlainTextEdit;
class QPushButton;

namespace relievoQt
{
class Number;
}

namespace viewer
{
class FileEdit;
class SunGroup;
class SurfaceValues;

class LightPanel : public Panel
{
  Q_OBJECT

public:
  explicit LightPanel(Document* document, QWidget* parent = nullptr);

  SunGroup* GetSun() { return this->Sun; }

private:
  void AddLights();
  void ApplyLights();
  void AddEnvironment();
  void SwitchEnvironment(bool on);
  void SetFile(const std::string& file, double rotation);
  scene::NamedWords GetMirrorValues() const;
  void ShowSettings();
  void ShowLights();

  SunGroup* Sun;
  QPlainTextEdit* Lights;
  QLabel* Wrong;
  QPushButton *Apply, *Revert;
  std::vector<std::string> ShownLights; // without what is typed
  FoldGroup* Environment;
  FileEdit* File;
  relievoQt::Number *Rotation, *Reflectivity, *Roughness;
  QCheckBox* Sky;
  SurfaceValues* Values;
  scene::Settings Kept;         // the environment while it is switched off
  scene::NamedWords KeptMirror; // and what it is mirrored by
};
}

#endif
