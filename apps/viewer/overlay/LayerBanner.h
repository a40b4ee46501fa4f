// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Says over the picture that a layer is shown instead of it, where edits of the look and of lights
 * are not seen, and goes back. It is the window's: no picture that is saved has it.
 */
#ifndef LayerBanner_h
#define LayerBanner_h

#include "Overlay.h"

class QLabel;
class vtkRelievoPass;

namespace viewer
{
class LayerBanner : public Overlay
{
  Q_OBJECT

public:
  /// At the parent's top.
  explicit LayerBanner(QWidget* parent);

  /// Names the layer that the frame shows; null: there is none.
  void Follow(vtkRelievoPass* frame);

Q_SIGNALS:
  void pictureWanted();

protected:
  void Place() override;
  void paintEvent(QPaintEvent* event) override;

private:
  QLabel* Words;
};
}

#endif
