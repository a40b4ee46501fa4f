// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LayerBanner.h"

#include "LayerWords.h"

#include "vtkRelievoPass.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>

#include <algorithm>

namespace viewer
{
namespace
{
constexpr int Gap = 10; // pixels, above it
}

//------------------------------------------------------------------------------
LayerBanner::LayerBanner(QWidget* parent)
  : Overlay(parent)
  , Words(new QLabel(this))
{
  this->setObjectName("layerBanner");
  this->Words->setObjectName("layerBannerWords");
  this->Words->setTextFormat(Qt::PlainText);
  this->Words->setStyleSheet("color: white");
  auto* back = new QPushButton("Show the picture", this);
  back->setObjectName("showPicture");
  back->setToolTip("Edits of Look and Light appear in the picture");
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(14, 6, 8, 6);
  row->setSpacing(12);
  row->addWidget(this->Words);
  row->addWidget(back);
  QObject::connect(back, &QPushButton::clicked, this, &LayerBanner::pictureWanted);
  this->hide();
}

//------------------------------------------------------------------------------
void LayerBanner::Follow(vtkRelievoPass* frame, const relievoQt::LightNames& lights)
{
  const char* layer = frame ? frame->GetDisplayLayer() : nullptr;
  if (layer)
  {
    this->Words->setText("Showing: " + relievoQt::NameLayer(layer, lights));
    this->Place();
  }
  this->setVisible(layer != nullptr);
}

//------------------------------------------------------------------------------
void LayerBanner::Place()
{
  this->layout()->activate();
  const QSize room = this->parentWidget()->size();
  const QSize size = this->sizeHint().boundedTo(room);
  this->setGeometry(std::max(0, (room.width() - size.width()) / 2), this->GetTop() + Gap,
    size.width(), size.height());
}

//------------------------------------------------------------------------------
// White on dark, readable over any picture.
void LayerBanner::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(20, 20, 20, 190));
  painter.drawRoundedRect(this->rect(), 5, 5);
}
}
