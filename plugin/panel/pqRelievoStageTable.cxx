// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqRelievoStageTable.h"

#include <QBoxLayout>
#include <QGridLayout>
#include <QLabel>
#include <QPalette>

namespace
{
// The widest texts of the columns of numbers.
const char* const Widest[] = { "", "00000.0", "1023.9 MiB" };
}

//------------------------------------------------------------------------------
pqRelievoStageTable::pqRelievoStageTable(QWidget* parent)
  : Superclass(parent)
{
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  this->Grid = new QGridLayout;
  this->Grid->setColumnStretch(0, 1);
  this->Grid->setHorizontalSpacing(4);
  layout->addLayout(this->Grid);

  const char* titles[] = { "", "ms", "Memory" };
  const char* tips[] = { "", "Time on the graphics processor, of the last pictures",
    "Graphics memory that is held for it" };
  for (int column = 1; column < 3; ++column)
  {
    QLabel* title = this->MakeNumber(QString(), column);
    title->setText(titles[column]);
    title->setToolTip(tips[column]);
    this->Grid->addWidget(title, 0, column);
  }
  auto* total = new QGridLayout;
  total->setColumnStretch(0, 1);
  total->setHorizontalSpacing(4);
  auto* whole = new QLabel("Whole picture", this);
  whole->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  total->addWidget(whole, 0, 0);
  this->TotalMilliseconds = this->MakeNumber("total_ms", 1);
  this->TotalBytes = this->MakeNumber("total_bytes", 2);
  total->addWidget(this->TotalMilliseconds, 0, 1);
  total->addWidget(this->TotalBytes, 0, 2);
  layout->addLayout(total);
}

//------------------------------------------------------------------------------
QLabel* pqRelievoStageTable::MakeNumber(const QString& name, int column)
{
  auto* label = new QLabel(this);
  label->setObjectName(name);
  label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  label->setFixedWidth(this->fontMetrics().horizontalAdvance(Widest[column]) + 4);
  return label;
}

//------------------------------------------------------------------------------
pqRelievoStageTable::Row& pqRelievoStageTable::GetRow(const QString& stage, const QString& label)
{
  if (!this->Rows.contains(stage))
  {
    Row row;
    row.Title = new QLabel(label, this);
    row.Title->setObjectName(stage + "_title");
    row.Title->setWordWrap(true);
    row.Title->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    row.Milliseconds = this->MakeNumber(stage + "_ms", 1);
    row.Bytes = this->MakeNumber(stage + "_bytes", 2);
    row.Reason = new QLabel(this);
    row.Reason->setObjectName(stage + "_reason");
    row.Reason->setWordWrap(true);
    row.Reason->setTextFormat(Qt::PlainText);
    row.Reason->setIndent(12);
    row.Reason->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    row.Reason->setForegroundRole(QPalette::PlaceholderText);
    const int line = this->Grid->rowCount();
    this->Grid->addWidget(row.Title, line, 0);
    this->Grid->addWidget(row.Milliseconds, line, 1);
    this->Grid->addWidget(row.Bytes, line, 2);
    this->Grid->addWidget(row.Reason, line + 1, 0, 1, 3);
    this->Rows[stage] = row;
  }
  return this->Rows[stage];
}

//------------------------------------------------------------------------------
void pqRelievoStageTable::SetReport(const pqRelievoFrameReport& report)
{
  for (const Row& row : this->Rows)
  {
    for (QLabel* label : { row.Title, row.Milliseconds, row.Bytes, row.Reason })
    {
      label->hide();
    }
  }
  for (const pqRelievoFrameReport::Stage& stage : report.Stages)
  {
    const QString reason = stage.GetShortReason();
    if (!stage.Ran && reason.isEmpty())
    {
      continue; // it has no part in the picture
    }
    const Row& row = this->GetRow(stage.Name, stage.Label);
    const bool waits = stage.Ran && stage.Milliseconds < 0.0;
    row.Milliseconds->setText(waits ? QString(QChar(0x2026))
                                    : pqRelievoFrameReport::FormatMilliseconds(stage.Milliseconds));
    row.Milliseconds->setToolTip(waits ? "Known when the next picture is drawn" : QString());
    row.Bytes->setText(pqRelievoFrameReport::FormatBytes(stage.Bytes));
    row.Title->setToolTip(
      stage.DrawCalls < 0 ? QString() : QString("%1 draw calls").arg(stage.DrawCalls));
    row.Reason->setText(reason);
    for (QLabel* label : { row.Title, row.Milliseconds, row.Bytes })
    {
      label->show();
    }
    row.Reason->setVisible(!reason.isEmpty());
  }
  this->TotalMilliseconds->setText(pqRelievoFrameReport::FormatMilliseconds(report.Milliseconds));
  this->TotalBytes->setText(pqRelievoFrameReport::FormatBytes(report.Bytes));
}
