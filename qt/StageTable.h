// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A table of a frame report: for each stage, why it ran or not, and totals. Columns of numbers have
 * a fixed width.
 */
#ifndef StageTable_h
#define StageTable_h

#include <QMap>
#include <QWidget>

#include <array>

class QGridLayout;
class QLabel;

namespace relievoQt
{
struct FrameReport;

class StageTable : public QWidget
{
  Q_OBJECT

public:
  enum Detail
  {
    SHORT, // stages that take part in the picture, and the first clause of their reasons
    FULL   // all stages, their reasons and draw calls
  };

  explicit StageTable(Detail detail, QWidget* parent = nullptr);

  /// Shows a report; an empty one clears the table.
  void SetReport(const FrameReport& report);

private:
  using Numbers = std::array<QLabel*, 3>; // milliseconds, bytes, draw calls

  struct Row
  {
    QLabel* Title;
    Numbers Cells;
    QLabel* Reason;
  };

  const Row& GetRow(const QString& stage);
  QLabel* AddText(QGridLayout* grid, const QString& name, int line, int columns = 1);
  Numbers AddNumbers(QGridLayout* grid, const QString& stage, int line);

  bool Full;
  QGridLayout* Grid;
  QMap<QString, Row> Rows;
  Numbers Total;
};
}

#endif
