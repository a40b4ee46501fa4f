// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * An opacity curve over the histogram of a volume's values: points are dragged, a double click adds
 * one, a right click removes one.
 */
#ifndef OpacityCurve_h
#define OpacityCurve_h

#include <QWidget>

#include <array>
#include <vector>

namespace viewer
{
class OpacityCurve : public QWidget
{
  Q_OBJECT

public:
  using Points = std::vector<std::array<double, 2>>; ///< values and opacities

  explicit OpacityCurve(QWidget* parent = nullptr);

  /// The values' range, and their numbers in equal parts of it.
  void ShowValues(const std::array<double, 2>& range, const std::vector<double>& histogram);
  void ShowCurve(const Points& points);

  const Points& GetPoints() const { return this->Curve; }
  QPointF GetPlace(const std::array<double, 2>& point) const; ///< in the widget

  QSize sizeHint() const override;

Q_SIGNALS:
  void edited(const OpacityCurve::Points& points);

protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;

private:
  std::array<double, 2> GetPoint(const QPointF& place) const;
  int FindPoint(const QPointF& place) const;
  double GetTick() const;

  std::array<double, 2> Range = { 0.0, 1.0 };
  std::vector<double> Histogram;
  Points Curve;
  int Held = -1; // the dragged point
  bool Moved = false;
};
}

#endif
