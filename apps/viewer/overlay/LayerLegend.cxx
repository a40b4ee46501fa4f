// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LayerLegend.h"

#include "vtkRelievoDisplayStage.h"
#include "vtkRelievoPass.h"

#include <QPainter>

#include <algorithm>

namespace viewer
{
namespace
{
// Pixels
constexpr int Left = 108; // right of the axes
constexpr int Width = 300;
constexpr int Margin = 10;
constexpr int Strip = 12;
}

//------------------------------------------------------------------------------
LayerLegend::LayerLegend(QWidget* parent)
  : Overlay(parent)
{
  this->setObjectName("layerLegend");
  this->setAttribute(Qt::WA_TransparentForMouseEvents);
  this->hide();
}

//------------------------------------------------------------------------------
void LayerLegend::Follow(vtkRelievoPass* frame, const relievoQt::LightNames& lights)
{
  auto* stage = frame ? vtkRelievoDisplayStage::SafeDownCast(frame->GetStage("display")) : nullptr;
  const bool any = stage && !stage->GetLayer().empty();
  this->setVisible(any);
  if (any)
  {
    this->Shown = relievoQt::DescribeLayer(stage, true, lights);
    this->Place();
    this->update();
  }
}

//------------------------------------------------------------------------------
QString LayerLegend::GetText() const
{
  return this->isHidden() ? QString() : this->Shown.GetText();
}

//------------------------------------------------------------------------------
void LayerLegend::Place()
{
  const QFontMetrics letters(this->font());
  const int width = std::min(Width, this->parentWidget()->width() - Left - 4);
  const int words =
    letters.boundingRect(0, 0, width - 2 * Margin, 1000, Qt::TextWordWrap, this->Shown.Words)
      .height();
  const int strip = this->Shown.Strip.isNull() ? 0 : Strip + letters.height() + 6;
  const int height = 2 * Margin + letters.height() + words + strip;
  this->setGeometry(Left, this->parentWidget()->height() - height - 8, width, height);
}

//------------------------------------------------------------------------------
// White on dark, readable over any picture.
void LayerLegend::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(20, 20, 20, 190));
  painter.drawRoundedRect(this->rect(), 5, 5);
  painter.setPen(Qt::white);
  const QFontMetrics letters(this->font());
  QRect room = this->rect().adjusted(Margin, Margin, -Margin, -Margin);
  QFont bold = this->font();
  bold.setBold(true);
  painter.setFont(bold);
  painter.drawText(room, Qt::AlignTop | Qt::AlignLeft, this->Shown.Title);
  painter.setFont(this->font());
  room.setTop(room.top() + letters.height());
  if (!this->Shown.Strip.isNull())
  {
    const QRect strip(room.left(), room.top() + 3, room.width(), Strip);
    painter.drawImage(strip, this->Shown.Strip);
    room.setTop(strip.bottom() + 3);
    painter.drawText(room, Qt::AlignTop | Qt::AlignLeft, this->Shown.First);
    painter.drawText(room, Qt::AlignTop | Qt::AlignRight, this->Shown.Last);
    room.setTop(room.top() + letters.height());
  }
  painter.drawText(room, Qt::TextWordWrap, this->Shown.Words);
}
}
