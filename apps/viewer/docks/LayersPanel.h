// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The layer that is shown as the picture, and the values under the mouse.
 */
#ifndef LayersPanel_h
#define LayersPanel_h

#include "Panel.h"
#include "Probe.h"

class QCheckBox;
class QComboBox;
class QTableWidget;

namespace viewer
{
class LayersPanel : public Panel
{
  Q_OBJECT

public:
  explicit LayersPanel(Document* document, QWidget* parent = nullptr);

  bool IsProbing() const;

  /// One row for each layer; none if nothing is there.
  void ShowValues(const std::vector<ProbeValue>& values);

Q_SIGNALS:
  void probing(bool on);

private:
  void ShowLayers();
  void ShowSettings();

  QComboBox* Layer;
  QCheckBox *Grey, *Probing;
  QTableWidget* Values;
};

/// Numbers as they are read aloud: "1.25, 0, -3".
QString WriteValues(const ProbeValue& value);
}

#endif
