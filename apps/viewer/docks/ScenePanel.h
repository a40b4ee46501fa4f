// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The scene: files, preset, up axis, ground, grid and scale bar, models with bones, the camera's
 * angle.
 */
#ifndef ScenePanel_h
#define ScenePanel_h

#include "Panel.h"

#include <vector>

class QCheckBox;
class QComboBox;
class QLabel;
class QVBoxLayout;

namespace relievoQt
{
class Number;
}

namespace viewer
{
class PathGroup;

class ScenePanel : public Panel
{
  Q_OBJECT

public:
  explicit ScenePanel(Document* document, QWidget* parent = nullptr);

  PathGroup* GetPath() { return this->Path; }

private:
  void AddFiles();
  void AddScene();
  void AddCamera();
  void ShowFiles();
  void ShowSettings();

  QVBoxLayout* FileRows;
  QLabel* NoFiles;
  std::vector<QLabel*> Files;
  QComboBox *Preset, *Up, *Ground, *ScaleBar, *Images;
  QCheckBox* Grid;
  relievoQt::Number* Angle;
  PathGroup* Path;
};
}

#endif
