// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Colours of meshes: by an array's values, with component and range, or one colour for all.
 */
#ifndef ColorsGroup_h
#define ColorsGroup_h

#include "Colormaps.h"
#include "Document.h"
#include "FoldGroup.h"

#include <array>
#include <functional>
#include <optional>

class QCheckBox;
class QComboBox;
class QPushButton;
class QSpinBox;
namespace relievoQt
{
class RangeEdit;
}

namespace viewer
{
class ColorButton;
class ColormapBox;
class StopsEdit;

class ColorsGroup : public FoldGroup
{
  Q_OBJECT

public:
  /// The present values of the first and last colour, if values give the colours.
  using RangeReader = std::function<std::optional<std::array<double, 2>>(bool waits)>;

  /// `readSeen`: reads the visible range of the array that gives the colours.
  ColorsGroup(
    Document* document, RangeReader read, RangeReader readSeen, QWidget* parent = nullptr);

Q_SIGNALS:
  /// Depth, normals or other layers were looked for among the arrays.
  void layersWanted();

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void AddMap();
  void AddRange();
  bool HasValues(const QString& name, const QString& component) const;
  void SetColorBy(const QString& name, const QString& component);
  void TakeMap();
  void ChangeMap(const std::function<void(look::Colormap&)>& change);
  void ShowMap(const std::string& word);
  void ShowStops();
  void ShowFound();
  void SetRange(const std::string& words);
  void SwitchRange(bool automatic);
  void Paint();
  void ShowArrays();
  void EnableLayersRow(bool enabled);
  void ShowSettings();
  void ShowComponents(const std::string& name, const QString& component);

  Document* Edited;
  RangeReader ReadRange, ReadSeen;
  QComboBox *ColorBy, *Component;
  ColormapBox* Colormap;
  QCheckBox *Reversed, *Log;
  QSpinBox* Steps;
  StopsEdit* Stops;
  ColorButton* Nan;
  relievoQt::RangeEdit* Range;
  QCheckBox* Symmetric;
  QPushButton* Seen;
  QCheckBox *Bar, *Solid;
  QComboBox* BarPlace;
  ColorButton* Color;
};
}

#endif
