// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MessageBar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QStyle>
#include <QToolButton>

#include <algorithm>

namespace viewer
{
namespace
{
constexpr int Edge = 4; // width of the coloured edge, pixels
}

//------------------------------------------------------------------------------
MessageBar::MessageBar(QWidget* parent)
  : Overlay(parent)
  , Words(new QLabel(this))
{
  this->setObjectName("messageBar");
  this->Words->setObjectName("message");
  this->Words->setWordWrap(true);
  this->Words->setTextFormat(Qt::PlainText);
  this->Words->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* close = new QToolButton(this);
  close->setObjectName("closeMessage");
  close->setText(QChar(0x2715));
  close->setAutoRaise(true);
  close->setToolTip("Closes this message");
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(Edge + 10, 6, 6, 6);
  row->addWidget(this->Words, 1);
  row->addWidget(close, 0, Qt::AlignTop);
  QObject::connect(close, &QToolButton::clicked, this, [this] {
    this->hide();
    Q_EMIT this->closed();
  });
  this->hide();
}

//------------------------------------------------------------------------------
void MessageBar::Show(const QString& text, Kind kind)
{
  this->Shown = kind;
  this->Words->setText(text);
  this->Place();
  this->show();
  this->raise();
  this->update();
}

//------------------------------------------------------------------------------
QString MessageBar::GetText() const
{
  return this->isHidden() ? QString() : this->Words->text();
}

//------------------------------------------------------------------------------
void MessageBar::Place()
{
  const int width = this->parentWidget()->width();
  const int height = this->layout()->heightForWidth(width);
  this->setGeometry(0, this->GetTop(), width, std::max(height, this->minimumSizeHint().height()));
}

//------------------------------------------------------------------------------
void MessageBar::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  const QColor sign = this->Shown == Error ? QColor(214, 60, 50)
    : this->Shown == Warning               ? QColor(224, 160, 30)
                                           : this->palette().color(QPalette::Highlight);
  const QColor window = this->palette().color(QPalette::Window);
  const auto mix = [&](int part) { return (9 * part) / 10; };
  painter.fillRect(this->rect(),
    QColor(mix(window.red()) + sign.red() / 10, mix(window.green()) + sign.green() / 10,
      mix(window.blue()) + sign.blue() / 10));
  painter.fillRect(0, 0, Edge, this->height(), sign);
  painter.fillRect(0, this->height() - 1, this->width(), 1, sign);
}
}
