// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Edits a list of colours: a strip with a draggable handle for each, and a list with their values
 * and colours.
 */
#ifndef StopsEdit_h
#define StopsEdit_h

#include "Colormaps.h"

#include <QWidget>

#include <array>
#include <optional>
#include <vector>

class QVBoxLayout;

namespace viewer
{
class StopStrip;

class StopsEdit : public QWidget
{
  Q_OBJECT

public:
  explicit StopsEdit(QWidget* parent);

  /// Sets at least two stops, sorted by place. Values refer to the range, logarithmically if `log`;
  /// without a range they are shares of it. Emits no signal.
  void Show(const std::vector<look::ColorStop>& stops,
    const std::optional<std::array<double, 2>>& range, bool log);

Q_SIGNALS:
  void edited(const std::vector<look::ColorStop>& stops);

private:
  void AddRow(std::size_t stop);
  double GetValue(double place) const;
  double GetPlace(double value) const;
  void Take(std::size_t stop, const QString& value);
  void Add();
  void Tell(std::vector<look::ColorStop> stops);

  std::vector<look::ColorStop> Stops;
  std::optional<std::array<double, 2>> Range;
  bool Log = false;
  StopStrip* Strip;
  QVBoxLayout* Rows;
};

/// Only the strip. A double click adds a handle.
class StopStrip : public QWidget
{
  Q_OBJECT

public:
  explicit StopStrip(QWidget* parent);

  void Show(const std::vector<look::ColorStop>& stops);
  QSize sizeHint() const override;

Q_SIGNALS:
  void moved(std::size_t stop, double place);
  void addWanted(double place);

protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;

private:
  double GetPlace(int x) const;
  int GetX(double place) const;

  std::vector<look::ColorStop> Stops;
  int Held = -1;
  bool Moved = false;
};
}

#endif
