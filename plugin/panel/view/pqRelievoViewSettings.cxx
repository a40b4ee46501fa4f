// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqRelievoViewSettings.h"

#include "pqRelievoScene.h"
#include "pqUndoStack.h"
#include "pqView.h"
#include "vtkPVRelievoView.h"
#include "vtkPVRenderView.h"
#include "vtkPVSession.h"
#include "vtkSMDoubleVectorProperty.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRelievoViews.h"
#include "vtkSMSession.h"
#include "vtkSMStringListDomain.h"
#include "vtkSMStringVectorProperty.h"
#include "vtkSMTrace.h"
#include "vtkSMViewProxy.h"

namespace
{
// The value of DisplayLayer in view.xml that shows the picture itself.
constexpr const char* NoLayer = "None";
// Set on a view whose shadows were switched on by its sun.
constexpr const char* SunsShadows = "RelievoShadowsOfSun";
// Set on a view whose sun was on before.
constexpr const char* SunHasUp = "RelievoSunHasUp";

void Push(vtkSMProxy* proxy, const QVector<pqRelievoViewSettings::Change>& changes)
{
  for (const pqRelievoViewSettings::Change& change : changes)
  {
    vtkSMPropertyHelper property(proxy, change.first);
    const bool isDouble =
      vtkSMDoubleVectorProperty::SafeDownCast(proxy->GetProperty(change.first)) != nullptr;
    const QVariantList values = change.second.userType() == QMetaType::QVariantList
      ? change.second.toList()
      : QVariantList{ change.second };
    for (int i = 0; i < values.size(); ++i)
    {
      if (values[i].userType() == QMetaType::QString)
      {
        property.Set(i, qUtf8Printable(values[i].toString()));
      }
      else if (isDouble)
      {
        property.Set(i, values[i].toDouble());
      }
      else
      {
        property.Set(i, values[i].toInt());
      }
    }
  }
  proxy->UpdateVTKObjects();
}

int GetNumber(pqView* view, const char* name)
{
  return pqRelievoViewSettings::Get(view, name).toInt();
}
}

//------------------------------------------------------------------------------
QVariant pqRelievoViewSettings::Get(pqView* view, const char* name)
{
  vtkSMProperty* property = Find(view) ? view->getProxy()->GetProperty(name) : nullptr;
  if (!property)
  {
    return QVariant();
  }
  vtkSMPropertyHelper helper(property);
  QVariantList values;
  for (unsigned int i = 0; i < helper.GetNumberOfElements(); ++i)
  {
    values.append(vtkSMStringVectorProperty::SafeDownCast(property)
        ? QVariant(QString::fromUtf8(helper.GetAsString(i)))
        : QVariant(helper.GetAsDouble(i)));
  }
  return values.size() == 1 ? values.front() : QVariant(values);
}

//------------------------------------------------------------------------------
void pqRelievoViewSettings::Apply(
  pqView* view, const QString& label, const QVector<Change>& changes)
{
  if (!Find(view))
  {
    return;
  }
  {
    SCOPED_UNDO_SET(label);
    SM_SCOPED_TRACE(PropertiesModified).arg("proxy", view->getProxy());
    Push(view->getProxy(), changes);
  }
  view->render();
}

//------------------------------------------------------------------------------
void pqRelievoViewSettings::Try(pqView* view, const QVector<Change>& changes)
{
  if (!Find(view))
  {
    return;
  }
  SCOPED_UNDO_EXCLUDE();
  Push(view->getProxy(), changes);
  view->render();
}

//------------------------------------------------------------------------------
vtkSMProxy* pqRelievoViewSettings::Find(pqView* view)
{
  return view ? vtkSMRelievoViews::GetSettings(view->getProxy()) : nullptr;
}

//------------------------------------------------------------------------------
vtkPVRelievoView* pqRelievoViewSettings::FindHere(pqView* view)
{
  vtkSMProxy* settings = Find(view);
  return settings ? vtkPVRelievoView::SafeDownCast(settings->GetClientSideObject()) : nullptr;
}

//------------------------------------------------------------------------------
bool pqRelievoViewSettings::IsDrawnHere(pqView* view)
{
  vtkSMProxy* settings = Find(view);
  const bool inOneProcess =
    settings && (settings->GetSession()->GetProcessRoles() & vtkPVSession::RENDER_SERVER) != 0;
  auto* here =
    settings ? vtkPVRenderView::SafeDownCast(view->getProxy()->GetClientSideObject()) : nullptr;
  return inOneProcess || (here && !here->GetUseDistributedRenderingForRender());
}

//------------------------------------------------------------------------------
bool pqRelievoViewSettings::AreShadowsOn(pqView* view)
{
  return GetNumber(view, "RelievoShadows") != 0;
}

//------------------------------------------------------------------------------
bool pqRelievoViewSettings::IsSunOn(pqView* view)
{
  return GetNumber(view, "RelievoSun") != 0;
}

//------------------------------------------------------------------------------
QString pqRelievoViewSettings::GetShownLayer(pqView* view)
{
  const QString name = Get(view, "RelievoDisplayLayer").toString();
  return name == NoLayer ? QString() : name;
}

//------------------------------------------------------------------------------
QVector<QString> pqRelievoViewSettings::GetLayerNames(pqView* view)
{
  QVector<QString> names;
  vtkSMProxy* settings = pqRelievoViewSettings::Find(view);
  auto* domain =
    settings ? settings->GetProperty("DisplayLayer")->FindDomain<vtkSMStringListDomain>() : nullptr;
  for (unsigned int i = 0; domain && i < domain->GetNumberOfStrings(); ++i)
  {
    names.append(domain->GetString(i));
  }
  return names;
}

//------------------------------------------------------------------------------
void pqRelievoViewSettings::SetShadows(pqView* view, bool on)
{
  if (view)
  {
    view->setProperty(SunsShadows, false); // the user has set shadows separately
  }
  Apply(view, on ? "Shadows on" : "Shadows off", { { "RelievoShadows", on ? 1 : 0 } });
}

//------------------------------------------------------------------------------
void pqRelievoViewSettings::SetSun(pqView* view, bool on)
{
  if (!view)
  {
    return;
  }
  QVector<Change> changes = { { "RelievoSun", on ? 1 : 0 } };
  if (on && !view->property(SunHasUp).toBool())
  {
    // Later switches respect the user's later choice.
    const int up = pqRelievoScene::FindUpAxis(view);
    if (up != 2 && GetNumber(view, "RelievoSunUpAxis") == 2)
    {
      changes.append({ "RelievoSunUpAxis", up });
    }
    view->setProperty(SunHasUp, true);
  }
  const bool brings = on && !AreShadowsOn(view);
  const bool takes = !on && AreShadowsOn(view) && view->property(SunsShadows).toBool();
  if (brings || takes)
  {
    changes.append({ "RelievoShadows", on ? 1 : 0 });
  }
  view->setProperty(SunsShadows, brings); // independent of earlier changes by scripts or undo
  Apply(view, on ? "Sun on" : "Sun off", changes);
}

//------------------------------------------------------------------------------
void pqRelievoViewSettings::SetShownLayer(pqView* view, const QString& name)
{
  Apply(
    view, "Show layer", { { "RelievoDisplayLayer", name.isEmpty() ? QString(NoLayer) : name } });
}
