// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * How meshes and the background look.
 */
#ifndef LookPanel_h
#define LookPanel_h

#include "Panel.h"

class QCheckBox;
class QComboBox;

namespace viewer
{
class ColorButton;
class NumberEdit;

class LookPanel : public Panel
{
  Q_OBJECT

public:
  explicit LookPanel(Document* document, QWidget* parent = nullptr);

private:
  QComboBox* AddChoice(QGroupBox* group, const QString& title, const char* option);
  QCheckBox* AddFlag(QGroupBox* group, const QString& title, const char* option);
  void AddSurface();
  void AddBackground();
  void SetBackground();
  void ShowArrays();
  void ShowSettings();

  QComboBox *Shading, *ColorBy, *Colormap, *Background;
  QCheckBox *Bar, *Edges, *Solid;
  ColorButton *Color, *Bottom, *Top;
  NumberEdit* Opacity;
};
}

#endif
