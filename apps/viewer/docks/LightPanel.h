// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Lighting: lights, the environment, shadows and lamps.
 */
#ifndef LightPanel_h
#define LightPanel_h

#include "Panel.h"
#include "Values.h"

class QCheckBox;
class QLabel;

namespace relievoQt
{
class Number;
}

namespace viewer
{
class FileEdit;
class LightsGroup;
class SurfaceValues;

class LightPanel : public Panel
{
  Q_OBJECT

public:
  explicit LightPanel(Document* document, QWidget* parent = nullptr);

  LightsGroup* GetLights() { return this->Lights; }

private:
  void AddEnvironment();
  void SwitchEnvironment(bool on);
  void SetFile(const std::string& file, double rotation);
  words::NamedWords GetMirrorValues() const;
  void ShowSettings();

  LightsGroup* Lights;
  FoldGroup* Environment;
  QLabel* Hint;
  FileEdit* File;
  relievoQt::Number *Rotation, *Reflectivity, *Roughness;
  QCheckBox* Sky;
  SurfaceValues* Values;
  bool Waiting = false;          // switched on without an image; not in the words yet
  scene::Settings Saved;         // the environment while it is switched off
  words::NamedWords SavedMirror; // the reflection's values with it
};
}

#endif
