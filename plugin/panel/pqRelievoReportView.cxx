// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqRelievoReportView.h"

#include "StageTable.h"
#include "TimesChart.h"
#include "pqRelievoControls.h"
#include "pqRelievoViewSettings.h"
#include "pqServer.h"
#include "pqView.h"
#include "vtkPVRelievoView.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"

#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace
{
constexpr int RefreshMilliseconds = 250;
}

//------------------------------------------------------------------------------
pqRelievoReportView::pqRelievoReportView(QWidget* parent)
  : Superclass(parent)
  , Rest(new QWidget(this))
  , Fold(pqRelievoControls::MakeFold("Cost of the last picture", Rest, this))
  , Message(new QLabel(Rest))
  , Table(new relievoQt::StageTable(relievoQt::StageTable::SHORT, Rest))
  , Chart(new relievoQt::TimesChart(Rest))
{
  this->Fold->setToolTip("Time and memory on the graphics processor, part by part");
  this->Rest->setObjectName("rest");
  this->Message->setObjectName("message");
  this->Message->setWordWrap(true);
  this->Table->setObjectName("stages");
  this->Chart->setObjectName("times");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(this->Fold, 0, Qt::AlignLeft);
  layout->addWidget(this->Rest);
  auto* parts = new QVBoxLayout(this->Rest);
  parts->setContentsMargins(0, 0, 0, 0);
  parts->addWidget(this->Message);
  parts->addWidget(this->Table);
  parts->addWidget(this->Chart);
  this->Timer.setSingleShot(true);
  QObject::connect(&this->Timer, &QTimer::timeout, this, [this] { this->Refresh(); });
  QObject::connect(this->Fold, &QToolButton::toggled, this, [this](bool) { this->Watch(); });
}

//------------------------------------------------------------------------------
void pqRelievoReportView::SetView(pqView* view)
{
  this->View = pqRelievoViewSettings::Find(view) ? view : nullptr;
  this->Watch();
}

//------------------------------------------------------------------------------
void pqRelievoReportView::Watch()
{
  if (this->Watched)
  {
    QObject::disconnect(this->Watched, nullptr, this, nullptr);
  }
  this->Timer.stop();
  this->Watched = this->Fold->isChecked() ? this->View : nullptr;
  this->Show(relievoQt::FrameReport(), QString());
  if (this->Watched)
  {
    QObject::connect(this->Watched, &pqView::endRender, this, &pqRelievoReportView::Schedule);
    this->Refresh();
  }
}

//------------------------------------------------------------------------------
void pqRelievoReportView::Schedule()
{
  if (!this->Timer.isActive())
  {
    const qint64 wait = RefreshMilliseconds - this->SinceRefresh.elapsed();
    this->Timer.start(static_cast<int>(std::max<qint64>(0, wait)));
  }
}

//------------------------------------------------------------------------------
QByteArray pqRelievoReportView::PullReport()
{
  vtkSMProxy* settings = pqRelievoViewSettings::Find(this->Watched);
  if (pqRelievoViewSettings::IsDrawnHere(this->Watched))
  {
    vtkPVRelievoView* here = pqRelievoViewSettings::FindHere(this->Watched);
    return here ? here->GetFrameReport() : "";
  }
  settings->UpdatePropertyInformation(settings->GetProperty("FrameReport"));
  return vtkSMPropertyHelper(settings, "FrameReport").GetAsString();
}

//------------------------------------------------------------------------------
void pqRelievoReportView::Refresh()
{
  this->SinceRefresh.start();
  if (!this->Watched)
  {
    return;
  }
  if (this->Watched->getServer()->isProgressPending())
  {
    this->Timer.start(RefreshMilliseconds); // the server is busy with other work
    return;
  }
  relievoQt::FrameReport report(this->PullReport());
  for (relievoQt::FrameReport::Stage& stage : report.Stages)
  {
    stage.Label = stage.IsDelegate() ? "ParaView's picture" : stage.Label;
  }
  this->Show(report, report.Stages.isEmpty() ? "Nothing of Relievo is on." : QString());
}

//------------------------------------------------------------------------------
void pqRelievoReportView::Show(const relievoQt::FrameReport& report, const QString& message)
{
  this->Report = report;
  this->Table->SetReport(report);
  this->Table->setVisible(!report.Stages.isEmpty());
  this->Chart->SetReport(report);
  this->Message->setText(message);
  this->Message->setVisible(!message.isEmpty());
}
