// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ReportPanel.h"

#include "FrameReport.h"
#include "Labels.h"
#include "StageTable.h"
#include "TimesChart.h"

#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>

namespace viewer
{
namespace
{
constexpr int RefreshMilliseconds = 250;
constexpr int MostTries = 8; // some drivers never deliver times
}

//------------------------------------------------------------------------------
ReportPanel::ReportPanel(Reader read, QWidget* parent)
  : QWidget(parent)
  , Read(std::move(read))
  , Table(new relievoQt::StageTable(relievoQt::StageTable::FULL, this))
  , Total(new QLabel(this))
  , Chart(new relievoQt::TimesChart(this))
{
  this->Total->setObjectName("total");
  this->Total->setWordWrap(true);
  this->Chart->setObjectName("chart");
  this->Chart->setToolTip("Milliseconds of each stage on the GPU, of those that were timed");
  this->Table->setObjectName("stages");
  this->Table->setContentsMargins(4, 4, 4, 4);
  auto* rows = new QScrollArea(this);
  rows->setWidget(this->Table);
  rows->setWidgetResizable(true);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(this->Total);
  layout->addWidget(this->Chart);
  layout->addWidget(rows, 1);
  this->Timer.setSingleShot(true);
  QObject::connect(&this->Timer, &QTimer::timeout, this, [this] { this->Refresh(); });
}

//------------------------------------------------------------------------------
// A dock behind another tab is visible for Qt. Reading the report makes the next frames wait for
// each of their commands in software OpenGL.
void ReportPanel::Follow()
{
  if (this->Late)
  {
    this->Refresh();
  }
  else if (!this->visibleRegion().isEmpty() && !this->Timer.isActive())
  {
    this->Timer.start(RefreshMilliseconds);
  }
}

//------------------------------------------------------------------------------
void ReportPanel::Show()
{
  this->Renew();
  this->Refresh();
}

//------------------------------------------------------------------------------
void ReportPanel::Renew()
{
  this->Tries = MostTries;
}

//------------------------------------------------------------------------------
void ReportPanel::Refresh()
{
  const std::optional<std::string> words = this->Read();
  this->Late = !words;
  if (this->Late)
  {
    return;
  }
  relievoQt::FrameReport report(QByteArray::fromStdString(*words));
  bool untimed = false;
  for (relievoQt::FrameReport::Stage& stage : report.Stages)
  {
    stage.Label = stage.IsDelegate() ? "VTK's picture" : WriteLabel(stage.Label);
    stage.Reason = WriteReason(stage.Code, stage.Reason);
    untimed = untimed || (stage.Ran && stage.Milliseconds < 0.0);
  }
  const bool timed = report.Milliseconds >= 0.0;
  const QString time = relievoQt::FrameReport::FormatMilliseconds(report.Milliseconds);
  this->Total->setText(report.Stages.isEmpty()
      ? QString("Nothing of Relievo is on: the picture is VTK's own.")
      : QString("Frame: %1 on the GPU, %2 held")
          .arg(timed ? time + " ms" : "not timed yet",
            relievoQt::FrameReport::FormatBytes(report.Bytes)));
  this->Chart->SetReport(report);
  this->Table->SetReport(report);
  if (untimed && this->Tries > 0)
  {
    --this->Tries;
    Q_EMIT this->framesWanted();
  }
}
}
