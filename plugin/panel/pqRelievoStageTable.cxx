// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqRelievoStageTable.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QPalette>
#include <QSignalBlocker>

#include <algorithm>

namespace
{
QLabel* MakeNumber(QWidget* parent, const QString& name)
{
  auto* label = new QLabel(parent);
  label->setObjectName(name);
  label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  return label;
}
}

//------------------------------------------------------------------------------
pqRelievoStageTable::pqRelievoStageTable(QWidget* parent)
  : Superclass(parent)
{
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  this->Grid = new QGridLayout;
  this->Grid->setColumnStretch(0, 1);
  layout->addLayout(this->Grid);

  const char* titles[] = { "Stage", "ms", "Memory", "Draws" };
  const char* tips[] = { "A part of the picture that can be switched on and off by itself",
    "Time on the graphics processor, of the last pictures", "Graphics memory that the stage holds",
    "Draw calls that the stage made for the last picture" };
  for (int column = 0; column < 4; ++column)
  {
    auto* title = new QLabel(QString("<b>%1</b>").arg(titles[column]), this);
    title->setToolTip(tips[column]);
    title->setAlignment(column ? Qt::AlignRight : Qt::AlignLeft);
    this->Grid->addWidget(title, 0, column);
  }

  this->Shadows = new QCheckBox(pqRelievoFrameReport::GetLabel("shadows"), this);
  this->Shadows->setObjectName("shadows");
  this->Layer = new QComboBox(this);
  this->Layer->setObjectName("layer");
  this->Layer->setToolTip("A layer to show as the picture");
  this->Layer->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  this->Layer->setMinimumContentsLength(9);
  this->Rows["shadows"] = this->MakeRow("shadows", this->Shadows);
  this->Rows["display"] = this->MakeRow("display", this->Layer);

  this->Total = new QWidget(this);
  auto* total = new QHBoxLayout(this->Total);
  total->setContentsMargins(0, 0, 0, 0);
  this->TotalMilliseconds = MakeNumber(this->Total, "total_ms");
  this->TotalBytes = MakeNumber(this->Total, "total_bytes");
  total->addWidget(new QLabel("<b>Whole picture</b>", this->Total), 1);
  total->addWidget(this->TotalMilliseconds);
  total->addWidget(this->TotalBytes);
  layout->addWidget(this->Total);

  QObject::connect(this->Shadows, &QCheckBox::toggled, this, &pqRelievoStageTable::shadowsToggled);
  QObject::connect(this->Layer, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
    [this](int i) { Q_EMIT this->layerChosen(this->Layer->itemData(i).toString()); });
}

//------------------------------------------------------------------------------
pqRelievoStageTable::Row pqRelievoStageTable::MakeRow(const QString& stage, QWidget* title)
{
  Row row;
  row.Milliseconds = MakeNumber(this, stage + "_ms");
  row.Bytes = MakeNumber(this, stage + "_bytes");
  row.DrawCalls = MakeNumber(this, stage + "_draws");
  row.Reason = new QLabel(this);
  row.Reason->setObjectName(stage + "_reason");
  row.Reason->setWordWrap(true);
  row.Reason->setTextFormat(Qt::PlainText);
  row.Reason->setIndent(12);
  row.Reason->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  QPalette palette = row.Reason->palette();
  QColor fainter = palette.color(QPalette::WindowText);
  fainter.setAlphaF(0.6);
  palette.setColor(QPalette::WindowText, fainter);
  row.Reason->setPalette(palette);
  const int line = this->Grid->rowCount();
  this->Grid->addWidget(title, line, 0);
  this->Grid->addWidget(row.Milliseconds, line, 1);
  this->Grid->addWidget(row.Bytes, line, 2);
  this->Grid->addWidget(row.DrawCalls, line, 3);
  this->Grid->addWidget(row.Reason, line + 1, 0, 1, 4);
  return row;
}

//------------------------------------------------------------------------------
pqRelievoStageTable::Row& pqRelievoStageTable::GetRow(const QString& stage)
{
  if (!this->Rows.contains(stage))
  {
    auto* title = new QLabel(pqRelievoFrameReport::GetLabel(stage), this);
    this->Rows[stage] = this->MakeRow(stage, title);
  }
  return this->Rows[stage];
}

//------------------------------------------------------------------------------
void pqRelievoStageTable::SetReport(const pqRelievoFrameReport& report)
{
  for (const Row& row : this->Rows)
  {
    for (QLabel* label : { row.Milliseconds, row.Bytes, row.DrawCalls, row.Reason })
    {
      label->clear();
      label->setToolTip(QString());
    }
    row.Reason->hide();
  }
  for (const pqRelievoFrameReport::Stage& stage : report.Stages)
  {
    const Row& row = this->GetRow(stage.Name);
    if (stage.Ran && stage.Milliseconds < 0.0)
    {
      row.Milliseconds->setText(QString(QChar(0x2026)));
      row.Milliseconds->setToolTip("Known when the next picture is drawn");
    }
    else
    {
      row.Milliseconds->setText(pqRelievoFrameReport::FormatMilliseconds(stage.Milliseconds));
    }
    row.Bytes->setText(pqRelievoFrameReport::FormatBytes(stage.Bytes));
    row.DrawCalls->setText(stage.DrawCalls < 0 ? QString() : QString::number(stage.DrawCalls));
    row.Reason->setText((stage.Ran ? "" : "not run: ") + stage.GetShortReason());
    row.Reason->setToolTip(QString(stage.Reason).replace("; ", "\n"));
    row.Reason->setVisible(!stage.Reason.isEmpty());
  }
  this->TotalMilliseconds->setText(
    pqRelievoFrameReport::FormatMilliseconds(report.Milliseconds) + " ms");
  this->TotalBytes->setText(pqRelievoFrameReport::FormatBytes(report.Bytes));
  this->Total->setVisible(!report.Stages.isEmpty());
}

//------------------------------------------------------------------------------
void pqRelievoStageTable::SetShadows(bool on)
{
  const QSignalBlocker quiet(this->Shadows);
  this->Shadows->setChecked(on);
}

//------------------------------------------------------------------------------
void pqRelievoStageTable::SetLayer(const QString& layer, const QVector<QString>& names)
{
  const QSignalBlocker quiet(this->Layer);
  this->Layer->clear();
  this->Layer->addItem("No layer shown", QString());
  for (int i = 1; i < names.size(); ++i)
  {
    this->Layer->addItem("Layer " + names[i], names[i]);
  }
  if (!layer.isEmpty() && !names.contains(layer))
  {
    this->Layer->addItem("Layer " + layer, layer); // by script: an array
  }
  this->Layer->setCurrentIndex(std::max(0, this->Layer->findData(layer)));
}
