// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Panel.h"

#include <QFormLayout>
#include <QGroupBox>
#include <QStyleOptionGroupBox>
#include <QStylePainter>
#include <QVBoxLayout>

namespace viewer
{
namespace
{
constexpr int LeastWidth = 340;

// Styles draw a frame around nothing, too, which looks as if something should be there.
class Unframed : public QGroupBox
{
public:
  using QGroupBox::QGroupBox;

protected:
  void paintEvent(QPaintEvent*) override
  {
    QStylePainter painter(this);
    QStyleOptionGroupBox option;
    this->initStyleOption(&option);
    option.subControls &= ~QStyle::SC_GroupBoxFrame;
    painter.drawComplexControl(QStyle::CC_GroupBox, option);
  }
};
}

//------------------------------------------------------------------------------
Panel::Panel(Document* document, QWidget* parent)
  : QScrollArea(parent)
  , Edited(document)
{
  auto* all = new QWidget(this);
  this->Outer = new QVBoxLayout(all);
  this->Column = new QVBoxLayout();
  this->Outer->addLayout(this->Column);
  this->Outer->addStretch(1);
  this->setWidget(all);
  this->setWidgetResizable(true);
  this->setFrameShape(QFrame::NoFrame);
  this->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  this->setMinimumWidth(LeastWidth);
}

//------------------------------------------------------------------------------
QSize Panel::sizeHint() const
{
  return { LeastWidth, this->QScrollArea::sizeHint().height() };
}

//------------------------------------------------------------------------------
QGroupBox* Panel::AddGroup(const QString& title, const QString& name, bool framed)
{
  QGroupBox* group = framed ? new QGroupBox(this->widget()) : new Unframed(this->widget());
  group->setTitle(title);
  group->setObjectName(name);
  auto* rows = new QFormLayout(group);
  rows->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  if (!framed)
  {
    rows->setContentsMargins(0, 0, 0, 0);
  }
  this->Column->addWidget(group);
  return group;
}

//------------------------------------------------------------------------------
void Panel::Fill(QGroupBox* group)
{
  this->Outer->setStretch(0, 1);
  this->Outer->setStretch(1, 0);
  this->Column->setStretchFactor(group, 1);
}

//------------------------------------------------------------------------------
QFormLayout* Panel::GetRows(QGroupBox* group)
{
  return static_cast<QFormLayout*>(group->layout());
}
}
