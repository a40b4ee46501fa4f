// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The frame report as a chart and a table that follow the picture while it is seen.
 */
#ifndef ReportPanel_h
#define ReportPanel_h

#include <QTimer>
#include <QWidget>

#include <functional>
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
  /// `read` gives the report of the last frame as JSON, "" if there was none.
  ReportPanel(std::function<std::string()> read, QWidget* parent = nullptr);

  /// The picture was drawn: chart and table follow soon, if they are seen.
  void Follow();

  /// Another picture is drawn, whose times are not known yet.
  void Renew();

Q_SIGNALS:
  /// Times are measured only of frames that are drawn, and known some frames later.
  void framesWanted();

protected:
  void showEvent(QShowEvent* event) override;

private:
  void Refresh();

  std::function<std::string()> Read;
  relievoQt::StageTable* Table;
  QLabel* Total;
  relievoQt::TimesChart* Chart;
  QTimer Timer;
  int Tries = 0; // frames that may still be asked for
};
}

#endif
