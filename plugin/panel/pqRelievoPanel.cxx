// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqRelievoPanel.h"

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqRelievoEnvironmentControls.h"
#include "pqRelievoLayerControls.h"
#include "pqRelievoReportView.h"
#include "pqRelievoShadowControls.h"
#include "pqRelievoStageControls.h"
#include "pqRelievoSunControls.h"
#include "pqRelievoViewSettings.h"
#include "pqSettings.h"
#include "pqView.h"
#include "vtkSMRenderViewProxy.h"

#include <QFrame>
#include <QLabel>
#include <QMainWindow>
#include <QScrollArea>
#include <QStringList>
#include <QStyle>
#include <QTimer>
#include <QVBoxLayout>

namespace
{
QWidget* MakeLine(QWidget* parent)
{
  auto* line = new QFrame(parent);
  line->setFrameShape(QFrame::HLine);
  line->setFrameShadow(QFrame::Sunken);
  return line;
}
}

//------------------------------------------------------------------------------
pqRelievoPanel::pqRelievoPanel(QWidget* parent)
  : Superclass("Relievo", parent)
{
  this->setObjectName("pqRelievoPanel");
  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  auto* content = new QWidget(scroll);
  content->setObjectName("content");
  auto* layout = new QVBoxLayout(content);
  this->Heading = new QLabel(content);
  this->Heading->setObjectName("heading");
  this->Message = new QLabel(content);
  this->Message->setObjectName("message");
  this->Message->setWordWrap(true);
  this->All = new QWidget(content);
  this->All->setObjectName("all");

  auto* sections = new QVBoxLayout(this->All);
  sections->setContentsMargins(0, 0, 0, 0);
  // The sun switches shadows on: their rows are below its own, so that no row moves under the
  // mouse.
  this->Sections = { new pqRelievoSunControls(this->All), new pqRelievoShadowControls(this->All),
    new pqRelievoEnvironmentControls(this->All), new pqRelievoLayerControls(this->All),
    new pqRelievoStageControls(this->All) };
  const char* names[] = { "sun", "shadows", "environment", "layers", "stages" };
  for (int i = 0; i < this->Sections.size(); ++i)
  {
    this->Sections[i]->setObjectName(names[i]);
    if (i > 0)
    {
      sections->addWidget(MakeLine(this->All));
    }
    sections->addWidget(this->Sections[i]);
  }
  sections->addWidget(MakeLine(this->All));
  this->Report = new pqRelievoReportView(this->All);
  this->Report->setObjectName("report");
  sections->addWidget(this->Report);

  layout->addWidget(this->Heading);
  layout->addWidget(this->Message);
  layout->addWidget(this->All);
  layout->addStretch(1);
  scroll->setWidget(content);
  // A fixed width fits all contents, and keeps the size of the views beside the dock.
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setMinimumWidth(
    content->minimumSizeHint().width() + this->style()->pixelMetric(QStyle::PM_ScrollBarExtent));
  this->setWidget(scroll);

  // Also emitted when another tab covers the dock.
  QObject::connect(this, &QDockWidget::visibilityChanged, this, [this](bool seen) {
    this->Seen = seen;
    this->Rewatch();
  });
  QObject::connect(&pqActiveObjects::instance(), &pqActiveObjects::viewChanged, this,
    [this](pqView*) { this->Rewatch(); });
  QTimer::singleShot(0, this, SLOT(Introduce()));
}

//------------------------------------------------------------------------------
pqRelievoPanel::~pqRelievoPanel() = default;

//------------------------------------------------------------------------------
void pqRelievoPanel::Introduce()
{
  // Open when the plugin is first loaded; later in the state of ParaView's last exit, which the
  // window has read before this dock was created.
  const QString key = "Relievo/PanelIntroduced";
  pqSettings* settings = pqApplicationCore::instance()->settings();
  auto* window = qobject_cast<QMainWindow*>(this->parentWidget());
  if (!settings->value(key, false).toBool())
  {
    settings->setValue(key, true);
    this->show();
  }
  else if (window)
  {
    window->restoreDockWidget(this);
  }
}

//------------------------------------------------------------------------------
bool pqRelievoPanel::IsWatching() const
{
  return this->Report->IsWatching();
}

//------------------------------------------------------------------------------
QString pqRelievoPanel::GetTimedStages() const
{
  QStringList names;
  for (const relievoQt::FrameReport::Stage& stage : this->Report->GetReport().Stages)
  {
    if (stage.Milliseconds >= 0.0)
    {
      names.append(stage.Name);
    }
  }
  return names.join(",");
}

//------------------------------------------------------------------------------
void pqRelievoPanel::Rewatch()
{
  pqView* view = this->Seen ? pqActiveObjects::instance().activeView() : nullptr;
  const bool known = pqRelievoViewSettings::Find(view) != nullptr;
  for (pqRelievoControls* section : this->Sections)
  {
    section->SetView(view);
  }
  this->Report->SetView(view);
  this->All->setVisible(known);
  this->Heading->setText(view ? view->getSMName() : QString());
  QString message;
  if (!view)
  {
    message = "No view is active.";
  }
  else if (!known && view->getProxy()->IsA("vtkSMComparativeViewProxy"))
  {
    message = "Comparative views have nothing of Relievo. Open a Render View for it.";
  }
  else if (!known)
  {
    message = vtkSMRenderViewProxy::SafeDownCast(view->getProxy())
      ? "This view has no Relievo settings: load the plugin on the server too (Tools > Manage "
        "Plugins)."
      : "The active view is no 3D render view.";
  }
  this->Message->setText(message);
  this->Message->setVisible(!message.isEmpty());
}
