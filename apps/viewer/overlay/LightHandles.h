// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Handles over the picture for the spots and point lights of --light: a ball at each position, and
 * a ring at the edited spot's target, with the outline of its cone. A ball is dragged in the plane
 * of the view, a ring over the surfaces. Handles outside the picture are at its border. Saved
 * pictures do not contain them.
 */
#ifndef LightHandles_h
#define LightHandles_h

#include "Document.h"
#include "Overlay.h"
#include "Probe.h"

#include <QColor>
#include <QLineF>
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

  /// Moves the handles to their places in the last picture.
  void Follow();

  /// Whether handles are shown.
  void SetWanted(bool wanted);

  /// Index of the edited light among those of --light; -1: none.
  void Select(int light);

  /// The lines of the edited spot's cone.
  const std::vector<QLineF>& GetCone() const { return this->Cone; }

  /// Position of a handle in the view: the ball of a light, or the ring of its target; none if
  /// there is no handle.
  std::optional<QPointF> GetPlace(int light, bool target) const;

Q_SIGNALS:
  /// The mouse pressed a handle of this light.
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
    bool IsInside; // false: at the border
    QColor Color;

    bool operator==(const Handle& other) const;
  };

  std::vector<Handle> FindHandles() const;
  std::vector<QLineF> FindCone() const;
  const Handle* Find(const QPointF& at) const;
  const Handle* Find(int light, bool target) const;
  void Show(const std::vector<Handle>& handles, const std::vector<QLineF>& cone);
  void Drag(const QPoint& at);

  Document* Edited;
  PictureView* View;
  std::vector<Handle> Handles; // front ones last
  std::vector<QLineF> Cone;    // of the edited spot
  int Current = -1;
  bool Wanted = false;
  std::optional<Handle> Held; // state at the press
  QPointF Away;               // offset of the mouse from its centre
  Probe Surfaces;             // under the mouse during a drag
};
}

#endif
