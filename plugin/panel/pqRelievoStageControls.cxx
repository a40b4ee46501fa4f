// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqRelievoStageControls.h"

#include "pqProxyWidget.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyIterator.h"
#include "vtkSMViewProxy.h"
#include "vtkSmartPointer.h"

#include <QStringList>
#include <QVBoxLayout>

namespace
{
// The view's properties of stages, by the names that describeProperties.cxx gives them.
QStringList FindProperties(vtkSMProxy* view)
{
  QStringList names;
  const auto each = vtkSmartPointer<vtkSMPropertyIterator>::Take(view->NewPropertyIterator());
  for (each->Begin(); !each->IsAtEnd(); each->Next())
  {
    if (QString(each->GetKey()).startsWith("RelievoStage"))
    {
      names << each->GetKey();
    }
  }
  return names;
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
  const bool other = view != this->View;
  this->Superclass::SetView(view);
  if (!other && this->Properties)
  {
    return;
  }
  delete this->Properties;
  this->Properties = nullptr;
  const QStringList names = this->View ? FindProperties(this->View->getProxy()) : QStringList();
  this->setVisible(!names.isEmpty());
  if (names.isEmpty())
  {
    return;
  }
  this->Properties = new pqProxyWidget(this->View->getProxy(), names, true, this);
  this->Properties->setObjectName("stages");
  this->Properties->setApplyChangesImmediately(true);
  this->Properties->filterWidgets(true);
  QObject::connect(this->Properties, &pqProxyWidget::changeFinished, this, [this]() {
    if (this->View)
    {
      this->View->render();
    }
  });
  this->Rows->addWidget(this->Properties);
}
