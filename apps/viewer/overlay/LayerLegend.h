// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Explains the colours of a layer shown as the picture, or why it is empty. Saved pictures do not
 * contain it.
 */
#ifndef LayerLegend_h
#define LayerLegend_h

#include "LayerWords.h"
#include "Overlay.h"

class vtkRelievoPass;

namespace viewer
{
class LayerLegend : public Overlay
{
  Q_OBJECT

public:
  /// Placed at the parent's bottom.
  explicit LayerLegend(QWidget* parent);

  /// Explains the layer in the frame's last picture; null: no layer.
  void Follow(vtkRelievoPass* frame, const relievoQt::LightNames& lights);

  /// All of its texts, including the values of the first and last colour; empty if it is hidden.
  QString GetText() const;

protected:
  void Place() override;
  void paintEvent(QPaintEvent* event) override;

private:
  relievoQt::LayerWords Shown;
};
}

#endif
