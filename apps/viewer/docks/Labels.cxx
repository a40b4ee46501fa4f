// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Labels.h"

#include "vtkRelievoParameter.h"

#include <QFormLayout>
#include <QLabel>
#include <QStringList>
#include <QWidget>

namespace viewer
{
//------------------------------------------------------------------------------
QString WriteLabel(const QString& label)
{
  QStringList words = label.split(' ');
  for (int i = 0; i < words.size(); ++i)
  {
    QString& word = words[i];
    word.replace("Color", "Colour").replace("color", "colour");
    const bool name = word.size() < 2 || word.mid(1) != word.mid(1).toLower(); // such as "GPU"
    word = i == 0 || name ? word : word.toLower();
  }
  return words.join(' ');
}

//------------------------------------------------------------------------------
QLabel* AddParameterRow(QFormLayout* rows, const vtkRelievoParameter& parameter, QWidget* edit)
{
  auto* label =
    new QLabel(WriteLabel(QString::fromStdString(parameter.GetLabel())), edit->parentWidget());
  label->setToolTip(edit->toolTip());
  label->setBuddy(edit);
  rows->addRow(label, edit);
  return label;
}
}
