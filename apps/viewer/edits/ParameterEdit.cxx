// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ParameterEdit.h"

#include "ColorButton.h"
#include "Number.h"
#include "Settings.h"

#include "vtkRelievoParameter.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace viewer
{
//------------------------------------------------------------------------------
ParameterEdit::ParameterEdit(const vtkRelievoParameter& parameter, QWidget* parent)
  : QWidget(parent)
{
  QWidget* edit = nullptr;
  switch (parameter.Type)
  {
    case vtkRelievoParameter::FLAG:
      edit = this->MakeFlag();
      break;
    case vtkRelievoParameter::WHOLE:
    case vtkRelievoParameter::NUMBER:
      edit = this->MakeNumber(parameter);
      break;
    case vtkRelievoParameter::CHOICE:
      edit = this->MakeChoice(parameter);
      break;
    case vtkRelievoParameter::COLOR:
      edit = this->MakeColor();
      break;
    default:
      edit = this->MakeText();
      break;
  }
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(edit, 1);
  edit->setObjectName("edit");
  this->setFocusProxy(edit);
  this->setToolTip(QString::fromStdString(
    "<p>" + parameter.Help + "</p><p>Takes " + parameter.GetExpected() + ".</p>"));
}

//------------------------------------------------------------------------------
QWidget* ParameterEdit::MakeFlag()
{
  auto* box = new QCheckBox(this);
  this->Show = [box](const QString& words) {
    const QSignalBlocker quiet(box);
    box->setChecked(words == "on");
  };
  QObject::connect(
    box, &QCheckBox::toggled, this, [this](bool on) { Q_EMIT this->edited(on ? "on" : "off"); });
  return box;
}

//------------------------------------------------------------------------------
QWidget* ParameterEdit::MakeNumber(const vtkRelievoParameter& parameter)
{
  const bool whole = parameter.Type == vtkRelievoParameter::WHOLE;
  const bool usual = parameter.Usual > 0.0;
  const double least = usual ? 0.0 : parameter.Least;
  const double most = usual ? parameter.Usual : parameter.Most;
  const double range = most - least;
  const double step = whole ? 1.0 : range <= 1.0 ? 0.001 : range <= 100.0 ? 0.05 : 1.0;
  auto* number = new relievoQt::Number(least, most, step,
    whole               ? 0
      : range <= 1.0    ? 5
      : range <= 1000.0 ? 3
                        : 2,
    this);
  number->SetUnit(QString::fromStdString(parameter.Unit));
  if (parameter.Name == "light" && whole && least == -1.0)
  {
    number->SetSpecial("first that casts");
  }
  if (usual)
  {
    number->SetTypedRange(std::max(parameter.Least, -1e9), std::min(parameter.Most, 1e9));
  }
  this->Show = [number](const QString& words) { number->SetValue(words.toDouble()); };
  QObject::connect(number, &relievoQt::Number::edited, this, [this](double value) {
    Q_EMIT this->edited(QString::fromStdString(words::WriteNumber(value)));
  });
  return number;
}

//------------------------------------------------------------------------------
QWidget* ParameterEdit::MakeChoice(const vtkRelievoParameter& parameter)
{
  auto* box = new QComboBox(this);
  for (std::size_t i = 0; i < parameter.Choices.size(); ++i)
  {
    QString label = QString::fromStdString(parameter.GetChoiceLabel(i));
    box->addItem(
      label.replace(0, 1, label.left(1).toUpper()), QString::fromStdString(parameter.Choices[i]));
  }
  this->Show = [box](const QString& words) {
    const QSignalBlocker quiet(box);
    box->setCurrentIndex(box->findData(words));
  };
  QObject::connect(box, static_cast<void (QComboBox::*)(int)>(&QComboBox::currentIndexChanged),
    this, [this, box] { Q_EMIT this->edited(box->currentData().toString()); });
  return box;
}

//------------------------------------------------------------------------------
QWidget* ParameterEdit::MakeColor()
{
  auto* button = new ColorButton(this);
  this->Show = [button](const QString& words) {
    const QStringList parts = words.split(',');
    if (parts.size() == 3)
    {
      button->SetColor(
        QColor::fromRgbF(parts[0].toDouble(), parts[1].toDouble(), parts[2].toDouble()));
    }
  };
  QObject::connect(button, &ColorButton::edited, this, [this](const QColor& color) {
    Q_EMIT this->edited(QString::fromStdString(
      words::WriteNumbers({ color.red() / 255.0, color.green() / 255.0, color.blue() / 255.0 })));
  });
  return button;
}

//------------------------------------------------------------------------------
QWidget* ParameterEdit::MakeText()
{
  auto* line = new QLineEdit(this);
  this->Show = [line](const QString& words) {
    if (line->text() != words)
    {
      line->setText(words);
    }
  };
  QObject::connect(
    line, &QLineEdit::editingFinished, this, [this, line] { Q_EMIT this->edited(line->text()); });
  return line;
}
}
