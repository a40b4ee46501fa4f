// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqRelievoStageTable
 * @brief A row for each stage of a frame report that took part in the picture, and the whole.
 *
 * Its columns of numbers have one width, whatever is in them.
 */
#ifndef pqRelievoStageTable_h
#define pqRelievoStageTable_h

#include "pqRelievoFrameReport.h"

#include <QMap>
#include <QWidget>

class QGridLayout;
class QLabel;

class pqRelievoStageTable : public QWidget
{
  Q_OBJECT
  using Superclass = QWidget;

public:
  explicit pqRelievoStageTable(QWidget* parent = nullptr);

  /** Shows a report; an empty one clears all. */
  void SetReport(const pqRelievoFrameReport& report);

private:
  struct Row
  {
    QLabel* Title = nullptr;
    QLabel* Milliseconds = nullptr;
    QLabel* Bytes = nullptr;
    QLabel* Reason = nullptr;
  };

  Row& GetRow(const QString& stage, const QString& label);
  QLabel* MakeNumber(const QString& name, int column);

  QGridLayout* Grid;
  QMap<QString, Row> Rows;
  QLabel* TotalMilliseconds;
  QLabel* TotalBytes;
};

#endif
