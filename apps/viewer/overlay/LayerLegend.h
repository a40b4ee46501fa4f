// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the colours of a layer mean that is shown as the picture, or why it shows nothing. It is the
 * window's: no picture that is saved has it.
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
  /// At the parent's bottom.
  explicit LayerLegend(QWidget* parent);

  /// Explains the layer that the frame's last picture shows; null: no layer is shown.
  void Follow(vtkRelievoPass* frame);

  /// All that it says, the values of the first and the last colour included; empty if it is hidden.
  QString GetText() const;

protected:
  void Place() override;
  void paintEvent(QPaintEvent* event) override;

private:
  relievoQt::LayerWords Shown;
};
}

#endif
