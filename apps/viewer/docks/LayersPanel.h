// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The layer shown as the picture, and the values under the mouse.
 */
#ifndef LayersPanel_h
#define LayersPanel_h

#include "LayerWords.h"
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
  /// The values of the layer's first and last colour in the last picture.
  using RangeReader = std::function<std::array<double, 2>(bool waits)>;

  LayersPanel(Document* document, RangeReader read, QWidget* parent = nullptr);

  bool IsProbing() const;

  /// Shows a row for each layer; none for the background.
  void ShowValues(const std::vector<ProbeValue>& values);

  /// Updates after a new picture, in which these lights cast shadows.
  void Follow(const relievoQt::LightNames& lights);

Q_SIGNALS:
  void probing(bool on);

private:
  void AddColors(QGroupBox* shown);
  QString ExplainIdle(bool ofColors) const;
  void SetLayer(const std::string& layer);
  void Set(const char* parameter, const std::string& value);
  void AddLayer(const std::string& name, const QString& help);
  void ShowLayers();
  void ShowRange();
  void ShowSettings();

  RangeReader ReadRange;
  relievoQt::LightNames Lights;
  QComboBox* Layer;
  ColormapBox* Colormap;
  QCheckBox *Reversed, *Grey, *Probing;
  relievoQt::RangeEdit* Range;
  QTableWidget* Values;
};

/// Formats numbers: "1.25, 0, -3".
QString WriteValues(const ProbeValue& value);
}

#endif
