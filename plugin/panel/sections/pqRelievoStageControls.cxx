// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqRelievoStageControls.h"

#include "pqProxyWidget.h"
#include "pqRelievoScene.h"
#include "vtkPVRelievoView.h"
#include "vtkRelievoParameter.h"
#include "vtkRelievoPass.h"
#include "vtkRelievoPointStage.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyIterator.h"
#include "vtkSMViewProxy.h"
#include "vtkSmartPointer.h"

#include <QStringList>
#include <QVBoxLayout>

namespace
{
// The view's properties of a stage, by the names from describeProperties.cxx: the switch first,
// then its parameters. Empty if the stage has no properties.
QStringList FindProperties(vtkSMProxy* view, const QString& name)
{
  const QString on = "RelievoStage" + name;
  QStringList names;
  const auto each = vtkSmartPointer<vtkSMPropertyIterator>::Take(view->NewPropertyIterator());
  for (each->Begin(); !each->IsAtEnd(); each->Next())
  {
    const QString key = each->GetKey();
    if (key.startsWith(on) && key != on)
    {
      names << key;
    }
  }
  return view->GetProperty(qUtf8Printable(on)) ? QStringList(on) + names : QStringList();
}
}

//------------------------------------------------------------------------------
pqRelievoStageControls::pqRelievoStageControls(QWidget* parent)
  : Superclass(parent)
  , Rows(new QVBoxLayout(this))
{
  this->Rows->setContentsMargins(0, 0, 0, 0);
  this->hide();
}

//------------------------------------------------------------------------------
void pqRelievoStageControls::SetView(pqView* view)
{
  this->Superclass::SetView(view);
  vtkPVRelievoView* here = pqRelievoViewSettings::FindHere(this->View);
  if (this->Shown != this->View || this->Parts.isEmpty())
  {
    qDeleteAll(this->Parts);
    this->Parts.clear();
    this->Of.clear();
    for (int i = 0; here && i < here->GetFrame()->GetNumberOfStages(); ++i)
    {
      vtkRelievoStage* stage = here->GetFrame()->GetStage(i);
      const QString name =
        QString::fromStdString(vtkRelievoCapitalize(stage->GetDescription().Name, false));
      this->AddStage(FindProperties(this->View->getProxy(), name),
        vtkRelievoPointStage::SafeDownCast(stage) ? "Relievo" + name : QString());
    }
    this->Shown = this->View;
  }
  this->setVisible(!this->Parts.isEmpty());
  this->ShowScene();
}

//------------------------------------------------------------------------------
void pqRelievoStageControls::AddStage(const QStringList& properties, const QString& points)
{
  if (properties.isEmpty())
  {
    return;
  }
  auto* part = new QWidget(this);
  part->setObjectName(properties.front());
  auto* rows = new QVBoxLayout(part);
  rows->setContentsMargins(0, 0, 0, 0);
  this->AddProperties(properties.mid(0, 1), part);
  if (properties.size() > 1)
  {
    auto* rest = new QWidget(part);
    rest->setObjectName("rest");
    (new QVBoxLayout(rest))->setSpacing(0);
    Indent(rest);
    rows->addWidget(rest);
    this->AddProperties(properties.mid(1), rest);
  }
  this->Rows->addWidget(part);
  this->Parts.append(part);
  if (!points.isEmpty())
  {
    this->Of[points] = part;
  }
}

//------------------------------------------------------------------------------
void pqRelievoStageControls::AddProperties(const QStringList& properties, QWidget* part)
{
  auto* widget = new pqProxyWidget(this->View->getProxy(), properties, true, part);
  widget->setObjectName("stages");
  widget->setApplyChangesImmediately(true);
  widget->filterWidgets(true);
  QObject::connect(widget, &pqProxyWidget::changeFinished, this, [this]() {
    if (this->View)
    {
      this->View->render();
    }
  });
  part->layout()->addWidget(widget);
}

//------------------------------------------------------------------------------
void pqRelievoStageControls::ShowScene()
{
  for (auto part = this->Of.begin(); part != this->Of.end(); ++part)
  {
    const bool marked = part.key() == "RelievoMarkers" && this->IsOn("RelievoMarkSelection");
    part.value()->setVisible(marked || pqRelievoScene::IsUsed(this->View, part.key()));
  }
}
