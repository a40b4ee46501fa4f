// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqRelievoRefiner.h"

#include "pqAnimationScene.h"
#include "pqApplicationCore.h"
#include "pqServerManagerModel.h"
#include "pqView.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"

#include <QApplication>
#include <QTimer>

#include <memory>

namespace
{
// Milliseconds between pictures, in which the user can act.
constexpr int Pause = 20;

// Consecutive pictures without a new sample.
constexpr int MostVain = 3;

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
  for (pqAnimationScene* scene : model->findItems<pqAnimationScene*>())
  {
    this->Follow(scene);
  }
  QObject::connect(model, &pqServerManagerModel::proxyAdded, this, [this](pqProxy* proxy) {
    if (auto* scene = qobject_cast<pqAnimationScene*>(proxy))
    {
      this->Follow(scene);
    }
  });
}

//------------------------------------------------------------------------------
void pqRelievoRefiner::Follow(pqAnimationScene* scene)
{
  using Signal = void (pqAnimationScene::*)(vtkObject*, unsigned long, void*, void*);
  const Signal begin = &pqAnimationScene::beginPlay;
  const Signal end = &pqAnimationScene::endPlay;
  QObject::connect(scene, begin, this, [this]() { this->Playing = true; });
  QObject::connect(scene, end, this, [this]() { this->Playing = false; });
}

//------------------------------------------------------------------------------
void pqRelievoRefiner::Watch(pqView* view)
{
  // One timer per view, deleted with it.
  auto* timer = new QTimer(view);
  timer->setSingleShot(true);
  timer->setInterval(Pause);
  const auto progress = std::make_shared<Progress>();
  QObject::connect(timer, &QTimer::timeout, this, [this, view, timer, progress]() {
    if (QApplication::activePopupWidget())
    {
      timer->start(); // a menu is open; the picture continues later
    }
    else if (QApplication::mouseButtons() == Qt::NoButton && !this->Playing)
    {
      progress->Own = true;
      view->render();
    }
  });
  QObject::connect(
    view, &pqView::endRender, timer, [view, timer, progress]() { Refine(view, timer, *progress); });
}

//------------------------------------------------------------------------------
void pqRelievoRefiner::Refine(pqView* view, QTimer* timer, Progress& progress)
{
  vtkSMProxy* proxy = view->getProxy();
  vtkSMProperty* left = proxy->GetProperty("RelievoSamplesLeft");
  int missing = 0;
  if (left && GetInteger(proxy, "RelievoShadowSoftSamples") > 1)
  {
    proxy->UpdatePropertyInformation(left);
    missing = GetInteger(proxy, "RelievoSamplesLeft");
  }
  // Pictures without new samples stop the refinement until the next change: another process draws
  // them, or the scene changes by itself.
  progress.Vain = progress.Own && missing >= progress.Missing ? progress.Vain + 1 : 0;
  progress.Missing = missing;
  progress.Own = false;
  if (missing > 0 && progress.Vain < MostVain)
  {
    timer->start();
  }
}
