// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The layer that is shown as the picture, and the values under the mouse.
 */
#ifndef LayersPanel_h
#define LayersPanel_h

#include "Panel.h"
#include "Probe.h"

#include <array>
#include <functional>

class QCheckBox;
class QComboBox;
class QTableWidget;
namespace relievoQt
{
class RangeEdit;
}

namespace viewer
{
class ColormapBox;

class LayersPanel : public Panel
{
  Q_OBJECT

public:
  /// What the first and the last colour of the layer stand for in the last picture.
  using RangeReader = std::function<std::array<double, 2>()>;

  LayersPanel(Document* document, RangeReader read, QWidget* parent = nullptr);

  bool IsProbing() const;

  /// One row for each layer; none if nothing is there.
  void ShowValues(const std::vector<ProbeValue>& values);

  /// The picture was drawn anew.
  void Follow();

Q_SIGNALS:
  void probing(bool on);

private:
  void AddColors(QGroupBox* shown);
  QString ExplainIdle(bool ofColors) const;
  void SetLayer(const std::string& layer);
  void Set(const char* parameter, const std::string& value);
  void ShowLayers();
  void ShowSettings();

  RangeReader ReadRange;
  QComboBox* Layer;
  ColormapBox* Colormap;
  QCheckBox *Reversed, *Grey, *Probing;
  relievoQt::RangeEdit* Range;
  QTableWidget* Values;
};

/// Numbers as they are read aloud: "1.25, 0, -3".
QString WriteValues(const ProbeValue& value);
}

#endif
