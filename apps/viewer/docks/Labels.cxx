// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Labels.h"

#include "vtkRelievoParameter.h"

#include <QFormLayout>
#include <QLabel>
#include <QMap>
#include <QStringList>
#include <QWidget>

namespace viewer
{
namespace
{
// For people who know the picture and not the method: see docs/viewer.md.
const QMap<QString, QString>& GetPlainWords()
{
  static const QMap<QString, QString> words = { { "Delegate", "VTK's picture" },
    { "Way", "Lamps found by" }, { "Floats", "Full precision" },
    { "Casting", "Lamps with shadows" }, { "beer", "exponential" }, { "chord", "linear" } };
  return words;
}
}

//------------------------------------------------------------------------------
QString WriteLabel(const QString& label)
{
  if (GetPlainWords().contains(label))
  {
    return GetPlainWords()[label];
  }
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
QString WriteReason(const QString& code, const QString& reason)
{
  return code == "off"    ? QString("switched off")
    : code == "not_asked" ? QString("this picture does not need it")
                          : reason;
}

//------------------------------------------------------------------------------
QString WriteChoice(const QString& choice)
{
  return GetPlainWords().value(choice, QString(choice).replace('_', ' '));
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
