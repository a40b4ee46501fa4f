// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rows.h"

#include <QFormLayout>
#include <QLabel>

namespace relievoQt
{
//------------------------------------------------------------------------------
QFormLayout* MakeRows(QWidget* parent)
{
  auto* rows = new QFormLayout(parent);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  return rows;
}

//------------------------------------------------------------------------------
void AddRow(QFormLayout* rows, const QString& title, QWidget* field)
{
  auto* label = new QLabel(title, rows->parentWidget());
  label->setFixedWidth(label->fontMetrics().horizontalAdvance("Show layers"));
  label->setBuddy(field);
  rows->addRow(label, field);
}
}
