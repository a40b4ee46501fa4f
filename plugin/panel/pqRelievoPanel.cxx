// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqRelievoPanel.h"

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqRelievoStageTable.h"
#include "pqRelievoTimesChart.h"
#include "pqRelievoViewSettings.h"
#include "pqServer.h"
#include "pqSettings.h"
#include "pqView.h"
#include "vtkCommand.h"
#include "vtkPVRelievoView.h"
#include "vtkPVRenderView.h"
#include "vtkPVSession.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSession.h"

#include <QFrame>
#include <QLabel>
#include <QMainWindow>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QStringList>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace
{
constexpr int RefreshMilliseconds = 250;
}

//------------------------------------------------------------------------------
pqRelievoPanel::pqRelievoPanel(QWidget* parent)
  : Superclass("Relievo", parent)
{
  this->setObjectName("pqRelievoPanel");
  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff); // all there is wraps
  auto* content = new QWidget(scroll);
  content->setObjectName("content");
  auto* layout = new QVBoxLayout(content);

  this->Heading = new QLabel(content);
  this->Heading->setObjectName("heading");
  this->Sun = new QToolButton(content);
  this->Sun->setObjectName("sun");
  this->Sun->setIcon(QIcon(":/relievo/sun.svg"));
  this->Sun->setText("World-fixed sun");
  this->Sun->setToolTip("A light that stays where it is when the camera moves, with its shadows");
  this->Sun->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  this->Sun->setCheckable(true);
  this->Message = new QLabel(content);
  this->Message->setObjectName("message");
  this->Message->setWordWrap(true);

  this->Table = new pqRelievoStageTable(content);
  this->Table->setObjectName("stages");
  this->Chart = new pqRelievoTimesChart(content);
  this->Chart->setObjectName("times");

  layout->addWidget(this->Heading);
  layout->addWidget(this->Sun, 0, Qt::AlignLeft);
  layout->addWidget(this->Message);
  layout->addWidget(this->Table);
  layout->addWidget(this->Chart);
  layout->addStretch(1);
  scroll->setWidget(content);
  this->setWidget(scroll);

  this->Timer.setSingleShot(true);
  QObject::connect(&this->Timer, &QTimer::timeout, this, [this] { this->Refresh(); });
  QObject::connect(this->Sun, &QToolButton::toggled, this,
    [this](bool on) { pqRelievoViewSettings::SetSun(this->View, on); });
  QObject::connect(this->Table, &pqRelievoStageTable::shadowsToggled, this,
    [this](bool on) { pqRelievoViewSettings::SetShadows(this->View, on); });
  QObject::connect(this->Table, &pqRelievoStageTable::layerChosen, this,
    [this](const QString& layer) { pqRelievoViewSettings::SetShownLayer(this->View, layer); });
  // Also sent when another tab covers the dock.
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
  // Open when the plugin is met for the first time; later as it was when ParaView was left. The
  // window has read that before this dock came.
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
QString pqRelievoPanel::GetTimedStages() const
{
  QStringList names;
  for (const pqRelievoFrameReport::Stage& stage : this->Report.Stages)
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
  this->Watch(this->Seen ? pqActiveObjects::instance().activeView() : nullptr);
}

//------------------------------------------------------------------------------
void pqRelievoPanel::Watch(pqView* view)
{
  if (this->View)
  {
    QObject::disconnect(this->View, nullptr, this, nullptr);
  }
  this->Connector->Disconnect();
  this->Timer.stop();
  this->View = view;
  this->Show(pqRelievoFrameReport());
  if (!view)
  {
    this->Tell("No view is active.");
    return;
  }
  QObject::connect(view, &pqView::endRender, this, &pqRelievoPanel::Schedule);
  if (vtkSMProxy* settings = pqRelievoViewSettings::Find(view))
  {
    this->Connector->Connect(
      settings, vtkCommand::PropertyModifiedEvent, this, SLOT(ShowToggles()));
  }
  this->ShowToggles();
  this->Refresh();
}

//------------------------------------------------------------------------------
void pqRelievoPanel::Schedule()
{
  if (!this->Timer.isActive())
  {
    const qint64 wait = RefreshMilliseconds - this->SinceRefresh.elapsed();
    this->Timer.start(static_cast<int>(std::max<qint64>(0, wait)));
  }
}

//------------------------------------------------------------------------------
QByteArray pqRelievoPanel::PullReport()
{
  vtkSMProxy* settings = pqRelievoViewSettings::Find(this->View);
  auto* view = vtkPVRenderView::SafeDownCast(this->View->getProxy()->GetClientSideObject());
  const bool inOneProcess =
    (settings->GetSession()->GetProcessRoles() & vtkPVSession::RENDER_SERVER) != 0;
  if (inOneProcess || (view && !view->GetUseDistributedRenderingForRender()))
  {
    auto* here = vtkPVRelievoView::SafeDownCast(settings->GetClientSideObject());
    return here && here->IsInPlace() ? here->GetFrameReport() : "";
  }
  if (!pqRelievoViewSettings::AreShadowsOn(this->View) &&
    pqRelievoViewSettings::GetShownLayer(this->View).isEmpty())
  {
    return QByteArray(); // the server would tell of the last picture with Relievo
  }
  settings->UpdatePropertyInformation(settings->GetProperty("FrameReport"));
  return vtkSMPropertyHelper(settings, "FrameReport").GetAsString();
}

//------------------------------------------------------------------------------
void pqRelievoPanel::Refresh()
{
  this->SinceRefresh.start();
  if (!this->View)
  {
    return;
  }
  if (!pqRelievoViewSettings::Find(this->View))
  {
    this->Show(pqRelievoFrameReport());
    this->Tell(vtkSMRenderViewProxy::SafeDownCast(this->View->getProxy())
        ? "This view does not know Relievo: load the plugin on the server too (Tools > Manage "
          "Plugins)."
        : "The active view is no 3D render view.");
    return;
  }
  if (this->View->getServer()->isProgressPending())
  {
    this->Timer.start(RefreshMilliseconds); // the server is at work for somebody else
    return;
  }
  pqRelievoFrameReport report;
  const bool drawn = report.Read(this->PullReport());
  this->Show(report);
  this->Tell(drawn ? QString() : "Neither shadows nor layers are on.");
}

//------------------------------------------------------------------------------
void pqRelievoPanel::Tell(const QString& message)
{
  const bool known = pqRelievoViewSettings::Find(this->View) != nullptr;
  this->Sun->setEnabled(known);
  this->Table->setVisible(known);
  this->Message->setText(message);
  this->Message->setVisible(!message.isEmpty());
  QString heading = this->View ? this->View->getSMName() : QString();
  if (this->Report.Width)
  {
    heading += QString(", %1 %2 %3 pixels")
                 .arg(this->Report.Width)
                 .arg(QChar(0x00d7))
                 .arg(this->Report.Height);
  }
  this->Heading->setText(heading);
}

//------------------------------------------------------------------------------
void pqRelievoPanel::ShowToggles()
{
  const QSignalBlocker quiet(this->Sun);
  this->Sun->setChecked(pqRelievoViewSettings::IsSunOn(this->View));
  this->Table->SetShadows(pqRelievoViewSettings::AreShadowsOn(this->View));
  this->Table->SetLayer(pqRelievoViewSettings::GetShownLayer(this->View),
    pqRelievoViewSettings::GetLayerNames(this->View));
}

//------------------------------------------------------------------------------
void pqRelievoPanel::Show(const pqRelievoFrameReport& report)
{
  this->Report = report;
  this->Table->SetReport(report);
  this->Chart->SetStages(report.Stages);
  // Wide enough for the widest numbers so far; reasons wrap.
  const int wide = this->Table->parentWidget()->minimumSizeHint().width() +
    this->style()->pixelMetric(QStyle::PM_ScrollBarExtent);
  this->widget()->setMinimumWidth(std::max(wide, this->widget()->minimumWidth()));
}
