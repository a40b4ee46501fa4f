// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The world's axes in a corner of the view; a click on an end looks from there. Saved pictures do
 * not contain them.
 */
#ifndef AxisMarker_h
#define AxisMarker_h

#include "Overlay.h"

#include <array>
#include <optional>

class vtkRenderer;

namespace viewer
{
class AxisMarker : public Overlay
{
  Q_OBJECT

public:
  /// Placed in the parent's lower left corner.
  explicit AxisMarker(QWidget* parent);

  /// Shows the axes for this renderer's camera; null: hides them.
  void Follow(vtkRenderer* renderer);

  /// Whether the user wants the marker; stored between runs.
  void SetWanted(bool wanted);
  bool IsWanted() const { return this->Wanted; }

  /// Position of an axis's end: 0 to 2 for x, y, z, and 3 to 5 for the opposite ends.
  QPointF GetEnd(int end) const;

Q_SIGNALS:
  /// The user clicked an end, numbered like GetEnd().
  void lookWanted(int end);

protected:
  void Place() override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;

private:
  std::optional<int> Find(const QPointF& at) const;

  std::array<std::array<double, 3>, 3> Axes{}; // right, up, and towards the viewer
  bool Wanted;
  bool Seen = false;
};
}

#endif
