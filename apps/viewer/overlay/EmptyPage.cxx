// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "EmptyPage.h"

#include <QFrame>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace viewer
{
namespace
{
constexpr int FrameWidth = 480; // pixels
}

//------------------------------------------------------------------------------
EmptyPage::EmptyPage(QWidget* parent)
  : QWidget(parent)
  , Title(new QLabel(this))
  , Words(new QLabel(this))
  , Open(new QPushButton(this))
{
  auto* frame = new QFrame(this);
  frame->setFrameShape(QFrame::StyledPanel);
  frame->setMaximumWidth(FrameWidth);
  frame->setAutoFillBackground(true);
  frame->setBackgroundRole(QPalette::Base);
  QFont font = this->Title->font();
  font.setPointSizeF(1.3 * font.pointSizeF());
  font.setBold(true);
  this->Title->setFont(font);
  this->Words->setObjectName("emptyWords");
  this->Words->setWordWrap(true);
  this->Words->setTextFormat(Qt::PlainText);
  this->Words->setTextInteractionFlags(Qt::TextSelectableByMouse);
  this->Open->setObjectName("emptyOpen");
  auto* column = new QVBoxLayout(frame);
  column->setContentsMargins(24, 20, 24, 20);
  column->setSpacing(12);
  column->addWidget(this->Title);
  column->addWidget(this->Words);
  column->addWidget(this->Open, 0, Qt::AlignLeft);
  auto* all = new QGridLayout(this);
  all->addWidget(frame, 0, 0, Qt::AlignVCenter);
  QObject::connect(this->Open, &QPushButton::clicked, this, &EmptyPage::openWanted);
  this->ShowHint();
}

//------------------------------------------------------------------------------
void EmptyPage::Show(const QString& title, const QString& text, const QString& button)
{
  this->Title->setText(title);
  this->Words->setText(text);
  this->Open->setText(button);
  this->Open->setVisible(!button.isEmpty());
}

//------------------------------------------------------------------------------
void EmptyPage::ShowHint()
{
  this->Show("Nothing is open", "Open a file (Ctrl+O), or drop one here.", "Open...");
}

//------------------------------------------------------------------------------
void EmptyPage::ShowReading(const QString& what)
{
  this->Show("Reading", what, QString());
}

//------------------------------------------------------------------------------
void EmptyPage::ShowTrouble(const QString& text)
{
  this->Show("There is nothing to show", text, "Open another...");
}
}
