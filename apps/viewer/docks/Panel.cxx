// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Panel.h"

#include "OptionEdits.h"
#include "Options.h"

#include <QVBoxLayout>

namespace viewer
{
namespace
{
constexpr int LeastWidth = 340;
}

//------------------------------------------------------------------------------
Panel::Panel(Document* document, QWidget* parent)
  : QScrollArea(parent)
  , Edited(document)
{
  auto* all = new QWidget(this);
  this->Outer = new QVBoxLayout(all);
  this->Column = new QVBoxLayout();
  this->Outer->addLayout(this->Column);
  this->Outer->addStretch(1);
  this->setWidget(all);
  this->setWidgetResizable(true);
  this->setFrameShape(QFrame::NoFrame);
  this->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  this->setMinimumWidth(LeastWidth);
}

//------------------------------------------------------------------------------
QSize Panel::sizeHint() const
{
  return { LeastWidth, this->QScrollArea::sizeHint().height() };
}

//------------------------------------------------------------------------------
FoldGroup* Panel::AddGroup(const QString& title, const QString& name)
{
  auto* group = new FoldGroup(title, name, this->widget());
  this->AddGroup(group);
  return group;
}

//------------------------------------------------------------------------------
void Panel::AddGroup(FoldGroup* group)
{
  this->Column->addWidget(group);
}

//------------------------------------------------------------------------------
void Panel::AddOptions(const std::string& panel)
{
  FoldGroup* group = nullptr;
  for (const vtkRelievoOption& option : scene::GetRenderCommand().Options)
  {
    if (option.Panel == panel && !option.HasOwnControl)
    {
      group = group ? group : this->AddGroup("More", "more" + QString::fromStdString(panel));
      AddOption(this->Edited, group->GetRows(), option);
    }
  }
}

//------------------------------------------------------------------------------
void Panel::Fill(QGroupBox* group)
{
  this->Outer->setStretch(0, 1);
  this->Outer->setStretch(1, 0);
  this->Column->setStretchFactor(group, 1);
}

//------------------------------------------------------------------------------
QFormLayout* Panel::GetRows(QGroupBox* group)
{
  return static_cast<FoldGroup*>(group)->GetRows();
}
}
