// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TripleEdit.h"

#include "DigitsBox.h"

#include <QHBoxLayout>
#include <QSignalBlocker>

namespace viewer
{
namespace
{
constexpr double Largest = 1e9; // limit of the spin boxes
constexpr int Decimals = 4;
constexpr int LeastWidth = 50;
}

//------------------------------------------------------------------------------
TripleEdit::TripleEdit(QWidget* parent)
  : QWidget(parent)
{
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(2);
  for (std::size_t i = 0; i < 3; ++i)
  {
    auto* box = this->Boxes[i] = new relievoQt::DigitsBox(this);
    box->setObjectName(QString("xyz").mid(static_cast<int>(i), 1));
    box->setRange(-Largest, Largest);
    box->setDecimals(Decimals);
    box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    box->setKeyboardTracking(false);
    box->setMinimumWidth(LeastWidth);
    box->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    box->setToolTip(box->objectName() + ", in world units");
    row->addWidget(box, 1);
    QObject::connect(box,
      static_cast<void (QDoubleSpinBox::*)(double)>(&QDoubleSpinBox::valueChanged), this,
      [this, i](double value) {
        this->Value[i] = value;
        Q_EMIT this->edited();
      });
  }
  this->setFocusProxy(this->Boxes[0]);
}

//------------------------------------------------------------------------------
void TripleEdit::SetValue(const std::array<double, 3>& value)
{
  this->Value = value;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const QSignalBlocker quiet(this->Boxes[i]);
    this->Boxes[i]->setValue(value[i]);
  }
}
}
