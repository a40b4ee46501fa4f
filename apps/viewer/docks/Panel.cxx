// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Panel.h"

#include <QFormLayout>
#include <QGroupBox>
#include <QVBoxLayout>

namespace viewer
{
//------------------------------------------------------------------------------
Panel::Panel(Document* document, QWidget* parent)
  : QScrollArea(parent)
  , Edited(document)
{
  auto* all = new QWidget(this);
  auto* outer = new QVBoxLayout(all);
  this->Column = new QVBoxLayout();
  outer->addLayout(this->Column);
  outer->addStretch(1);
  this->setWidget(all);
  this->setWidgetResizable(true);
  this->setFrameShape(QFrame::NoFrame);
  this->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  this->setMinimumWidth(330);
}

//------------------------------------------------------------------------------
QGroupBox* Panel::AddGroup(const QString& title, const QString& name)
{
  auto* group = new QGroupBox(title, this->widget());
  group->setObjectName(name);
  auto* rows = new QFormLayout(group);
  rows->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  this->Column->addWidget(group);
  return group;
}

//------------------------------------------------------------------------------
QFormLayout* Panel::GetRows(QGroupBox* group)
{
  return static_cast<QFormLayout*>(group->layout());
}
}
