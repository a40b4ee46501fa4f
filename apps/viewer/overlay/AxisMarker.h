// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The axes of the world in a corner of the view; a click on an end looks from there. It is the
 * window's: no picture that is saved has it.
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
  /// In the parent's lower left corner.
  explicit AxisMarker(QWidget* parent);

  /// Shows the axes as seen by this renderer's camera; null: not at all.
  void Follow(vtkRenderer* renderer);

  /// Whether it is wanted; kept from one run to the next.
  void SetWanted(bool wanted);
  bool IsWanted() const { return this->Wanted; }

  /// Where an axis ends, from 0 to 2 for x, y, z, and its other end from 3 to 5.
  QPointF GetEnd(int end) const;

Q_SIGNALS:
  /// From an end, as of GetEnd().
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
