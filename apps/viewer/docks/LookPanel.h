// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The look of meshes, the background and the picture, and every stage without another place.
 */
#ifndef LookPanel_h
#define LookPanel_h

#include "ColorsGroup.h"
#include "Panel.h"
#include "VolumeGroup.h"

class QCheckBox;
class QComboBox;

namespace relievoQt
{
class Number;
}

namespace viewer
{
class ColorButton;

class LookPanel : public Panel
{
  Q_OBJECT

public:
  LookPanel(Document* document, ColorsGroup::RangeReader range, ColorsGroup::RangeReader seen,
    VolumeGroup::Reader volume, QWidget* parent = nullptr);

private:
  void AddSurface();
  void AddBackground();
  void AddStages();
  void SetBackground();
  void ShowSettings();

  QComboBox *Shading, *Background;
  QCheckBox* Edges;
  ColorButton *Bottom, *Top;
  relievoQt::Number *Opacity, *PointSize;
};
}

#endif
