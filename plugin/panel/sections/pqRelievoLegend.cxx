// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqRelievoLegend.h"

#include "vtkRelievoFormulas.h"

#include <QGridLayout>
#include <QImage>
#include <QLabel>
#include <QPixmap>
#include <QStringList>

namespace
{
constexpr int Shades = 256;
constexpr int Height = 10;

QPixmap MakeBar(bool grey)
{
  QImage bar(Shades, 1, QImage::Format_RGB32);
  for (int i = 0; i < Shades; ++i)
  {
    const float t = static_cast<float>(i) / (Shades - 1);
    const glm::vec3 color = grey ? glm::vec3(t) : relievo::f32::relievoColormap(t);
    bar.setPixelColor(i, 0, QColor::fromRgbF(color.x, color.y, color.z));
  }
  return QPixmap::fromImage(bar);
}
}

//------------------------------------------------------------------------------
pqRelievoLegend::pqRelievoLegend(QWidget* parent)
  : Superclass(parent)
  , Words(new QLabel(this))
  , Bar(new QLabel(this))
  , First(new QLabel(this))
  , Last(new QLabel(this))
{
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setVerticalSpacing(2);
  this->Words->setWordWrap(true);
  this->Bar->setFixedHeight(Height);
  this->Bar->setScaledContents(true);
  this->Bar->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  this->Last->setAlignment(Qt::AlignRight);
  grid->addWidget(this->Words, 0, 0, 1, 2);
  grid->addWidget(this->Bar, 1, 0, 1, 2);
  grid->addWidget(this->First, 2, 0);
  grid->addWidget(this->Last, 2, 1);
}

//------------------------------------------------------------------------------
void pqRelievoLegend::Set(
  const QString& words, Looks look, const QString& first, const QString& last)
{
  this->Words->setText(words);
  if (look != WORDS)
  {
    this->Bar->setPixmap(MakeBar(look == GREYS));
  }
  this->First->setText(first);
  this->Last->setText(last);
  this->Words->setVisible(!words.isEmpty());
  for (QLabel* each : { this->Bar, this->First, this->Last })
  {
    each->setVisible(look != WORDS);
  }
}

//------------------------------------------------------------------------------
QString pqRelievoLegend::GetText() const
{
  QStringList lines;
  for (QLabel* each : { this->Words, this->First, this->Last })
  {
    if (!each->isHidden())
    {
      lines << each->text();
    }
  }
  return lines.join("\n");
}
