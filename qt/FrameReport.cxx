// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FrameReport.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace relievoQt
{
//------------------------------------------------------------------------------
FrameReport::FrameReport(const QByteArray& json)
{
  const QJsonObject frame = QJsonDocument::fromJson(json).object();
  for (const auto& value : frame["stages"].toArray())
  {
    const QJsonObject object = value.toObject();
    Stage stage;
    stage.Name = object["name"].toString();
    stage.Label = object["label"].toString(stage.Name);
    stage.Code = object["code"].toString();
    stage.Reason = object["reason"].toString();
    stage.Ran = object["ran"].toBool();
    stage.Milliseconds = object["gpu_ms"].toDouble(-1.0);
    stage.Bytes = object["bytes"].toDouble();
    stage.DrawCalls = object["draw_calls"].toInt(-1);
    this->Stages.append(stage);
  }
  this->Milliseconds = frame["gpu_ms"].toDouble(-1.0);
  this->Bytes = frame["bytes"].toDouble();
}

//------------------------------------------------------------------------------
QString FrameReport::Stage::GetShortReason() const
{
  const bool hasNoPart = this->Code == "off" || this->Code == "idle" || this->Code == "not_asked" ||
    this->Code == "hidden";
  return hasNoPart || this->IsDelegate() ? QString() : this->Reason.section("; ", 0, 0);
}

//------------------------------------------------------------------------------
QString FrameReport::FormatMilliseconds(double milliseconds)
{
  if (milliseconds < 0.0)
  {
    return QString(QChar(0x2013));
  }
  if (milliseconds > 0.0 && milliseconds < 0.001)
  {
    return "<0.001";
  }
  const int digits = milliseconds < 1.0 ? 3
    : milliseconds < 10.0               ? 2
    : milliseconds < 100.0              ? 1
                                        : 0;
  return QString::number(milliseconds, 'f', digits);
}

//------------------------------------------------------------------------------
QString FrameReport::FormatBytes(double bytes)
{
  if (bytes <= 0.0)
  {
    return QString(QChar(0x2013));
  }
  static const char* units[] = { "B", "KiB", "MiB", "GiB", "TiB" };
  int unit = 0;
  while (bytes >= 1024.0 && unit < 4)
  {
    bytes /= 1024.0;
    ++unit;
  }
  return QString::number(bytes, 'f', unit == 0 || bytes >= 100.0 ? 0 : 1) + " " + units[unit];
}
}
