// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FoldGroup.h"

#include <QEvent>
#include <QFormLayout>
#include <QMouseEvent>
#include <QStyleOptionGroupBox>
#include <QStylePainter>
#include <QToolButton>
#include <QVBoxLayout>

namespace viewer
{
namespace
{
QFormLayout* MakeRows()
{
  auto* rows = new QFormLayout();
  rows->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  return rows;
}

// Before the first show, isHidden() is true for every widget.
bool IsShown(const QWidget* widget)
{
  return !widget->isHidden() || !widget->testAttribute(Qt::WA_WState_ExplicitShowHide);
}

// Whether a layout has any visible widget.
bool HasShown(const QFormLayout* rows)
{
  for (int i = 0; i < rows->count(); ++i)
  {
    const QWidget* widget = rows->itemAt(i)->widget();
    if (!widget || IsShown(widget))
    {
      return true;
    }
  }
  return false;
}
}

//------------------------------------------------------------------------------
FoldGroup::FoldGroup(const QString& title, const QString& name, QWidget* parent)
  : QGroupBox(title, parent)
  , Content(new QWidget(this))
  , Column(new QVBoxLayout(this->Content))
  , Rows(MakeRows())
  , Arrow(new QToolButton(this))
{
  this->setObjectName(name);
  this->Arrow->setObjectName("fold");
  this->Arrow->setAutoRaise(true);
  this->Arrow->setFocusPolicy(Qt::TabFocus);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->addWidget(this->Content);
  this->Column->addLayout(this->Rows);
  this->Content->installEventFilter(this);
  QObject::connect(this->Arrow, &QToolButton::clicked, this, [this] { this->Fold(!this->Folded); });
  this->Arrange();
}

//------------------------------------------------------------------------------
QFormLayout* FoldGroup::GetAdvanced()
{
  if (!this->Advanced)
  {
    auto* title = new QToolButton(this->Content);
    title->setObjectName("advanced");
    title->setText("Advanced");
    title->setToolTip("Expert settings");
    title->setAutoRaise(true);
    title->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    title->setArrowType(Qt::RightArrow);
    auto* section = new QWidget(this->Content);
    section->setObjectName("advancedRows");
    section->hide();
    this->Advanced = MakeRows();
    section->setLayout(this->Advanced);
    this->Advanced->setContentsMargins(0, 0, 0, 0);
    this->Column->addWidget(title, 0, Qt::AlignLeft);
    this->Column->addWidget(section);
    QObject::connect(title, &QToolButton::clicked, section, [title, section] {
      const bool open = section->isHidden();
      title->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
      section->setVisible(open);
    });
  }
  return this->Advanced;
}

//------------------------------------------------------------------------------
void FoldGroup::AddBelow(QWidget* widget)
{
  this->Below = widget;
  this->Column->addWidget(widget);
}

//------------------------------------------------------------------------------
void FoldGroup::Fold(bool folded)
{
  this->Folded = folded;
  this->Arrange();
}

//------------------------------------------------------------------------------
// The switch enables the rows even when its signals are blocked.
bool FoldGroup::eventFilter(QObject* watched, QEvent* event)
{
  if (watched == this->Content && event->type() == QEvent::EnabledChange)
  {
    this->Arrange();
  }
  return this->QGroupBox::eventFilter(watched, event);
}

//------------------------------------------------------------------------------
void FoldGroup::Arrange()
{
  const bool on = !this->isCheckable() || this->isChecked();
  this->Folded = this->Folded && (on == this->On);
  this->On = on;
  const bool none = this->Rows->count() == 0 ? this->Below != nullptr : !HasShown(this->Rows);
  const bool empty = !this->Advanced && none && !(this->Below && IsShown(this->Below));
  this->Content->setVisible(on && !this->Folded && !empty);
  this->Arrow->setVisible(on && !empty);
  this->Arrow->setArrowType(this->Folded ? Qt::RightArrow : Qt::DownArrow);
  const QString what = this->Folded ? "Unfold " : "Fold ";
  this->Arrow->setToolTip(what + this->title());
  this->Arrow->setAccessibleName(what + this->title());
  this->updateGeometry();
  this->update();
}

//------------------------------------------------------------------------------
QRect FoldGroup::GetTitle() const
{
  QStyleOptionGroupBox option;
  this->initStyleOption(&option);
  return this->style()->subControlRect(
    QStyle::CC_GroupBox, &option, QStyle::SC_GroupBoxLabel, this);
}

//------------------------------------------------------------------------------
QSize FoldGroup::sizeHint() const
{
  return this->Limit(this->QGroupBox::sizeHint());
}

//------------------------------------------------------------------------------
QSize FoldGroup::minimumSizeHint() const
{
  return this->Limit(this->QGroupBox::minimumSizeHint());
}

//------------------------------------------------------------------------------
QSize FoldGroup::Limit(QSize size) const
{
  return this->Content->isHidden() ? QSize(size.width(), this->GetTitle().bottom() + 1) : size;
}

//------------------------------------------------------------------------------
// A title without a switch folds as well.
void FoldGroup::mouseReleaseEvent(QMouseEvent* event)
{
  if (!this->isCheckable() && this->GetTitle().contains(event->pos()))
  {
    this->Fold(!this->Folded);
  }
  this->QGroupBox::mouseReleaseEvent(event);
}

//------------------------------------------------------------------------------
void FoldGroup::resizeEvent(QResizeEvent* event)
{
  this->QGroupBox::resizeEvent(event);
  const QRect title = this->GetTitle();
  const int side = title.height();
  this->Arrow->setGeometry(this->width() - side, title.top(), side, side);
}

//------------------------------------------------------------------------------
// Styles draw a frame around empty contents too, which looks like a missing widget.
void FoldGroup::paintEvent(QPaintEvent*)
{
  QStylePainter painter(this);
  QStyleOptionGroupBox option;
  this->initStyleOption(&option);
  if (this->Content->isHidden())
  {
    option.subControls &= ~QStyle::SC_GroupBoxFrame;
  }
  painter.drawComplexControl(QStyle::CC_GroupBox, option);
}
}
