// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StageTable.h"

#include "Labels.h"

#include <QHeaderView>
#include <QJsonArray>
#include <QJsonObject>
#include <QScrollBar>

namespace viewer
{
namespace
{
constexpr int Columns = 4;
constexpr int Padding = 4; // pixels around words
}

//------------------------------------------------------------------------------
StageTable::StageTable(QWidget* parent)
  : QTableWidget(0, Columns, parent)
{
  this->setObjectName("stages");
  this->setHorizontalHeaderLabels({ "Stage", "GPU (ms)", "Memory", "Draws" });
  this->verticalHeader()->hide();
  this->setEditTriggers(QAbstractItemView::NoEditTriggers);
  this->setWordWrap(true);
  this->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  // Words across the table are the first column's, and do not widen it.
  this->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
}

//------------------------------------------------------------------------------
void StageTable::AddWords(const QString& text, bool ran)
{
  const int row = this->rowCount();
  this->insertRow(row);
  auto* item = new QTableWidgetItem(text);
  item->setFlags(ran ? Qt::ItemIsEnabled | Qt::ItemIsSelectable : Qt::ItemIsSelectable);
  this->setItem(row, 0, item);
  this->setSpan(row, 0, 1, Columns);
}

//------------------------------------------------------------------------------
void StageTable::SetStages(const QJsonArray& stages)
{
  const int scrolled = this->verticalScrollBar()->value();
  this->clearSpans();
  this->setRowCount(0);
  for (const QJsonValue& value : stages)
  {
    const QJsonObject stage = value.toObject();
    const QString label = WriteLabel(stage["label"].toString());
    const QString reason = stage["reason"].toString();
    if (!stage["ran"].toBool())
    {
      this->AddWords(label + ": " + reason, false);
      continue;
    }
    const int row = this->rowCount();
    this->insertRow(row);
    const QJsonValue time = stage["gpu_ms"];
    const QJsonValue draws = stage["draw_calls"];
    const QString texts[Columns] = { label,
      time.isDouble() ? QString::number(time.toDouble(), 'f', 2) : QString("-"),
      WriteBytes(stage["bytes"].toDouble()),
      draws.isDouble() ? QString::number(draws.toInt()) : QString() };
    for (int column = 0; column < Columns; ++column)
    {
      auto* item = new QTableWidgetItem(texts[column]);
      item->setTextAlignment(Qt::AlignVCenter | (column > 0 ? Qt::AlignRight : Qt::AlignLeft));
      this->setItem(row, column, item);
    }
    QFont bold = this->font();
    bold.setBold(true);
    this->item(row, 0)->setFont(bold);
    this->AddWords(reason, true);
  }
  this->FitWords();
  this->verticalScrollBar()->setValue(scrolled);
}

//------------------------------------------------------------------------------
// Qt fits rows to cells of one column.
void StageTable::FitWords()
{
  const int width = this->viewport()->width() - 2 * Padding;
  for (int row = 0; row < this->rowCount(); ++row)
  {
    if (this->columnSpan(row, 0) > 1)
    {
      const QRect words = this->fontMetrics().boundingRect(
        QRect(0, 0, width, 0), Qt::TextWordWrap, this->item(row, 0)->text());
      this->setRowHeight(row, words.height() + 2 * Padding);
    }
  }
}

//------------------------------------------------------------------------------
void StageTable::resizeEvent(QResizeEvent* event)
{
  this->QTableWidget::resizeEvent(event);
  this->FitWords();
}
}
