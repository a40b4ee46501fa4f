// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ColorButton.h"

#include <QColorDialog>
#include <QPainter>
#include <QPixmap>

namespace viewer
{
//------------------------------------------------------------------------------
ColorButton::ColorButton(QWidget* parent)
  : QPushButton(parent)
{
  this->SetColor(Qt::white);
  QObject::connect(this, &QPushButton::clicked, this, [this] {
    const QColor color = QColorDialog::getColor(this->Color, this, "Colour");
    if (color.isValid())
    {
      this->SetColor(color);
      Q_EMIT this->edited(color);
    }
  });
}

//------------------------------------------------------------------------------
void ColorButton::SetColor(const QColor& color)
{
  this->Color = color;
  QPixmap swatch(this->iconSize());
  swatch.fill(color);
  QPainter frame(&swatch); // otherwise white would be invisible
  frame.setPen(this->palette().color(QPalette::Mid));
  frame.drawRect(0, 0, swatch.width() - 1, swatch.height() - 1);
  frame.end();
  this->setIcon(swatch);
  this->setText(this->Named ? color.name() : QString());
  this->setToolTip(color.name());
}

//------------------------------------------------------------------------------
void ColorButton::ShowNames(bool on)
{
  this->Named = on;
  this->SetColor(this->Color);
}
}
