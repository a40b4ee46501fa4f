// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqRelievoStageTable
 * @brief A row for each stage of a frame report, with its toggle where it has one, and the frame.
 */
#ifndef pqRelievoStageTable_h
#define pqRelievoStageTable_h

#include "pqRelievoFrameReport.h"

#include <QMap>
#include <QWidget>

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;

class pqRelievoStageTable : public QWidget
{
  Q_OBJECT
  using Superclass = QWidget;

public:
  explicit pqRelievoStageTable(QWidget* parent = nullptr);

  /** An empty report leaves the toggles and clears the rest. */
  void SetReport(const pqRelievoFrameReport& report);

  ///@{
  /** What the toggles show; no signal is sent. An empty layer and the first name are none. */
  void SetShadows(bool on);
  void SetLayer(const QString& layer, const QVector<QString>& names);
  ///@}

Q_SIGNALS:
  /** The user wants shadows on or off. */
  void shadowsToggled(bool on);

  /** The user wants this layer shown; empty for none. */
  void layerChosen(const QString& layer);

private:
  struct Row
  {
    QLabel* Milliseconds = nullptr;
    QLabel* Bytes = nullptr;
    QLabel* DrawCalls = nullptr;
    QLabel* Reason = nullptr;
  };

  Row MakeRow(const QString& stage, QWidget* title);
  Row& GetRow(const QString& stage);

  QGridLayout* Grid;
  QCheckBox* Shadows;
  QComboBox* Layer;
  QMap<QString, Row> Rows;
  QWidget* Total;
  QLabel* TotalMilliseconds;
  QLabel* TotalBytes;
};

#endif
