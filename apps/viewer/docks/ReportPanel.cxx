// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ReportPanel.h"

#include "Labels.h"
#include "StageChart.h"

#include <QHeaderView>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLocale>
#include <QTableWidget>
#include <QVBoxLayout>

namespace viewer
{
namespace
{
constexpr int RefreshMilliseconds = 250;
constexpr int MostTries = 8; // some drivers never know

QString Milliseconds(const QJsonValue& value)
{
  return value.isDouble() ? QString::number(value.toDouble(), 'f', 2) : QString("-");
}

QString Bytes(const QJsonValue& value)
{
  return QLocale::c().formattedDataSize(static_cast<qint64>(value.toDouble()));
}
}

//------------------------------------------------------------------------------
ReportPanel::ReportPanel(std::function<std::string()> read, QWidget* parent)
  : QWidget(parent)
  , Read(std::move(read))
  , Table(new QTableWidget(0, 5, this))
  , Total(new QLabel(this))
  , Chart(new StageChart(this))
{
  this->Table->setObjectName("stages");
  this->Table->setHorizontalHeaderLabels({ "Stage", "GPU (ms)", "Memory", "Draws", "Why" });
  this->Table->verticalHeader()->hide();
  this->Table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  this->Table->horizontalHeader()->setStretchLastSection(true);
  for (int column = 0; column < 4; ++column)
  {
    this->Table->horizontalHeader()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
  }
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
          .arg(
            report["gpu_ms"].isDouble() ? Milliseconds(report["gpu_ms"]) + " ms" : "not timed yet",
            Bytes(report["bytes"])));
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
  this->Table->setRowCount(stages.size());
  for (int row = 0; row < stages.size(); ++row)
  {
    const QJsonObject stage = stages[row].toObject();
    const bool ran = stage["ran"].toBool();
    const QJsonValue draws = stage["draw_calls"];
    const QString texts[] = { WriteLabel(stage["label"].toString()),
      ran ? Milliseconds(stage["gpu_ms"]) : "", ran ? Bytes(stage["bytes"]) : "",
      ran && draws.isDouble() ? QString::number(draws.toInt()) : "", stage["reason"].toString() };
    for (int column = 0; column < 5; ++column)
    {
      auto* item = new QTableWidgetItem(texts[column]);
      item->setFlags(ran ? Qt::ItemIsEnabled | Qt::ItemIsSelectable : Qt::ItemIsSelectable);
      item->setToolTip(stage["reason"].toString());
      item->setTextAlignment(
        Qt::AlignVCenter | (column >= 1 && column <= 3 ? Qt::AlignRight : Qt::AlignLeft));
      this->Table->setItem(row, column, item);
    }
  }
  if (untimed && this->isVisible() && this->Tries > 0)
  {
    --this->Tries;
    Q_EMIT this->framesWanted();
  }
}
}
