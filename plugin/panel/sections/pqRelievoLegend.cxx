// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqRelievoLegend.h"

#include "LayerWords.h"

#include <QGridLayout>
#include <QLabel>
#include <QPixmap>
#include <QStringList>

namespace
{
constexpr int Height = 10;
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
void pqRelievoLegend::Show(const relievoQt::LayerWords& words)
{
  const bool strip = !words.Strip.isNull();
  this->Words->setText(words.Words);
  this->Words->setVisible(!words.Words.isEmpty());
  if (strip)
  {
    this->Bar->setPixmap(QPixmap::fromImage(words.Strip));
  }
  this->First->setText(words.First);
  this->Last->setText(words.Last);
  for (QLabel* each : { this->Bar, this->First, this->Last })
  {
    each->setVisible(strip);
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
