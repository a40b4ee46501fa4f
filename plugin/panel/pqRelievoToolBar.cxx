// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqRelievoToolBar.h"

#include "pqActiveObjects.h"
#include "pqRelievoViewSettings.h"
#include "vtkCommand.h"
#include "vtkSMProxy.h"

#include <QAction>
#include <QSignalBlocker>

//------------------------------------------------------------------------------
pqRelievoToolBar::pqRelievoToolBar(QWidget* parent)
  : Superclass("Relievo", parent)
{
  this->setObjectName("pqRelievoToolBar");
  this->Shadows = this->addAction(QIcon(":/relievo/shadows.svg"), "Shadows");
  this->Shadows->setObjectName("actionRelievoShadows");
  this->Shadows->setToolTip("Shadows in the active view");
  this->Sun = this->addAction(QIcon(":/relievo/sun.svg"), "World-fixed sun");
  this->Sun->setObjectName("actionRelievoSun");
  this->Sun->setToolTip(
    "A light that stays where it is when the camera moves, with its shadows, in the active view");
  for (QAction* action : { this->Shadows, this->Sun })
  {
    action->setCheckable(true);
  }
  QObject::connect(this->Shadows, &QAction::toggled, this, [](bool on) {
    pqRelievoViewSettings::SetShadows(pqActiveObjects::instance().activeView(), on);
  });
  QObject::connect(this->Sun, &QAction::toggled, this,
    [](bool on) { pqRelievoViewSettings::SetSun(pqActiveObjects::instance().activeView(), on); });
  QObject::connect(&pqActiveObjects::instance(), &pqActiveObjects::viewChanged, this,
    [this](pqView*) { this->Rewatch(); });
  this->Rewatch();
}

//------------------------------------------------------------------------------
void pqRelievoToolBar::Rewatch()
{
  this->Connector->Disconnect();
  vtkSMProxy* settings = pqRelievoViewSettings::Find(pqActiveObjects::instance().activeView());
  if (settings)
  {
    this->Connector->Connect(settings, vtkCommand::PropertyModifiedEvent, this, SLOT(ShowState()));
  }
  this->setEnabled(settings != nullptr);
  this->ShowState();
}

//------------------------------------------------------------------------------
void pqRelievoToolBar::ShowState()
{
  pqView* view = pqActiveObjects::instance().activeView();
  const QSignalBlocker quiet[] = { QSignalBlocker(this->Shadows), QSignalBlocker(this->Sun) };
  this->Shadows->setChecked(pqRelievoViewSettings::AreShadowsOn(view));
  this->Sun->setChecked(pqRelievoViewSettings::IsSunOn(view));
}
