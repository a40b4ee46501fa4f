// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RangeEdit.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>

#include <cmath>

namespace relievoQt
{
namespace
{
constexpr int RangeDigits = 5; // significant digits of automatic values
}

//------------------------------------------------------------------------------
RangeEdit::RangeEdit(QWidget* parent)
  : QWidget(parent)
  , Automatic(new QCheckBox("Automatic", this))
  , Least(new QLineEdit(this))
  , Most(new QLineEdit(this))
  , Unit(new QLabel(this))
{
  this->Automatic->setObjectName("automaticRange");
  this->Automatic->setChecked(true);
  this->Least->setObjectName("least");
  this->Least->setToolTip("The value of the first colour");
  this->Most->setObjectName("most");
  this->Most->setToolTip("The value of the last colour");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  this->Unit->setObjectName("unit");
  auto* first = new QHBoxLayout();
  first->addWidget(this->Automatic, 1);
  first->addWidget(this->Unit);
  column->addLayout(first);
  auto* both = new QHBoxLayout();
  both->addWidget(this->Least, 1);
  both->addWidget(new QLabel("to", this));
  both->addWidget(this->Most, 1);
  column->addLayout(both);
  this->Show("", "");
  QObject::connect(this->Automatic, &QCheckBox::toggled, this, &RangeEdit::automaticSwitched);
  for (QLineEdit* end : { this->Least, this->Most })
  {
    end->setMinimumWidth(40);
    QObject::connect(end, &QLineEdit::editingFinished, this, &RangeEdit::Take);
  }
}

//------------------------------------------------------------------------------
void RangeEdit::SetAutomaticToolTip(const QString& text)
{
  this->Automatic->setToolTip(text);
}

//------------------------------------------------------------------------------
void RangeEdit::SetUnit(const QString& unit)
{
  this->Unit->setText(unit.isEmpty() ? unit : "in " + unit);
}

//------------------------------------------------------------------------------
void RangeEdit::Take()
{
  const QString least = this->Least->text().trimmed();
  const QString most = this->Most->text().trimmed();
  if (this->Automatic->isChecked() || (least == this->Given[0] && most == this->Given[1]))
  {
    return;
  }
  bool numbers[2];
  least.toDouble(&numbers[0]);
  most.toDouble(&numbers[1]);
  if (numbers[0] && numbers[1])
  {
    Q_EMIT this->typed(least, most);
  }
  else
  {
    this->Show(this->Given[0], this->Given[1]);
  }
}

//------------------------------------------------------------------------------
void RangeEdit::Show(const QString& least, const QString& most)
{
  const QSignalBlocker quiet(this->Automatic);
  const bool given = !least.isEmpty();
  this->Automatic->setChecked(!given);
  this->Given[0] = least;
  this->Given[1] = most;
  this->Least->setText(least);
  this->Most->setText(most);
  for (QLineEdit* end : { this->Least, this->Most })
  {
    end->setEnabled(given);
    end->setPlaceholderText(QString());
  }
}

//------------------------------------------------------------------------------
void RangeEdit::ShowFound(const std::array<double, 2>& range)
{
  const bool any = std::isfinite(range[0]) && range[0] < range[1];
  this->Least->setPlaceholderText(any ? QString::number(range[0], 'g', RangeDigits) : QString());
  this->Most->setPlaceholderText(any ? QString::number(range[1], 'g', RangeDigits) : QString());
}
}
