// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqRelievoStartUp.h"

#include "pqActiveObjects.h"
#include "pqCoreUtilities.h"
#include "pqDataRepresentation.h"
#include "pqPropertiesPanel.h"
#include "pqRelievoPanel.h"
#include "pqRelievoRefiner.h"
#include "pqRelievoToolBar.h"
#include "vtkCommand.h"
#include "vtkSMRelievoViews.h"

//------------------------------------------------------------------------------
pqRelievoStartUp::pqRelievoStartUp(QObject* parent)
  : Superclass(parent)
{
}

//------------------------------------------------------------------------------
void pqRelievoStartUp::OnStartUp()
{
  if (auto* views = vtkSMRelievoViews::GetInstance())
  {
    this->Connector->Connect(views, vtkCommand::UpdateEvent, this, SLOT(Refresh()));
  }
  new pqRelievoRefiner(this);
}

//------------------------------------------------------------------------------
void pqRelievoStartUp::OnShutDown()
{
  this->Connector->Disconnect();
}

//------------------------------------------------------------------------------
void pqRelievoStartUp::Refresh()
{
  QWidget* window = pqCoreUtilities::mainWidget();
  if (!window)
  {
    return;
  }
  for (pqPropertiesPanel* panel : window->findChildren<pqPropertiesPanel*>())
  {
    // ParaView makes a panel's widgets when the view or the representation changes.
    pqView* view = panel->view();
    panel->setView(nullptr);
    panel->setView(view);
    pqDataRepresentation* shown = pqActiveObjects::instance().activeRepresentation();
    panel->setRepresentation(nullptr);
    panel->setRepresentation(shown);
  }
  for (pqRelievoPanel* panel : window->findChildren<pqRelievoPanel*>())
  {
    panel->Rewatch();
  }
  for (pqRelievoToolBar* bar : window->findChildren<pqRelievoToolBar*>())
  {
    bar->Rewatch();
  }
}
