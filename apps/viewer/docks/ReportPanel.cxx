// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ReportPanel.h"

#include "Labels.h"
#include "StageChart.h"
#include "StageTable.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QVBoxLayout>

namespace viewer
{
namespace
{
constexpr int RefreshMilliseconds = 250;
constexpr int MostTries = 8; // some drivers never know
}

//------------------------------------------------------------------------------
ReportPanel::ReportPanel(std::function<std::string()> read, QWidget* parent)
  : QWidget(parent)
  , Read(std::move(read))
  , Table(new StageTable(this))
  , Total(new QLabel(this))
  , Chart(new StageChart(this))
{
  this->Total->setObjectName("total");
  this->Total->setWordWrap(true);
  this->Chart->setObjectName("chart");
  this->Chart->setToolTip("Milliseconds of each stage on the GPU, of those that were timed");
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(this->Total);
  layout->addWidget(this->Chart);
  layout->addWidget(this->Table, 1);
  this->Timer.setSingleShot(true);
  QObject::connect(&this->Timer, &QTimer::timeout, this, [this] { this->Refresh(); });
}

//------------------------------------------------------------------------------
void ReportPanel::Follow()
{
  if (this->isVisible() && !this->Timer.isActive())
  {
    this->Timer.start(RefreshMilliseconds);
  }
}

//------------------------------------------------------------------------------
void ReportPanel::showEvent(QShowEvent* event)
{
  this->QWidget::showEvent(event);
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
  const QJsonObject report =
    QJsonDocument::fromJson(QByteArray::fromStdString(this->Read())).object();
  const QJsonArray stages = report["stages"].toArray();
  this->Total->setText(report.isEmpty()
      ? QString("Nothing of Relievo is on: the picture is VTK's own.")
      : QString("Frame: %1 on the GPU, %2 held")
          .arg(report["gpu_ms"].isDouble()
              ? QString::number(report["gpu_ms"].toDouble(), 'f', 2) + " ms"
              : "not timed yet",
            WriteBytes(report["bytes"].toDouble())));
  std::vector<StageChart::Bar> bars;
  bool untimed = false;
  for (const QJsonValue& value : stages)
  {
    const QJsonObject stage = value.toObject();
    untimed = untimed || (stage["ran"].toBool() && !stage["gpu_ms"].isDouble());
    if (stage["ran"].toBool() && stage["gpu_ms"].isDouble())
    {
      bars.push_back({ WriteLabel(stage["label"].toString()), stage["gpu_ms"].toDouble() });
    }
  }
  this->Chart->SetBars(bars);
  this->Table->SetStages(stages);
  if (untimed && this->isVisible() && this->Tries > 0)
  {
    --this->Tries;
    Q_EMIT this->framesWanted();
  }
}
}
