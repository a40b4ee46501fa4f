// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Labels.h"

#include <QFormLayout>
#include <QLabel>
#include <QStringList>
#include <QTextDocument>
#include <QVariant>
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
QString WriteReason(const QString& code, const QString& reason)
{
  return code == "off"    ? QString("switched off")
    : code == "not_asked" ? QString("this picture does not need it")
                          : reason;
}

//------------------------------------------------------------------------------
QString WriteCondition(
  const vtkRelievoParameterList& list, const vtkRelievoParameter::Condition& condition)
{
  const vtkRelievoParameter* other = list.Find(condition.Name);
  if (!other && condition.Value.empty())
  {
    const QString what = QString::fromStdString(condition.Name).replace('_', ' ');
    const bool vowel = QString("aeiou").contains(what[0]);
    return QString("Has an effect with %1 %2.").arg(vowel ? "an" : "a", what);
  }
  const std::string label = other ? other->GetLabel() : vtkRelievoCapitalize(condition.Name, true);
  std::string value = condition.Value;
  for (std::size_t i = 0; other && i < other->Choices.size(); ++i)
  {
    value = other->Choices[i] == value ? other->GetChoiceLabel(i) : value;
  }
  return QString("Has an effect where %1 is %2%3.")
    .arg(WriteLabel(QString::fromStdString(label)), condition.Other ? "not " : "",
      QString::fromStdString(value));
}

//------------------------------------------------------------------------------
void SetIdle(QWidget* edit, const QString& why)
{
  constexpr const char* property = "relievoHelp";
  if (!edit->property(property).isValid())
  {
    edit->setProperty(property, edit->toolTip());
  }
  const QString help = edit->property(property).toString();
  const QString text =
    help.isEmpty() || Qt::mightBeRichText(help) ? help : "<p>" + help.toHtmlEscaped() + "</p>";
  edit->setEnabled(why.isEmpty());
  edit->setToolTip(why.isEmpty() ? help : "<p>" + why.toHtmlEscaped() + "</p>" + text);
  for (QLabel* label :
    edit->parentWidget()->findChildren<QLabel*>(QString(), Qt::FindDirectChildrenOnly))
  {
    if (label->buddy() == edit)
    {
      label->setEnabled(why.isEmpty());
      label->setToolTip(edit->toolTip());
    }
  }
}

//------------------------------------------------------------------------------
void AddParameterRow(QFormLayout* rows, const vtkRelievoParameter& parameter, QWidget* edit)
{
  auto* label =
    new QLabel(WriteLabel(QString::fromStdString(parameter.GetLabel())), edit->parentWidget());
  label->setToolTip(edit->toolTip());
  label->setBuddy(edit);
  rows->addRow(label, edit);
}
}
