// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StageTable.h"

#include "FrameReport.h"

#include <QBoxLayout>
#include <QGridLayout>
#include <QLabel>

namespace relievoQt
{
namespace
{
constexpr struct
{
  const char* Name;
  const char* Title;
  const char* Widest; // text of the column
  const char* Tip;
} Columns[] = { { "_ms", "ms", "00000.0", "Time on the graphics processor, of the last pictures" },
  { "_bytes", "Memory", "1023.9 MiB", "Graphics memory that is held for it" },
  { "_draws", "Draws", "00000", "Draw calls" } };
}

//------------------------------------------------------------------------------
StageTable::StageTable(Detail detail, QWidget* parent)
  : QWidget(parent)
  , Full(detail == FULL)
  , Grid(new QGridLayout)
{
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* total = new QGridLayout;
  for (QGridLayout* grid : { this->Grid, total })
  {
    grid->setColumnStretch(0, 1);
    grid->setHorizontalSpacing(4);
    layout->addLayout(grid);
  }
  layout->addStretch(1);
  const Numbers titles = this->AddNumbers(this->Grid, "title", 0);
  for (std::size_t column = 0; column < titles.size(); ++column)
  {
    titles[column]->setText(Columns[column].Title);
    titles[column]->setToolTip(Columns[column].Tip);
  }
  this->AddText(total, "total", 0)->setText("Whole picture");
  this->Total = this->AddNumbers(total, "total", 0);
}

//------------------------------------------------------------------------------
QLabel* StageTable::AddText(QGridLayout* grid, const QString& name, int line, int columns)
{
  auto* label = new QLabel(this);
  label->setObjectName(name);
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  grid->addWidget(label, line, 0, 1, columns);
  return label;
}

//------------------------------------------------------------------------------
StageTable::Numbers StageTable::AddNumbers(QGridLayout* grid, const QString& stage, int line)
{
  Numbers numbers;
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    auto* label = new QLabel(this);
    label->setObjectName(stage + Columns[i].Name);
    label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    label->setFixedWidth(this->fontMetrics().horizontalAdvance(Columns[i].Widest) + 4);
    label->setVisible(i < 2 || this->Full);
    grid->addWidget(label, line, static_cast<int>(i) + 1);
    numbers[i] = label;
  }
  return numbers;
}

//------------------------------------------------------------------------------
const StageTable::Row& StageTable::GetRow(const QString& stage)
{
  if (!this->Rows.contains(stage))
  {
    const int line = this->Grid->rowCount();
    const Row row = { this->AddText(this->Grid, stage + "_title", line),
      this->AddNumbers(this->Grid, stage, line),
      this->AddText(this->Grid, stage + "_reason", line + 1, 4) };
    QFont bold = this->font();
    bold.setBold(true);
    row.Title->setFont(bold);
    row.Reason->setIndent(12);
    this->Rows[stage] = row;
  }
  return this->Rows[stage];
}

//------------------------------------------------------------------------------
void StageTable::SetReport(const FrameReport& report)
{
  const auto show = [this](const Row& row, bool numbers, bool reason) {
    row.Title->setVisible(numbers);
    row.Reason->setVisible(reason);
    for (std::size_t i = 0; i < row.Cells.size(); ++i)
    {
      row.Cells[i]->setVisible(numbers && (i < 2 || this->Full));
    }
  };
  QMap<QString, Row> gone = this->Rows;
  for (const FrameReport::Stage& stage : report.Stages)
  {
    const QString reason = this->Full ? stage.Reason : stage.GetShortReason();
    if (!stage.Ran && reason.isEmpty())
    {
      continue; // takes no part in the picture
    }
    const Row& row = this->GetRow(stage.Name);
    const QString draws = stage.DrawCalls < 0 ? QString() : QString::number(stage.DrawCalls);
    const bool waits = stage.Ran && stage.Milliseconds < 0.0;
    row.Title->setText(stage.Label);
    row.Title->setToolTip(draws.isEmpty() ? draws : draws + " draw calls");
    row.Cells[0]->setText(
      waits ? QString(QChar(0x2026)) : FrameReport::FormatMilliseconds(stage.Milliseconds));
    row.Cells[0]->setToolTip(waits ? "Known when the next picture is drawn" : QString());
    row.Cells[1]->setText(FrameReport::FormatBytes(stage.Bytes));
    row.Cells[2]->setText(draws);
    row.Reason->setText(stage.Ran ? reason : stage.Label + ": " + reason);
    row.Reason->setEnabled(stage.Ran);
    show(row, stage.Ran, !reason.isEmpty());
    gone.remove(stage.Name);
  }
  for (const Row& row : gone)
  {
    show(row, false, false);
  }
  this->Total[0]->setText(FrameReport::FormatMilliseconds(report.Milliseconds));
  this->Total[1]->setText(FrameReport::FormatBytes(report.Bytes));
}
}
