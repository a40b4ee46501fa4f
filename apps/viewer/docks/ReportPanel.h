// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The frame report as a chart and a table, updated while visible.
 */
#ifndef ReportPanel_h
#define ReportPanel_h

#include <QTimer>
#include <QWidget>

#include <functional>
#include <optional>
#include <string>

class QLabel;

namespace relievoQt
{
class StageTable;
class TimesChart;
}

namespace viewer
{
class ReportPanel : public QWidget
{
  Q_OBJECT

public:
  /// The report of the last frame as JSON, "" if there was none; nothing while a frame is drawn.
  using Reader = std::function<std::optional<std::string>()>;

  explicit ReportPanel(Reader read, QWidget* parent = nullptr);

  /// Updates chart and table soon after a picture, if they are visible.
  void Follow();

  /// Call when the panel comes to the front.
  void Show();

  /// A new picture is drawn; its times are not known yet.
  void Renew();

Q_SIGNALS:
  /// Only drawn frames are timed, and times arrive some frames later.
  void framesWanted();

private:
  void Refresh();

  Reader Read;
  relievoQt::StageTable* Table;
  QLabel* Total;
  relievoQt::TimesChart* Chart;
  QTimer Timer;
  bool Late = false; // the report follows the frame that is being drawn
  int Tries = 0;     // frames that may still be requested
};
}

#endif
