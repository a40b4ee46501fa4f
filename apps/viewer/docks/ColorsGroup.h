// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Colours of meshes: by the values of an array, its component and their range, or one for all.
 */
#ifndef ColorsGroup_h
#define ColorsGroup_h

#include "Document.h"
#include "FoldGroup.h"

#include <array>
#include <functional>
#include <optional>

class QCheckBox;
class QComboBox;
class QLineEdit;

namespace viewer
{
class ColorButton;
class ColormapBox;

class ColorsGroup : public FoldGroup
{
  Q_OBJECT

public:
  /// Values that the first and the last colour stand for now, if values give the colours.
  using RangeReader = std::function<std::optional<std::array<double, 2>>()>;

  ColorsGroup(Document* document, RangeReader read, QWidget* parent = nullptr);

private:
  void AddRange();
  bool HasValues(const QString& name, const QString& component) const;
  void SetColorBy(const QString& name, const QString& component);
  void TakeMap(const QString& map);
  void ShowMap(const std::string& word);
  void SetRange();
  void SwitchRange(bool automatic);
  void Paint();
  void ShowArrays();
  void ShowSettings();
  void ShowComponents(const std::string& name, const QString& component);

  Document* Edited;
  RangeReader ReadRange;
  QComboBox *ColorBy, *Component;
  ColormapBox* Colormap;
  QCheckBox *Reversed, *Automatic;
  QLineEdit *Least, *Most;
  QCheckBox *Bar, *Solid;
  ColorButton* Color;
};
}

#endif
