// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqRelievoViewWidget.h"

#include "pqApplicationCore.h"
#include "pqRenderView.h"
#include "pqServerManagerModel.h"
#include "vtkSMProxy.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QSignalBlocker>

//------------------------------------------------------------------------------
pqRelievoViewWidget::pqRelievoViewWidget(
  vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parentWidget)
  : Superclass(proxy, parentWidget)
  , Views(new QComboBox(this))
{
  this->Views->setObjectName("Views");
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(this->Views);
  this->ListViews();

  auto* model = pqApplicationCore::instance()->getServerManagerModel();
  this->connect(model, SIGNAL(viewAdded(pqView*)), SLOT(ListViews()));
  this->connect(model, SIGNAL(viewRemoved(pqView*)), SLOT(ListViews()));
  this->connect(model, SIGNAL(nameChanged(pqServerManagerModelItem*)), SLOT(ListViews()));
  QObject::connect(this->Views,
    static_cast<void (QComboBox::*)(int)>(&QComboBox::currentIndexChanged), this, [this](int i) {
      this->Chosen = this->Views->itemData(i).value<pqSMProxy>();
      Q_EMIT this->chosenChanged();
    });
  this->addPropertyLink(this, "chosen", SIGNAL(chosenChanged()), property);
  this->setChangeAvailableAsChangeFinished(true);
}

//------------------------------------------------------------------------------
pqRelievoViewWidget::~pqRelievoViewWidget() = default;

//------------------------------------------------------------------------------
void pqRelievoViewWidget::ListViews()
{
  const QSignalBlocker blocker(this->Views);
  this->Views->clear();
  int current = -1;
  const auto views =
    pqApplicationCore::instance()->getServerManagerModel()->findItems<pqRenderView*>();
  for (pqRenderView* view : views)
  {
    if (view->getProxy()->GetSession() != this->proxy()->GetSession())
    {
      continue;
    }
    if (view->getProxy() == this->Chosen)
    {
      current = this->Views->count();
    }
    this->Views->addItem(view->getSMName(), QVariant::fromValue(pqSMProxy(view->getProxy())));
  }
  this->Views->setCurrentIndex(current);
}

//------------------------------------------------------------------------------
pqSMProxy pqRelievoViewWidget::GetChosen() const
{
  return this->Chosen;
}

//------------------------------------------------------------------------------
void pqRelievoViewWidget::SetChosen(const pqSMProxy& view)
{
  if (this->Chosen != view)
  {
    this->Chosen = view;
    this->ListViews();
    Q_EMIT this->chosenChanged();
  }
}
