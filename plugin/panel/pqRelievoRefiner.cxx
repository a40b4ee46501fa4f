// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqRelievoRefiner.h"

#include "pqApplicationCore.h"
#include "pqServerManagerModel.h"
#include "pqView.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"

#include <QApplication>
#include <QPointer>
#include <QTimer>

namespace
{
// Milliseconds between pictures: time to begin working.
constexpr int Pause = 20;

int GetInteger(vtkSMProxy* proxy, const char* property)
{
  return proxy->GetProperty(property) ? vtkSMPropertyHelper(proxy, property).GetAsInt() : 0;
}
}

//------------------------------------------------------------------------------
pqRelievoRefiner::pqRelievoRefiner(QObject* parent)
  : Superclass(parent)
{
  auto* model = pqApplicationCore::instance()->getServerManagerModel();
  for (pqView* view : model->findItems<pqView*>())
  {
    this->Watch(view);
  }
  QObject::connect(
    model, &pqServerManagerModel::viewAdded, this, [this](pqView* view) { this->Watch(view); });
}

//------------------------------------------------------------------------------
void pqRelievoRefiner::Watch(pqView* view)
{
  QObject::connect(view, &pqView::endRender, this, [this, view]() { this->Refine(view); });
}

//------------------------------------------------------------------------------
void pqRelievoRefiner::Refine(pqView* view)
{
  vtkSMProxy* proxy = view->getProxy();
  if (GetInteger(proxy, "RelievoShadowSoftSamples") <= 1 ||
    !proxy->GetProperty("RelievoSamplesLeft"))
  {
    return;
  }
  proxy->UpdatePropertyInformation(proxy->GetProperty("RelievoSamplesLeft"));
  if (GetInteger(proxy, "RelievoSamplesLeft") > 0)
  {
    const QPointer<pqView> guarded(view);
    QTimer::singleShot(Pause, this, [guarded]() {
      if (guarded && QApplication::mouseButtons() == Qt::NoButton)
      {
        guarded->render();
      }
    });
  }
}
