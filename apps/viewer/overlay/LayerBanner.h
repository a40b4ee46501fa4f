// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Tells that the view shows a layer, in which edits of the look and of lights are invisible, with a
 * button that returns to the picture. Saved pictures do not contain it.
 */
#ifndef LayerBanner_h
#define LayerBanner_h

#include "LayerWords.h"
#include "Overlay.h"

class QLabel;
class vtkRelievoPass;

namespace viewer
{
class LayerBanner : public Overlay
{
  Q_OBJECT

public:
  /// Placed at the parent's top.
  explicit LayerBanner(QWidget* parent);

  /// Names the layer shown by the frame; null: no frame.
  void Follow(vtkRelievoPass* frame, const relievoQt::LightNames& lights);

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
