// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqRelievoControls.h"

#include "Number.h"
#include "pqView.h"
#include "vtkCommand.h"
#include "vtkSMProxy.h"

#include <QComboBox>
#include <QLayout>
#include <QSignalBlocker>
#include <QToolButton>

//------------------------------------------------------------------------------
pqRelievoControls::pqRelievoControls(QWidget* parent)
  : Superclass(parent)
{
}

//------------------------------------------------------------------------------
void pqRelievoControls::MakeHead(QWidget* head)
{
  QFont font = head->font();
  font.setBold(true);
  head->setFont(font);
}

//------------------------------------------------------------------------------
void pqRelievoControls::Indent(QWidget* part)
{
  part->layout()->setContentsMargins(14, 0, 0, 0);
}

//------------------------------------------------------------------------------
QToolButton* pqRelievoControls::MakeFold(const QString& text, QWidget* rest, QWidget* parent)
{
  auto* fold = new QToolButton(parent);
  fold->setObjectName("fold");
  fold->setText(text);
  fold->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  fold->setAutoRaise(true);
  fold->setCheckable(true);
  fold->setArrowType(Qt::RightArrow);
  rest->hide();
  QObject::connect(fold, &QToolButton::toggled, rest, [fold, rest](bool open) {
    fold->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
    rest->setVisible(open);
  });
  return fold;
}

//------------------------------------------------------------------------------
void pqRelievoControls::SetView(pqView* view)
{
  this->Connector->Disconnect();
  if (this->View)
  {
    QObject::disconnect(this->View, nullptr, this, nullptr);
  }
  this->Before.clear();
  vtkSMProxy* settings = pqRelievoViewSettings::Find(view);
  this->View = settings ? view : nullptr;
  this->setEnabled(settings != nullptr);
  if (settings)
  {
    QObject::connect(view, &pqView::endRender, this, &pqRelievoControls::ShowScene);
    this->Connector->Connect(settings, vtkCommand::PropertyModifiedEvent, this, SLOT(ShowState()));
    // Values computed by the view are available only after it has received the properties.
    this->Connector->Connect(settings, vtkCommand::UpdateEvent, this, SLOT(ShowState()));
  }
  this->ShowState();
}

//------------------------------------------------------------------------------
void pqRelievoControls::ShowState()
{
  for (auto number = this->Numbers.begin(); number != this->Numbers.end(); ++number)
  {
    number.key()->SetValue(this->Get(number.value()).toDouble());
  }
  for (auto choice = this->Choices.begin(); choice != this->Choices.end(); ++choice)
  {
    const QSignalBlocker quiet(choice.key());
    const int value = this->Get(choice.value()).toInt();
    if (this->View && choice.key()->findData(value) < 0)
    {
      choice.key()->addItem(QString::number(value), value); // set by a script
    }
    choice.key()->setCurrentIndex(choice.key()->findData(value));
  }
}

//------------------------------------------------------------------------------
QVariant pqRelievoControls::Get(const char* name) const
{
  return pqRelievoViewSettings::Get(this->View, name);
}

//------------------------------------------------------------------------------
void pqRelievoControls::Apply(
  const QString& label, const QVector<pqRelievoViewSettings::Change>& changes)
{
  pqRelievoViewSettings::Apply(this->View, label, changes);
}

//------------------------------------------------------------------------------
void pqRelievoControls::Bind(relievoQt::Number* number, const char* property, const QString& label)
{
  this->Numbers[number] = property;
  number->AlignDigits();
  QObject::connect(
    number, &relievoQt::Number::edited, this, [this, property, label](double value, bool held) {
      held ? this->Try(property, value) : this->Settle(property, value, label);
    });
}

//------------------------------------------------------------------------------
void pqRelievoControls::Bind(QComboBox* choice, const char* property, const QString& label)
{
  this->Choices[choice] = property;
  QObject::connect(choice, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
    [this, choice, property, label](int i) {
      this->Apply(label, { { property, choice->itemData(i).toInt() } });
    });
}

//------------------------------------------------------------------------------
void pqRelievoControls::Try(const char* property, double value)
{
  if (!this->Before.contains(property))
  {
    this->Before[property] = this->Get(property);
  }
  pqRelievoViewSettings::Try(this->View, { { property, value } });
}

//------------------------------------------------------------------------------
void pqRelievoControls::Settle(const char* property, double value, const QString& label)
{
  if (this->Before.contains(property))
  {
    // One undo step from the start of the drag.
    pqRelievoViewSettings::Try(this->View, { { property, this->Before.take(property) } });
  }
  if (this->Get(property).toDouble() != value)
  {
    this->Apply(label, { { property, value } });
  }
}
