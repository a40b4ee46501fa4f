// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The stages of a frame report as a table: what each cost, and why it ran or did not.
 */
#ifndef StageTable_h
#define StageTable_h

#include <QTableWidget>

class QJsonArray;

namespace viewer
{
class StageTable : public QTableWidget
{
  Q_OBJECT

public:
  explicit StageTable(QWidget* parent = nullptr);

  /// A row of numbers for each stage that ran, and one across the table that says why; the latter
  /// alone for the others.
  void SetStages(const QJsonArray& stages);

protected:
  void resizeEvent(QResizeEvent* event) override;

private:
  void AddWords(const QString& text, bool ran);
  void FitWords();
};
}

#endif
