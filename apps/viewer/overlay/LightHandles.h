// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Handles over the picture for the spots and point lights of --light: a ball where each stands, and
 * for the spot that is edited a ring where it shines. A ball is dragged in the plane of the view, a
 * ring over the surfaces. What is outside of the picture waits at its border. They are the
 * window's: no picture that is saved has them.
 */
#ifndef LightHandles_h
#define LightHandles_h

#include "Document.h"
#include "Overlay.h"
#include "Probe.h"

#include <QColor>
#include <QPointF>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace viewer
{
class PictureView;

class LightHandles : public Overlay
{
  Q_OBJECT

public:
  LightHandles(Document* document, PictureView* view);

  /// Shows them where the picture that was drawn last has their places.
  void Follow();

  /// Whether they are seen at all.
  void SetWanted(bool wanted);

  /// The light that is edited, by its place among those of --light; -1: none.
  void Select(int light);

  /// Where a handle is in the view: the ball of a light, or the ring of its target; none: it has
  /// none.
  std::optional<QPointF> GetPlace(int light, bool target) const;

Q_SIGNALS:
  /// The mouse took a handle of this light.
  void selected(int light);

protected:
  void Place() override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

private:
  struct Handle
  {
    int Light;
    bool IsTarget;
    std::array<double, 3> World;
    QPointF Place; // in the view
    bool IsInside; // or else it waits at the border
    QColor Color;

    bool operator==(const Handle& other) const;
  };

  std::vector<Handle> FindHandles() const;
  const Handle* Find(const QPointF& at) const;
  const Handle* Find(int light, bool target) const;
  void Show(const std::vector<Handle>& handles);
  void Drag(const QPoint& at);

  Document* Edited;
  PictureView* View;
  std::vector<Handle> Handles; // those that are in front last
  int Current = -1;
  bool Wanted = false;
  std::optional<Handle> Held; // as the mouse took it
  QPointF Away;               // of the mouse from its middle
  Probe Surfaces;             // under the mouse while it is held
};
}

#endif
